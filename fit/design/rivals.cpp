#include "fit/design/rivals.h"

#include <cmath>

namespace brdf::fit {
namespace {

RowMatrix information_of(const DesignRows& start, const DesignRows& hemisphere, double noise) {
  RowMatrix out = prior_information(hemisphere).asDiagonal();
  for (const RowMatrix& g : start.gradients) out += g.transpose() * g / (noise * noise);
  return out;
}

std::vector<Eigen::VectorXd> differences(const DesignRows& truth, const DesignRows& other) {
  std::vector<Eigen::VectorXd> out;
  for (std::size_t c = 0; c < truth.channels(); ++c) {
    Eigen::VectorXd d = Eigen::VectorXd::Zero(Eigen::Index(truth.rows()));
    for (std::size_t k = 0; k < truth.rows(); ++k)
      if (truth.usable[k] && other.usable[k])
        d(Eigen::Index(k)) = std::log(truth.values[c][k] / other.values[c][k]);
    out.push_back(std::move(d));
  }
  return out;
}

// Returns the gradients of all channels at a row, one line for each channel.
RowMatrix at_row(const DesignRows& rows, std::size_t k) {
  RowMatrix out(Eigen::Index(rows.channels()), rows.parameters());
  for (std::size_t c = 0; c < rows.channels(); ++c)
    out.row(Eigen::Index(c)) = rows.gradients[c].row(Eigen::Index(k));
  return out;
}

}  // namespace

Rivals::Rivals(const DesignRows& start_a, const DesignRows& candidates_a, const DesignRows& hemisphere_a,
               const DesignRows& start_b, const DesignRows& candidates_b, const DesignRows& hemisphere_b,
               double noise)
    : noise_variance_(noise * noise),
      models_{Refitted{&candidates_a, information_of(start_a, hemisphere_a, noise),
                       differences(candidates_b, candidates_a)},
              Refitted{&candidates_b, information_of(start_b, hemisphere_b, noise),
                       differences(candidates_a, candidates_b)}} {}

std::vector<double> Rivals::gains() const {
  std::vector<double> out(models_[0].candidates->rows(), 0.0);
  for (const Refitted& m : models_) {
    const RowMatrix inverse = m.information.inverse();
    for (std::size_t k = 0; k < out.size(); ++k) {
      const RowMatrix g = at_row(*m.candidates, k);
      RowMatrix variance = g * inverse * g.transpose();
      variance.diagonal().array() += noise_variance_;
      Eigen::VectorXd d(g.rows());
      for (Eigen::Index c = 0; c < d.size(); ++c) d(c) = m.difference[std::size_t(c)](Eigen::Index(k));
      out[k] += 0.5 * 0.5 * d.dot(variance.ldlt().solve(d));
    }
  }
  return out;
}

double Rivals::difference(std::size_t candidate) const {
  double largest = 0;
  for (const Eigen::VectorXd& d : models_[1].difference)
    if (std::abs(d(Eigen::Index(candidate))) > std::abs(largest)) largest = d(Eigen::Index(candidate));
  return largest;
}

void Rivals::read(std::size_t candidate) {
  for (Refitted& m : models_) {
    const RowMatrix g = at_row(*m.candidates, candidate), inverse = m.information.inverse();
    RowMatrix variance = g * inverse * g.transpose();
    variance.diagonal().array() += noise_variance_;
    Eigen::VectorXd d(g.rows());
    for (Eigen::Index c = 0; c < d.size(); ++c) d(c) = m.difference[std::size_t(c)](Eigen::Index(candidate));
    const Eigen::VectorXd step = inverse * g.transpose() * variance.ldlt().solve(d);
    m.information += g.transpose() * g / noise_variance_;
    for (std::size_t c = 0; c < m.difference.size(); ++c)
      m.difference[c] -= m.candidates->gradients[c] * step;
  }
}

}  // namespace brdf::fit
