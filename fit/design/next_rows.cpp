#include "fit/design/next_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "fit/design/model_error.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/samples/degrees.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kHemisphere = 256;      // pairs of directions at which a model is judged
constexpr std::size_t kChannelsOfChoice = 3;  // channels that the choice looks at

using RoundedPair = std::array<long long, 6>;
RoundedPair rounded_pair(const Vec3<double>& wi, const Vec3<double>& wo) {
  const auto rounded = [](double x) { return std::llround(x * 1e7); };
  return {rounded(wi.x), rounded(wi.y), rounded(wi.z), rounded(wo.x), rounded(wo.y), rounded(wo.z)};
}

// Keeps the channels of which the choice takes account.
DesignRows of_few_channels(const DesignRows& rows) {
  if (rows.channels() <= kChannelsOfChoice) return rows;
  DesignRows out;
  out.places = rows.places;
  out.usable = rows.usable;
  for (const std::size_t c : {std::size_t(0), rows.channels() / 2, rows.channels() - 1}) {
    out.values.push_back(rows.values[c]);
    out.gradients.push_back(rows.gradients[c]);
    out.weights.push_back(rows.weights[c]);
  }
  return out;
}

// Returns ln(measured) - ln(model), [channel][row]; NaN for values that are not above 0.
std::vector<std::vector<double>> log_residuals(const FitData& data, const DesignRows& rows) {
  std::vector<std::vector<double>> out(rows.channels(), std::vector<double>(rows.rows(), kUnknown));
  for (std::size_t c = 0; c < out.size(); ++c)
    for (std::size_t k = 0; k < rows.rows(); ++k)
      if (rows.usable[k] && data.values[c][k] > 0)
        out[c][k] = std::log(data.values[c][k] / rows.values[c][k]);
  return out;
}

// Returns the median of the stated relative standard deviations, or std::nullopt without any.
std::optional<double> stated_noise(const FitData& data) {
  std::vector<double> relative;
  for (std::size_t c = 0; c < data.sigma.size(); ++c)
    for (std::size_t k = 0; k < data.rows(); ++k)
      if (data.values[c][k] > 0 && data.sigma[c][k] > 0)
        relative.push_back(data.sigma[c][k] / data.values[c][k]);
  if (relative.empty()) return std::nullopt;
  return io::median(std::move(relative));
}

}  // namespace

Reachable reachable(const io::SampleTable& reach, const FitData& start, const FitOptions& options,
                    NextDirections& out) {
  if (reach.rows() > NextOptions::kMostDirections)
    throw InputError(reach.name() + ": " + std::to_string(reach.rows()) + " directions: at most " +
                     std::to_string(NextOptions::kMostDirections) + " can be compared; use a coarser grid");
  std::set<RoundedPair> taken;
  const Directions<double> measured = start.directions(0, start.rows());
  for (std::size_t k = 0; k < start.rows(); ++k) taken.insert(rounded_pair(measured.wi(k), measured.wo(k)));
  Reachable found;
  found.data.channels = start.channels;
  out.reach = reach.rows();
  for (std::size_t k = 0; k < reach.rows(); ++k) {
    const Vec3<double> wi = io::unit_vector(reach.theta_i[k], reach.phi_i[k]),
                       wo = io::unit_vector(reach.theta_o[k], reach.phi_o[k]);
    if (reach.is_beyond(k, options.max_theta)) {
      ++out.beyond_max_theta;
    } else if (!taken.insert(rounded_pair(wi, wo)).second) {
      ++out.already_measured;
    } else {
      found.data.add_directions(wi, wo);
      found.rows.push_back(k);
    }
  }
  found.data.values.assign(start.channels.size(), std::vector<double>(found.rows.size(), 1.0));
  return found;
}

Rows rows_of(const Solved& solved, const FitData& start, const FitData& candidates,
             const FitOptions& options) {
  const FitData hemisphere = hemisphere_rows(start.channels, kHemisphere, options.max_theta);
  const double aperture = options.resolved_aperture();
  return {design_rows(start, solved, aperture), design_rows(candidates, solved, aperture),
          design_rows(hemisphere, solved, aperture)};
}

void weigh(const FitData& candidates, const FitData& start, double noise, Rows& of) {
  DesignRows& rows = of.candidates;
  for (std::size_t c = 0; c < rows.channels(); ++c)
    for (std::size_t k = 0; k < rows.rows(); ++k) {
      double& weight = rows.weights[c][k];
      if (!start.sigma.empty()) weight = weight > 0 ? 1 / (noise * noise) : 0;
      if (!start.weight.empty())
        weight *= std::hypot(candidates.wi_x[k], candidates.wi_y[k]) *
                  std::hypot(candidates.wo_x[k], candidates.wo_y[k]);
    }
}

Rows of_few_channels(const Rows& rows) {
  return {of_few_channels(rows.start), of_few_channels(rows.candidates), of_few_channels(rows.hemisphere)};
}

NoiseAndError known_of(const Prepared& p, const FitData& start, const DesignRows& rows,
                       const std::string& source, const NextOptions& next) {
  std::optional<double> noise = next.noise;
  NoiseFrom from = NoiseFrom::option;
  if (!noise) noise = stated_noise(start), from = NoiseFrom::stated;
  if (!noise) noise = p.scatter(), from = NoiseFrom::table;
  if (noise && !(*noise > 0)) noise = std::nullopt;
  NoiseAndError out = noise_and_error(rows, log_residuals(start, rows), source, noise, next.model_error);
  if (noise) out.noise_from = from;
  return out;
}

}  // namespace brdf::fit
