#include "fit/design/prediction.h"

namespace brdf::fit {

Prediction::Prediction(const DesignRows& start, double repeats, const DesignRows& candidates,
                       const DesignRows& hemisphere, const NoiseAndError& known)
    : noise_variance_(known.noise * known.noise),
      error_variance_(known.error * known.error),
      start_(Eigen::Index(start.rows())),
      candidates_(Eigen::Index(candidates.rows())),
      hemisphere_(Eigen::Index(hemisphere.rows())) {
  for (const DesignRows* rows : {&start, &candidates, &hemisphere})
    places_.insert(places_.end(), rows->places.begin(), rows->places.end());
  for (std::size_t c = 0; c < start.channels(); ++c) {
    RowMatrix all(start_ + candidates_ + hemisphere_, start.parameters());
    all << start.gradients[c], candidates.gradients[c], hemisphere.gradients[c];
    gradients_.push_back(std::move(all));
  }
  information_ = prior_information(hemisphere).asDiagonal();
  own_ = Eigen::VectorXd::Constant(Eigen::Index(places_.size()), error_variance_);
  across_ = RowMatrix::Zero(hemisphere_, candidates_);
  if (error_variance_ > 0)
    for (Eigen::Index i = 0; i < hemisphere_; ++i)
      for (Eigen::Index j = 0; j < candidates_; ++j)
        across_(i, j) = error_variance_ *
                        correlation(hemisphere.places[std::size_t(i)], candidates.places[std::size_t(j)]);
  for (Eigen::Index k = 0; k < start_; ++k)
    if (start.usable[std::size_t(k)]) condition(k, repeats);
}

// Returns the covariances of the error at a point with the errors at all points, given the readings so far.
Eigen::VectorXd Prediction::covariances(Eigen::Index point) const {
  Eigen::VectorXd out(own_.size());
  const Place& own = places_[std::size_t(point)];
  for (Eigen::Index k = 0; k < out.size(); ++k)
    out(k) = error_variance_ * correlation(own, places_[std::size_t(k)]);
  for (std::size_t j = 0; j < columns_.size(); ++j) out -= columns_[j](point) / variances_[j] * columns_[j];
  return out;
}

void Prediction::condition(Eigen::Index point, double repeats) {
  double variance = noise_variance_ / repeats;
  Eigen::VectorXd column;
  if (error_variance_ > 0) {
    column = covariances(point);
    variance += column(point);
  }
  for (RowMatrix& gradients : gradients_) {
    const Eigen::VectorXd g = gradients.row(point);
    information_ += g * g.transpose() / variance;
    if (error_variance_ > 0) gradients -= column / variance * g.transpose();
  }
  if (!(error_variance_ > 0)) return;
  own_ -= column.cwiseAbs2() / variance;
  across_ -= column.tail(hemisphere_) * column.segment(start_, candidates_).transpose() / variance;
  columns_.push_back(std::move(column));
  variances_.push_back(variance);
}

void Prediction::read(std::size_t candidate) {
  condition(start_ + Eigen::Index(candidate), 1);
}

double Prediction::variance() const {
  const RowMatrix inverse = information_.inverse();
  double sum = 0;
  for (const RowMatrix& all : gradients_) {
    const auto g = all.bottomRows(hemisphere_);
    sum += (g * inverse).cwiseProduct(g).sum();
  }
  return own_.tail(hemisphere_).mean() + sum / double(hemisphere_) / double(gradients_.size());
}

std::vector<double> Prediction::falls() const {
  const std::size_t channels = gradients_.size();
  const RowMatrix inverse = information_.inverse();
  RowMatrix mean = RowMatrix::Zero(inverse.rows(), inverse.cols());
  std::vector<RowMatrix> weighted;  // [channel] of the candidates: the gradients times the covariance
  std::vector<RowMatrix> together;  // [channel] of the candidates: mean of covariance times gradient
  for (const RowMatrix& all : gradients_) {
    const auto g = all.bottomRows(hemisphere_);
    mean += g.transpose() * g / double(hemisphere_);
    weighted.push_back(all.middleRows(start_, candidates_) * inverse);
    together.push_back(across_.transpose() * g / double(hemisphere_));
  }
  std::vector<RowMatrix> spread;
  for (const RowMatrix& w : weighted) spread.push_back(w * mean);
  const Eigen::VectorXd squares = across_.colwise().squaredNorm().transpose() / double(hemisphere_);
  std::vector<double> out(std::size_t(candidates_), 0.0);
  const auto n = Eigen::Index(channels);
  RowMatrix of_reading(n, n), explained(n, n);
  for (Eigen::Index k = 0; k < candidates_; ++k) {
    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index b = 0; b < n; ++b) {
        const auto &wa = weighted[std::size_t(a)], &wb = weighted[std::size_t(b)];
        of_reading(a, b) = wb.row(k).dot(gradients_[std::size_t(a)].row(start_ + k));
        explained(a, b) = together[std::size_t(a)].row(k).dot(wb.row(k)) +
                          together[std::size_t(b)].row(k).dot(wa.row(k)) +
                          spread[std::size_t(a)].row(k).dot(wb.row(k));
      }
    of_reading.diagonal().array() += noise_variance_ + own_(start_ + k);
    explained.diagonal().array() += squares(k);
    out[std::size_t(k)] = of_reading.ldlt().solve(explained).trace() / double(channels);
  }
  return out;
}

}  // namespace brdf::fit
