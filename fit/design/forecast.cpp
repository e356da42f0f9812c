#include "fit/design/forecast.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "fit/assess/propagation.h"
#include "fit/assess/reported.h"

namespace brdf::fit {

Forecast::Forecast(const Solved& solved, const DesignRows& start, double repeats,
                   const DesignRows& candidates, const DesignRows& hemisphere, const NoiseAndError& known)
    : solved_(solved),
      start_(start),
      candidates_(candidates),
      hemisphere_(hemisphere),
      repeats_(repeats),
      known_(known),
      prior_(prior_information(hemisphere)) {}

std::vector<Forecast::Row> Forecast::rows_with(std::span<const std::size_t> added) const {
  std::vector<Row> out;
  for (std::size_t k = 0; k < start_.rows(); ++k)
    if (start_.usable[k]) out.push_back({&start_, k, repeats_});
  for (const std::size_t k : added) out.push_back({&candidates_, k, 1});
  return out;
}

Forecast::Normal Forecast::normal_of(const std::vector<Row>& rows) const {
  RowMatrix normal = RowMatrix::Zero(prior_.size(), prior_.size());
  double mean = 0;
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.of->channels(); ++c) {
      const Eigen::VectorXd g = row.of->gradients[c].row(Eigen::Index(row.number));
      const double weight = row.of->weights[c][row.number] * row.repeats;
      normal += weight * g * g.transpose();
      mean += weight / row.repeats / double(rows.size() * row.of->channels());
    }
  normal += mean * square(known_.noise) * RowMatrix(prior_.asDiagonal());
  return {normal.inverse(), mean};
}

std::vector<ExpectedWidth> Forecast::widths(std::span<const std::size_t> added) const {
  const std::vector<Row> rows = rows_with(added);
  const Normal normal = normal_of(rows);
  const RowMatrix& inverse = normal.inverse;
  RowMatrix scatter = RowMatrix::Zero(inverse.rows(), inverse.cols());
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.of->channels(); ++c) {
      const Eigen::VectorXd g = row.of->gradients[c].row(Eigen::Index(row.number));
      scatter += square(row.of->weights[c][row.number]) * row.repeats * g * g.transpose();
    }
  const RowMatrix covariance = known_.noise * known_.noise * inverse * scatter * inverse;
  std::vector<ExpectedWidth> out;
  std::set<std::size_t> slots;
  for (const Reported& r : reported_parameters(solved_.model, solved_.p)) {
    if (r.gradient.empty()) continue;                                 // held
    if (r.slot != kNoSlot && !slots.insert(r.slot).second) continue;  // tied to an earlier one
    const Eigen::VectorXd g = gradient_vector(r, covariance.rows());
    const double error = std::sqrt(std::max(g.dot(covariance * g), 0.0));
    // Along directions that the rows do not determine, the covariance of the noise is small and that of the
    // prior is not.
    const double with_prior = known_.noise * std::sqrt(normal.weight * std::max(g.dot(inverse * g), 0.0));
    const double slope = r.slot == kNoSlot ? 1 : std::abs(g(Eigen::Index(r.slot)));
    const bool has_slot = r.slot != kNoSlot;
    out.push_back({has_slot ? solved_.model.slots()[r.slot].name : r.estimate.name,
                   has_slot ? "" : r.estimate.channel, r.estimate.value, error,
                   slope > 0 && !says_nothing(r, solved_.model, with_prior / slope)});
  }
  return out;
}

double Forecast::prediction_error(std::span<const std::size_t> added) const {
  const std::vector<Row> rows = rows_with(added);
  const RowMatrix inverse = normal_of(rows).inverse;
  const auto n = Eigen::Index(rows.size()), size = inverse.rows();
  const double noise = square(known_.noise), error = square(known_.error);
  RowMatrix among = RowMatrix::Zero(n, n), across = RowMatrix::Zero(n, Eigen::Index(hemisphere_.rows()));
  if (error > 0)
    for (Eigen::Index i = 0; i < n; ++i) {
      const Place& own = rows[std::size_t(i)].of->places[rows[std::size_t(i)].number];
      for (Eigen::Index j = 0; j < n; ++j)
        among(i, j) = error * correlation(own, rows[std::size_t(j)].of->places[rows[std::size_t(j)].number]);
      for (Eigen::Index j = 0; j < across.cols(); ++j)
        across(i, j) = error * correlation(own, hemisphere_.places[std::size_t(j)]);
    }
  for (Eigen::Index i = 0; i < n; ++i) among(i, i) += noise / rows[std::size_t(i)].repeats;
  const std::size_t channels = hemisphere_.channels();
  RowMatrix scatter = RowMatrix::Zero(size, size);
  std::vector<RowMatrix> pulls;  // [channel]: how an error of each row moves the parameters
  for (std::size_t c = 0; c < channels; ++c) {
    RowMatrix pull(n, size);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Row& row = rows[std::size_t(i)];
      pull.row(i) =
          row.of->weights[c][row.number] * row.repeats * row.of->gradients[c].row(Eigen::Index(row.number));
    }
    pull = pull * inverse;
    scatter += pull.transpose() * among * pull;
    pulls.push_back(std::move(pull));
  }
  double sum = error * double(hemisphere_.rows() * channels);
  for (std::size_t c = 0; c < channels; ++c) {
    const RowMatrix& g = hemisphere_.gradients[c];
    sum += (g * scatter).cwiseProduct(g).sum();
    if (error > 0) sum -= 2 * (pulls[c] * g.transpose()).cwiseProduct(across).sum();
  }
  return std::sqrt(std::max(sum, 0.0) / double(hemisphere_.rows() * channels));
}

}  // namespace brdf::fit
