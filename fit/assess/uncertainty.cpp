#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "fit/assess/assess.h"
#include "fit/assess/derived.h"
#include "fit/assess/propagation.h"
#include "fit/assess/reported.h"
#include "fit/assess/smooth_curves.h"
#include "fit/assess/student.h"
#include "io/numbers.h"
#include "io/text.h"

namespace brdf::fit {
namespace {

// Eigenvalues of the scaled normal matrix below this share of the largest are directions without effect.
constexpr double kSingular = 1e-12;
// A parameter whose direction lies in such a subspace by more than this share is not identified.
constexpr double kInNullSpace = 1e-3;
// A standard error above these is no information: e on a logarithmic scale, half of the range on others, a
// quarter for f0, half of the channel's weights for a weight.
constexpr double kLogError = 1, kRangeError = 0.5, kFresnelError = 0.25, kWeightError = 0.5;

// Of estimates alone no more rows are worth a pass that counts the degrees of freedom of each variance.
constexpr std::size_t kLeanRows = 4096;

constexpr const char* kNeverTurned =
    "the sample was never turned (no two azimuths of it were measured under the same angles), so that a "
    "second width "
    "may be the form's own error: turn the sample, or fit without --anisotropic";

// Covariance of the solver's free parameters, and the directions without effect.
struct Covariance {
  RowMatrix matrix;       // of all slots; 0 for those held
  RowMatrix inverse;      // of the normal matrix, likewise
  RowMatrix null_space;   // columns, on the scaled axes
  Eigen::VectorXd scale;  // of the axes: 1/sqrt(diagonal); 0 for slots without effect
  RowMatrix weakest;      // the least certain direction, on the scaled axes
  double condition = 1;
};

Covariance covariance(const SampleStream& stream, const Minimum& m, const KnownMatrices* known) {
  const Model& model = stream.model();
  const Eigen::Index n = Eigen::Index(model.size());
  // Of many rows no leverage is worth a second pass.
  const bool many = stream.data().rows() > kManyRows;
  ScoreMatrices scores =
      many ? stream.scores(m.p) : ScoreMatrices{known ? known->bread : stream.bread(m.p), {}};
  const Eigen::Map<const RowMatrix> bread(scores.bread.a.data(), n, n);
  Covariance out;
  out.scale = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Index> free;
  for (Eigen::Index k = 0; k < n; ++k)
    if (m.at_bound[std::size_t(k)] == 0 && bread(k, k) > 0) {
      free.push_back(k);
      out.scale(k) = 1 / std::sqrt(bread(k, k));
    }
  const Eigen::Index f = Eigen::Index(free.size());
  out.matrix = out.inverse = RowMatrix::Zero(n, n);
  out.null_space = RowMatrix::Zero(n, f);
  out.weakest = RowMatrix::Zero(n, 1);
  if (f == 0) return out;
  RowMatrix scaled(f, f);
  for (Eigen::Index i = 0; i < f; ++i)
    for (Eigen::Index j = 0; j < f; ++j) {
      const double s = out.scale(free[std::size_t(i)]) * out.scale(free[std::size_t(j)]);
      scaled(i, j) = bread(free[std::size_t(i)], free[std::size_t(j)]) * s;
    }
  const Eigen::SelfAdjointEigenSolver<RowMatrix> eigen(scaled);
  const double largest = eigen.eigenvalues()(f - 1);
  RowMatrix inverse = RowMatrix::Zero(f, f);
  Eigen::Index nulls = 0;
  for (Eigen::Index k = 0; k < f; ++k) {
    const auto v = eigen.eigenvectors().col(k);
    if (eigen.eigenvalues()(k) <= kSingular * largest) {
      for (Eigen::Index i = 0; i < f; ++i) out.null_space(free[std::size_t(i)], nulls) = v(i);
      ++nulls;
    } else {
      inverse += v * v.transpose() / eigen.eigenvalues()(k);
    }
  }
  for (Eigen::Index i = 0; i < f; ++i) out.weakest(free[std::size_t(i)], 0) = eigen.eigenvectors()(i, 0);
  out.null_space.conservativeResize(n, nulls);
  out.condition = std::sqrt(largest / std::max(eigen.eigenvalues()(0), largest * 1e-32));
  // Back on the solver's scale; then the scores with every residual freed of its own influence.
  const auto unscaled = [&](Eigen::Index i, Eigen::Index j) {
    return inverse(i, j) * out.scale(free[std::size_t(i)]) * out.scale(free[std::size_t(j)]);
  };
  Matrix influence{model.size(), model.size()};
  for (Eigen::Index i = 0; i < f; ++i)
    for (Eigen::Index j = 0; j < f; ++j)
      influence(std::size_t(free[std::size_t(i)]), std::size_t(free[std::size_t(j)])) = unscaled(i, j);
  const Eigen::Map<const RowMatrix> c(influence.a.data(), n, n);
  Matrix freed = std::move(scores.meat);
  if (!many) {
    const Matrix noise = known ? known->expected_meat : stream.expected_meat(m.p);
    Matrix expected{model.size(), model.size()};
    Eigen::Map<RowMatrix>(expected.a.data(), n, n) =
        c * Eigen::Map<const RowMatrix>(noise.a.data(), n, n) * c;
    freed = stream.meat(m.p, influence, &expected);
  }
  const Eigen::Map<const RowMatrix> meat(freed.a.data(), n, n);
  out.inverse = c;
  out.matrix = c * meat * c;
  return out;
}

// True where the parameter moves along a direction that changes nothing in the samples.
bool without_effect(const Reported& r, const Minimum& m, const Covariance& c) {
  double inside = 0, all = 0;
  for (const auto& [slot, slope] : r.gradient) {
    if (m.at_bound[slot] != 0) continue;
    const double scale = c.scale(Eigen::Index(slot));
    if (scale == 0) return true;
    all += slope * slope * scale * scale;
  }
  for (Eigen::Index k = 0; k < c.null_space.cols(); ++k) {
    double along = 0;
    for (const auto& [slot, slope] : r.gradient)
      along += slope * c.scale(Eigen::Index(slot)) * c.null_space(Eigen::Index(slot), k);
    inside += along * along;
  }
  return all > 0 && inside > kInNullSpace * all;
}

bool at_bound(const Reported& r, const Minimum& m) {
  if (r.gradient.empty()) return false;
  bool all = true, any = false;
  for (const auto& [slot, slope] : r.gradient) {
    all = all && m.at_bound[slot] != 0;
    any = any || m.at_bound[slot] != 0;
  }
  const double v = r.estimate.value, reach = 1e-9 * (r.max - r.min);
  return all || (any && (v <= r.min + reach || v >= r.max - reach));
}

bool no_information(const Reported& r, const Model& model, double error, double solver_error) {
  if (r.divided) return error > kFresnelError;
  if (r.weight) return error > kWeightError * std::max(std::abs(r.estimate.value), r.weight_scale);
  const Slot& slot = model.slots()[r.scale != kNoSlot ? r.scale : r.slot];
  if (slot.kind == Slot::Kind::tangent) return error > 22.5;
  if (slot.scale == Scale::log || slot.scale == Scale::log1p) return solver_error > kLogError;
  return error > kRangeError * (r.max - r.min);
}

// A standard error on the solver's scale; that of the value where it has none.
double error_on_scale(const Reported& r, const Model& model, const Covariance& c, double error) {
  if (r.slot != kNoSlot)
    return std::sqrt(std::max(c.matrix(Eigen::Index(r.slot), Eigen::Index(r.slot)), 0.0));
  if (r.scale == kNoSlot) return error;
  const Slot& slot = model.slots()[r.scale];
  return error / slot.slope(slot.to_solver(r.estimate.value));
}

// A second width, or the direction of the first: what only a turn of the sample shows.
bool asks_for_turn(const Reported& r, const Model& model) {
  if (r.scale != kNoSlot ? model.slots()[r.scale].members.size() > 1 : r.slot == kNoSlot) return false;
  return r.info == &kTangentInfo || r.info->role == Role::width_across ||
         r.info->role == Role::exponent_across;
}

// The unknowns that one channel's values depend on: its own, and those that it shares.
std::size_t parameters_of_a_channel(const Model& model) {
  std::size_t count = 0;
  for (const Slot& slot : model.slots()) {
    const bool shape = slot.kind == Slot::Kind::shape;
    count += slot.kind == Slot::Kind::tangent || slot.kind == Slot::Kind::normal ||
             slot.in_group(shape ? model.group_of(0) : 0);
  }
  return count;
}

// How much each of the samples' gradients moves each parameter.
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

// What is not identified, and what would tell it.
std::string unidentified_finding(const std::vector<Reported>& all, const Model& model, const Uncertainty& u,
                                 bool unturned) {
  const auto names = names_with(all, Status::unidentified, model.channels().size());
  const std::string reason = unturned ? kNeverTurned : advice(all, model);
  if (u.determined())
    return "what the model gives at the samples is determined (standard error " +
           io::percent(*u.prediction_error) + "), how it divides into " + listed(names) +
           " is not: " + reason;
  return listed(names) + (names.size() > 1 ? " are" : " is") + " not identified: " + reason;
}

void add_bound_findings(const std::vector<Reported>& all, const Model& model, const Minimum& m,
                        Uncertainty& out) {
  const std::size_t channels = model.channels().size();
  std::map<std::string, std::vector<std::string>> bounds;
  for (const Reported& r : all) {
    if (r.estimate.status != Status::at_bound) continue;
    const bool lower = r.estimate.value - r.min <= r.max - r.estimate.value;
    bounds[r.estimate.name + " is at its " + (lower ? "lower" : "upper") + " bound " +
           io::to_text(lower ? r.min : r.max)]
        .push_back(r.estimate.channel);
  }
  for (const auto& [text, list] : bounds) {
    const bool some = !list[0].empty() && list.size() < channels;
    out.findings.push_back(text + (some ? " in " + io::joined(list) : ""));
  }
  if (const NaturalWeights::Sum sum = model.bounded_sum(m.p); !sum.at_bound.empty()) {
    std::vector<std::string> where;
    for (const std::size_t channel : sum.at_bound) where.push_back(model.channels()[channel]);
    out.findings.push_back(sum.name + " is at its bound 1" +
                           (where.size() < channels ? " in " + io::joined(where) : "") + " (--physical)");
  }
}

}  // namespace

Uncertainty uncertainty(const SampleStream& stream, const Minimum& m, Detail detail,
                        const KnownMatrices* known) {
  const Model& model = stream.model();
  const Eigen::Index n = Eigen::Index(model.size());
  Uncertainty out;
  std::vector<Reported> all = reported_parameters(model, m.p);
  const Covariance c = covariance(stream, m, known);
  out.condition = c.condition;
  double free = 0;
  for (int b : m.at_bound) free += b == 0;
  const double freedom = double(stream.data().rows()) - free;
  // Where a few values decide a parameter, its variance is known from those few only.
  const bool many = stream.data().rows() > kManyRows, lean = detail == Detail::estimates;
  const bool unshared = many || (lean && stream.data().rows() > kLeanRows);
  const std::vector<NoiseShares> shares =
      unshared ? std::vector<NoiseShares>(all.size()) : stream.noise_shares(m.p, influences(all, c.inverse));
  // Fewer rows than three for each parameter of a channel say nothing about the errors of any of them.
  const std::size_t per_channel = parameters_of_a_channel(model);
  const bool few = stream.data().rows() < 3 * per_channel;
  if (few) {
    out.singular = true;
    out.findings.push_back(std::to_string(stream.data().rows()) + " rows are too few for " +
                           std::to_string(per_channel) + " parameters: measure at least " +
                           std::to_string(3 * per_channel) + ", or fix some of them");
  }
  const bool unturned =
      std::any_of(all.begin(), all.end(), [&](const Reported& r) { return asks_for_turn(r, model); }) &&
      !sample_was_turned(stream.data());
  std::vector<std::size_t> certain;
  for (std::size_t k = 0; k < all.size(); ++k) {
    Reported& r = all[k];
    Estimate& e = r.estimate;
    const Eigen::VectorXd g = gradient_vector(r, n);
    const double variance = g.dot(c.matrix * g);
    const double error = std::sqrt(std::max(variance, 0.0));
    const double solver_error = error_on_scale(r, model, c, error);
    if (r.without_lobe) {
      e.status = Status::unidentified;
    } else if (r.gradient.empty()) {
      e.status = Status::fixed;
    } else if (few) {
      e.status = Status::unidentified;
    } else if (unturned && asks_for_turn(r, model)) {
      e.status = Status::unidentified;
      out.singular = true;
    } else if (at_bound(r, m)) {
      e.status = Status::at_bound;
    } else if (without_effect(r, m, c)) {
      e.status = Status::unidentified;
      out.singular = true;
    } else if (no_information(r, model, error, solver_error)) {
      e.status = Status::unidentified;
    } else {
      e.standard_error = error;
      e.freedom = shares[k].any() ? std::min(freedom, shares[k].freedom()) : freedom;
      certain.push_back(k);
      if (lean) continue;
      const double t = std::max(t_quantile(freedom), t_quantile(shares[k]));
      const Extent interval = extent_of(r, model, m.p, t * (r.scale != kNoSlot ? solver_error : error));
      e.low = interval.low;
      e.high = interval.high;
    }
  }
  if (!lean) {
    out.correlations = correlations_of(all, certain, c.matrix);
    out.smooth = smooth_curves(model, m.p, c.matrix);
  }

  if (!lean && c.null_space.cols() == 0 && !few)
    out.covariance = parameter_covariance(stream, m.p, all, {c.matrix, c.inverse}, freedom);
  const auto unidentified = [](const Reported& r) { return r.estimate.status == Status::unidentified; };
  const bool any_unidentified = std::any_of(all.begin(), all.end(), unidentified);
  if (lean)
    out.predictable = any_unidentified && predicts_within(kDetermined, stream, m.p, c.matrix);
  else if (!many || any_unidentified)
    out.prediction_error = prediction_error(stream, m.p, c.matrix);
  if (out.prediction_error) out.predictable = *out.prediction_error <= kDetermined;
  out.split_only = !few && any_unidentified && std::all_of(all.begin(), all.end(), [&](const Reported& r) {
    return r.weight || !unidentified(r);
  });
  out.sum_at_bound = !model.bounded_sum(m.p).at_bound.empty();
  if (!lean) {
    if (!few && any_unidentified) out.findings.push_back(unidentified_finding(all, model, out, unturned));
    add_bound_findings(all, model, m, out);
  }
  for (Reported& r : all) out.estimates.push_back(std::move(r.estimate));
  return out;
}

}  // namespace brdf::fit
