#include "fit/design/design_rows.h"

#include <algorithm>
#include <cmath>

#include "brdf/angle.h"
#include "brdf/low_discrepancy.h"
#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

constexpr double kCorrelationLength = 0.35;
// Values below this share of the median are too dark for a relative error to have a meaning.
constexpr double kDark = 1e-6;

// Returns the direction with a polar angle of which the squared sine is `share` of the steepest one's.
Vec3<double> direction_at(double share, double steepest, double turn) {
  const double sine = std::sin(degrees(steepest).radians()) * std::sqrt(share), phi = 2 * kPi * turn;
  return {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(std::max(1 - sine * sine, 0.0))};
}

// Marks the rows at which the model has a value above 0 in every channel.
std::vector<bool> bright(const std::vector<std::vector<double>>& values) {
  std::vector<bool> out(values.empty() ? 0 : values.front().size(), true);
  for (const std::vector<double>& column : values) {
    const double least = kDark * std::max(io::median(column), 0.0);
    for (std::size_t k = 0; k < column.size(); ++k)
      out[k] = out[k] && std::isfinite(column[k]) && column[k] > least;
  }
  return out;
}

}  // namespace

Place place_of(const Vec3<double>& wi, const Vec3<double>& wo) {
  const double i = 1 - wi.z, o = 1 - wo.z;  // the squares of r
  const double along = (wi.x * wo.x + wi.y * wo.y) / std::sqrt((1 + wi.z) * (1 + wo.z));
  return {i + o, 2 * along, std::abs(i - o)};
}

double correlation(const Place& a, const Place& b) {
  double distance = 0;
  for (std::size_t k = 0; k < a.size(); ++k) distance += square(a[k] - b[k]);
  return std::exp(-distance / (2 * kCorrelationLength * kCorrelationLength));
}

DesignRows design_rows(const FitData& data, const Solved& solved, double aperture) {
  const SampleStream stream(data, solved.model, solved.residual, aperture);
  ValueGradients found = stream.value_gradients(solved.p);
  const std::vector<std::vector<double>> slopes = stream.slopes_of(found.values);
  DesignRows out;
  for (std::size_t k = 0; k < data.rows(); ++k) {
    const Directions<double> at = data.directions(k, 1);
    out.places.push_back(place_of(at.wi(0), at.wo(0)));
  }
  out.usable = bright(found.values);
  for (std::size_t c = 0; c < found.values.size(); ++c) {
    RowMatrix gradients = view_of(found.gradients[c]);
    std::vector<double> weights(data.rows());
    for (std::size_t k = 0; k < data.rows(); ++k) {
      const double f = found.values[c][k], weight = square(f * slopes[c][k]);
      const bool counts = out.usable[k] && std::isfinite(weight);
      if (counts)
        gradients.row(Eigen::Index(k)) /= f;
      else
        gradients.row(Eigen::Index(k)).setZero();
      weights[k] = counts ? weight : 0;
    }
    out.gradients.push_back(std::move(gradients));
    out.weights.push_back(std::move(weights));
  }
  out.values = std::move(found.values);
  return out;
}

FitData hemisphere_rows(const std::vector<std::string>& channels, std::size_t count, double steepest) {
  constexpr std::array kSteps = additive_recurrence_steps<4>();
  FitData data;
  data.channels = channels;
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = [&](std::size_t j) { return additive_recurrence(0.5, kSteps[j], k); };
    data.add_directions(direction_at(at(0), steepest, at(2)), direction_at(at(1), steepest, at(3)));
  }
  data.values.assign(channels.size(), std::vector<double>(count, 1.0));
  return data;
}

Eigen::VectorXd prior_information(const DesignRows& hemisphere) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(hemisphere.parameters());
  for (const RowMatrix& gradients : hemisphere.gradients)
    out += gradients.colwise().squaredNorm().transpose() / double(hemisphere.rows());
  for (Eigen::Index k = 0; k < out.size(); ++k)
    if (!(out(k) > 0)) out(k) = 1;
  return out;
}

}  // namespace brdf::fit
