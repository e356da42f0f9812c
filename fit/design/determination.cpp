#include "fit/design/determination.h"

#include <cmath>

namespace brdf::fit {
namespace {

// Adds the rows of one direction, each channel times a function of its weight.
void add_reading(const DesignRows& rows, std::size_t k, double repeats, RowMatrix& normal,
                 RowMatrix& scatter) {
  for (std::size_t c = 0; c < rows.channels(); ++c) {
    const Eigen::VectorXd g = rows.gradients[c].row(Eigen::Index(k));
    const double weight = rows.weights[c][k];
    normal += repeats * weight * g * g.transpose();
    scatter += repeats * weight * weight * g * g.transpose();
  }
}

// Returns the gradients at a row, one line for each channel, times the root of its weight, or the weight.
RowMatrix weighted_row(const DesignRows& rows, std::size_t k, bool root) {
  RowMatrix out(Eigen::Index(rows.channels()), rows.parameters());
  for (std::size_t c = 0; c < rows.channels(); ++c) {
    const double weight = rows.weights[c][k];
    out.row(Eigen::Index(c)) = (root ? std::sqrt(weight) : weight) * rows.gradients[c].row(Eigen::Index(k));
  }
  return out;
}

// Returns ln det(1 + g inverse g').
double log_growth(const RowMatrix& g, const RowMatrix& inverse) {
  RowMatrix of_reading = g * inverse * g.transpose();
  of_reading.diagonal().array() += 1;
  return std::log(of_reading.determinant());
}

}  // namespace

Determination::Determination(const DesignRows& start, double repeats, const DesignRows& candidates,
                             const DesignRows& hemisphere, double noise)
    : candidates_(candidates),
      normal_(RowMatrix::Zero(start.parameters(), start.parameters())),
      scatter_(normal_) {
  double mean = 0;
  for (std::size_t k = 0; k < start.rows(); ++k) {
    add_reading(start, k, repeats, normal_, scatter_);
    for (std::size_t c = 0; c < start.channels(); ++c)
      mean += start.weights[c][k] / double(start.rows() * start.channels());
  }
  const Eigen::VectorXd prior = noise * noise * prior_information(hemisphere);
  normal_ += mean * RowMatrix(prior.asDiagonal());
  scatter_ += mean * mean * RowMatrix(prior.asDiagonal());
}

std::vector<double> Determination::falls() const {
  const RowMatrix inverse = normal_.inverse(), of_scatter = scatter_.inverse();
  std::vector<double> out(candidates_.rows(), 0.0);
  for (std::size_t k = 0; k < out.size(); ++k)
    if (candidates_.usable[k])
      out[k] = 2 * log_growth(weighted_row(candidates_, k, true), inverse) -
               log_growth(weighted_row(candidates_, k, false), of_scatter);
  return out;
}

void Determination::read(std::size_t candidate) {
  add_reading(candidates_, candidate, 1, normal_, scatter_);
}

}  // namespace brdf::fit
