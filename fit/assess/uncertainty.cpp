#include <algorithm>
#include <cmath>

#include "fit/assess/assess.h"
#include "fit/assess/budget.h"
#include "fit/assess/findings.h"
#include "fit/assess/profiles.h"
#include "fit/assess/propagation.h"
#include "fit/solve/profile.h"

namespace brdf::fit {
namespace {

// Relative noise below which a profile would be one of rounding errors.
constexpr double kRoundingNoise = 1e-9;

// For estimates alone, more rows than this do not justify a pass that counts the degrees of freedom of each
// variance.
constexpr std::size_t kLeanRows = 4096;

// Returns the number of unknowns on which the values of one channel depend: its own and the shared ones.
std::size_t parameters_of_a_channel(const Model& model) {
  std::size_t count = 0;
  for (const Slot& slot : model.slots()) {
    const bool shape = slot.kind == Slot::Kind::shape;
    count += slot.kind == Slot::Kind::tangent || slot.kind == Slot::Kind::normal ||
             slot.in_group(shape ? model.group_of(0) : 0);
  }
  return count;
}

// Returns the influence of each sample's gradient on each parameter.
std::vector<std::vector<double>> influences(const std::vector<Reported>& all, const RowMatrix& inverse) {
  std::vector<std::vector<double>> out;
  for (const Reported& r : all) {
    const Eigen::VectorXd v = inverse * gradient_vector(r, inverse.rows());
    out.emplace_back(v.data(), v.data() + v.size());
  }
  return out;
}

Correlations correlations_of(const std::vector<Reported>& all, const std::vector<std::size_t>& certain,
                             const RowMatrix& covariance) {
  const Eigen::Index n = covariance.rows();
  Correlations out;
  for (std::size_t k : certain) out.names.push_back(label(all[k].estimate));
  out.matrix = Matrix(certain.size(), certain.size());
  for (std::size_t i = 0; i < certain.size(); ++i)
    for (std::size_t j = 0; j < certain.size(); ++j) {
      const double both = all[certain[i]].estimate.standard_error * all[certain[j]].estimate.standard_error;
      const double shared =
          gradient_vector(all[certain[i]], n).dot(covariance * gradient_vector(all[certain[j]], n));
      out.matrix(i, j) = i == j ? 1 : both > 0 ? std::clamp(shared / both, -1.0, 1.0) : 0;
    }
  return out;
}

// Returns the coefficients of every shape that is smooth over wavelength, with their standard errors.
std::vector<SmoothCurve> smooth_curves(const Model& model, std::span<const double> p,
                                       const RowMatrix& covariance) {
  std::vector<SmoothCurve> out;
  if (!model.smooth()) return out;
  const Matrix by_node = model.smooth()->coefficients();
  for (std::size_t s = 0; s < model.shape_slots(); ++s) {
    const Slot& slot = model.slots()[s];
    if (slot.nodes == 1 || slot.node > 0) continue;
    SmoothCurve& curve = out.emplace_back(SmoothCurve{slot.name, std::string(name_of(slot.scale)), {}, {}});
    for (std::size_t power = 0; power < slot.nodes; ++power) {
      Eigen::VectorXd slope = Eigen::VectorXd::Zero(covariance.rows());
      double value = 0;
      for (std::size_t k = 0; k < slot.nodes; ++k) {
        value += by_node(power, k) * p[s + k];
        slope(Eigen::Index(s + k)) = by_node(power, k);
      }
      curve.coefficients.push_back(value);
      curve.standard_errors.push_back(std::sqrt(std::max(slope.dot(covariance * slope), 0.0)));
    }
  }
  return out;
}

double least_trust(const std::vector<Reported>& all) {
  double least = 1;
  for (const Reported& r : all)
    if (!std::isnan(r.estimate.deciding)) least = std::min(least, trust_in(r.estimate.deciding));
  return least;
}

}  // namespace

Uncertainty uncertainty(const SampleStream& stream, const Minimum& m, Detail detail,
                        const KnownMatrices* known, const ProfileOptions& profiles) {
  const Model& model = stream.model();
  Uncertainty out;
  std::vector<Reported> all = reported_parameters(model, m.p);
  const Curvature c = curvature(stream, m, known);
  out.condition = c.condition;
  const bool many = stream.data().rows() > kManyRows, lean = detail == Detail::estimates;
  const bool unshared = many || (lean && stream.data().rows() > kLeanRows);
  // With fewer than three rows for each parameter of a channel, no error can be estimated for any of them.
  const std::size_t per_channel = parameters_of_a_channel(model);
  const bool few = stream.data().rows() < 3 * per_channel;
  if (few) {
    out.singular = true;
    out.findings.push_back(std::to_string(stream.data().rows()) + " rows are too few for " +
                           std::to_string(per_channel) + " parameters: measure at least " +
                           std::to_string(3 * per_channel) + ", or fix some parameters");
  }
  const bool unturned =
      std::ranges::any_of(all, [&](const Reported& r) { return asks_for_turn(r, model); }) &&
      !sample_was_turned(stream.data());
  std::optional<WorkingNoise> working;
  if (!lean && !many && !few) working = working_noise(stream, m, c);
  // The channels of a row may share their noise, so every channel has the degrees of freedom of its own
  // rows.
  const double freedom = double(stream.data().rows()) - double(per_channel);
  const Grounds on{model,   m,
                   c,       working ? &working->covariance : nullptr,
                   freedom, working && working->relative < kRoundingNoise,
                   few,     unturned};
  if (!unshared) {
    const std::vector<NoiseShares> shares = stream.noise_shares(m.p, influences(all, c.inverse));
    for (std::size_t k = 0; k < all.size(); ++k)
      if (shares[k].any() && !all[k].gradient.empty()) all[k].estimate.deciding = shares[k].freedom();
  }
  for (Reported& r : all) {
    judge_parameter(r, on, out);
    // Without the working noise, only the deciding values contribute to the variance.
    Estimate& e = r.estimate;
    if (lean && e.status == Status::free && e.deciding < freedom) e.freedom = e.deciding;
  }
  if (detail == Detail::profiles && !many) profile_all(all, stream, on, profiles, out);
  std::optional<RowMatrix> scatter;
  const double trust = least_trust(all);
  if (!lean) scatter = working ? larger_of(working->covariance, c.covariance, trust) : c.covariance;
  std::optional<InstrumentCovariance> instrument;
  if (!lean && !few && stream.data().budget) {
    instrument = instrument_covariance(stream, m.p, c.inverse, *scatter, freedom);
    for (Reported& r : all) add_budget(*instrument, model, r);
  }
  const RowMatrix& total = instrument ? instrument->total : c.covariance;
  const auto unidentified = [](const Reported& r) { return r.estimate.status == Status::unidentified; };
  const bool any_unidentified = std::ranges::any_of(all, unidentified);
  if (!lean) {
    std::vector<std::size_t> certain;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k].estimate.status == Status::free) certain.push_back(k);
    out.correlations = correlations_of(all, certain, total);
    out.smooth = smooth_curves(model, m.p, total);
    // The curvature has no meaning for parameters that profiles show to be unknown.
    const bool bent = out.profiled && any_unidentified;
    if (c.null_space.cols() == 0 && !few && !bent)
      out.covariance = parameter_covariance(
          stream, m.p, all, {instrument ? instrument->rowwise : *scatter, c.inverse, working && trust == 0},
          freedom,
          instrument ? std::span<const SourceCovariance>(instrument->sources)
                     : std::span<const SourceCovariance>());
  }
  if (lean)
    out.predictable = any_unidentified && predicts_within(kDetermined, stream, m.p, c.covariance);
  else if (!many || any_unidentified)
    out.prediction_error = prediction_error(stream, m.p, total);
  if (out.prediction_error) out.predictable = *out.prediction_error <= kDetermined;
  out.split_only = !few && any_unidentified && std::ranges::all_of(all, [&](const Reported& r) {
    return !unidentified(r) || (r.weight && !r.moves_shapes);
  });
  out.sum_at_bound = !model.bounded_sum(m.p).at_bound.empty();
  if (!lean) {
    if (!few && any_unidentified) out.findings.push_back(unidentified_finding(all, on, out));
    add_bound_findings(all, on, out);
    if (!few) out.few_rows_decide = few_rows_finding(all, on, stream);
  }
  if (instrument) out.budget = std::move(instrument->rows);
  for (Reported& r : all) out.estimates.push_back(std::move(r.estimate));
  return out;
}

}  // namespace brdf::fit
