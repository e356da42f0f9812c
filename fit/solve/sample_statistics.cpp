// Statistics of the samples that the uncertainty needs in addition to the normal equations.
#include <algorithm>
#include <cmath>

#include "fit/solve/workspace.h"

namespace brdf::fit {
// Adds the contribution of one channel's residuals (in `r`) and derivatives to the scores of the rows.
void SampleStream::add_to_scores(const Contributions& map, bool robust, std::size_t rows, Workspace& w) {
  for (std::size_t k = 0; k < map.size(); ++k) {
    multiply(w.scaled[k], w.r, rows, w.mixed);
    for (int times = 0; robust && times < 2; ++times) scale(w.root, rows, w.mixed);
    for (const Contribution& x : map[k]) add_scaled(x.factor, w.mixed, rows, w.scores[x.slot]);
  }
}

void SampleStream::add_scores(std::span<const double> p, const Leverage& leverage, Matrix* bread,
                              Matrix* meat) const {
  const std::size_t channels = data_.channels.size(), columns = model_.lobes() + model_.partials();
  const std::size_t size = model_.size();
  std::vector<Matrix> raw(bread ? channels : 0, Matrix(columns, columns));
  std::vector<Contributions> map;
  std::vector<Matrix> column_inverse, column_expected;
  std::vector<Shapes> group_shapes;
  for (std::size_t g = 0; g < model_.groups(); ++g) group_shapes.push_back(shapes(p, g, true));
  const Matrix weights = lobe_weights(p);
  for (std::size_t c = 0; c < channels; ++c) {
    map.push_back(contributions(model_, p, c));
    if (leverage.inverse) column_inverse.push_back(of_columns(map.back(), *leverage.inverse));
    if (leverage.expected) column_expected.push_back(of_columns(map.back(), *leverage.expected));
  }
  std::unique_ptr<Workspace> own = spare_->take(model_);
  Workspace& w = *own;
  const bool robust = residual_.loss.kind != LossFunction::Kind::none;
  std::vector<double> noise(kBlockRows), curved(bread ? columns * kBlockRows : 0);
  std::vector<double*> curved_columns;
  for (std::size_t k = 0; bread && k < columns; ++k) curved_columns.push_back(&curved[k * kBlockRows]);
  for (std::size_t first = 0; first < data_.rows(); first += kBlockRows) {
    const std::size_t rows = std::min(kBlockRows, data_.rows() - first), entries = padded(rows);
    for (double* column : w.scores) std::fill(column, column + entries, 0.0);
    std::fill(w.slope + rows, w.slope + entries, 0.0);
    for (std::size_t c = 0; c < channels; ++c) {
      if (c == 0 || model_.groups() > 1) fill_lobes(group_shapes[model_.group_of(c)], first, rows, w);
      mix(model_.lobes(), w.lobes.data(), &weights.a[c * weights.cols], entries, w.f);
      residuals(residual_, residual_inputs(data_, c, first, rows, w.f), w.r, w.slope);
      apply_loss(residual_.loss, rows, w.r, w.rho, w.root, w.curvature);
      fill_jacobian(&weights.a[c * weights.cols], rows, w);
      if (leverage.noise_alone) multiply(w.f, w.slope, rows, w.r);
      if (leverage.scores) std::copy_n(&(*leverage.scores)[c][first], rows, w.r);
      if (leverage.inverse) {
        quadratic_forms(columns, w.scaled.data(), column_inverse[c].a.data(), entries, w.mixed);
        if (leverage.expected) {
          quadratic_forms(columns, w.scaled.data(), column_expected[c].a.data(), entries, w.rho);
          multiply(w.f, w.slope, rows, noise.data());
        }
        free_of_influence(w.mixed, w.curvature, leverage.expected ? w.rho : nullptr, noise.data(), rows, w.r);
      }
      if (meat || leverage.sums) add_to_scores(map[c], robust, rows, w);
      if (meat && leverage.clusters == Clusters::values) {
        add_gram(size, w.scores.data(), size, w.scores.data(), true, entries, meat->a.data());
        for (double* column : w.scores) std::fill(column, column + entries, 0.0);
      }
      if (!bread) continue;
      std::fill(w.curvature + rows, w.curvature + entries, 0.0);
      for (std::size_t k = 0; k < columns; ++k)
        multiply(w.scaled[k], w.curvature, entries, curved_columns[k]);
      add_gram(columns, curved_columns.data(), columns, w.scaled.data(), true, entries, raw[c].a.data());
    }
    for (std::size_t j = 0; leverage.sums && j < rows; ++j)
      for (std::size_t k = 0; k < size; ++k)
        (*leverage.sums)(leverage.cluster[first + j], k) += w.scores[k][j];
    if (meat && leverage.clusters == Clusters::rows)
      add_gram(size, w.scores.data(), size, w.scores.data(), true, entries, meat->a.data());
  }
  spare_->give(std::move(own));
  for (std::size_t c = 0; bread && c < channels; ++c) add_mapped(map[c], raw[c], *bread);
  if (bread) add_cuts(p, *bread);
  if (meat) mirror(*meat);
}

ScoreMatrices SampleStream::scores(std::span<const double> p) const {
  ScoreMatrices out{Matrix(model_.size(), model_.size()), Matrix(model_.size(), model_.size())};
  add_scores(p, {}, &out.bread, &out.meat);
  return out;
}

Matrix SampleStream::bread(std::span<const double> p) const {
  Matrix out(model_.size(), model_.size());
  add_scores(p, {}, &out, nullptr);
  return out;
}

Matrix SampleStream::meat(std::span<const double> p, const Matrix& inverse, const Matrix* expected) const {
  Matrix out(model_.size(), model_.size());
  add_scores(p, {&inverse, expected}, nullptr, &out);
  return out;
}

Matrix SampleStream::expected_meat(std::span<const double> p) const {
  Matrix out(model_.size(), model_.size());
  add_scores(p, {.noise_alone = true}, nullptr, &out);
  return out;
}

Matrix SampleStream::meat_of(std::span<const double> p, const std::vector<std::vector<double>>& scores,
                             Clusters clusters) const {
  Matrix out(model_.size(), model_.size());
  Leverage given;
  given.scores = &scores;
  given.clusters = clusters;
  add_scores(p, given, nullptr, &out);
  return out;
}

Matrix SampleStream::score_sums(std::span<const double> p, const std::vector<std::vector<double>>& scores,
                                std::span<const std::uint32_t> cluster) const {
  Matrix out(cluster.empty() ? 0 : 1 + std::ranges::max(cluster), model_.size());
  Leverage given;
  given.scores = &scores;
  given.sums = &out;
  given.cluster = cluster;
  add_scores(p, given, nullptr, nullptr);
  return out;
}

std::vector<NoiseShares> SampleStream::noise_shares(std::span<const double> p,
                                                    const std::vector<std::vector<double>>& v) const {
  const std::size_t channels = data_.channels.size(), columns = model_.lobes() + model_.partials();
  std::vector<NoiseShares> out(v.size());
  std::vector<double> weights(model_.lobes());
  const bool robust = residual_.loss.kind != LossFunction::Kind::none;
  std::unique_ptr<Workspace> own = spare_->take(model_);
  Workspace& w = *own;
  for (std::size_t c = 0; c < channels; ++c) {
    const Shapes group_shapes = shapes(p, model_.group_of(c), true);
    model_.lobe_weights(p, c, weights);
    const Contributions map = contributions(model_, p, c);
    Matrix by_column(v.size(), columns);
    for (std::size_t i = 0; i < v.size(); ++i)
      for (std::size_t k = 0; k < columns; ++k)
        for (const Contribution& x : map[k]) by_column(i, k) += x.factor * v[i][x.slot];
    for (std::size_t first = 0; first < data_.rows(); first += kBlockRows) {
      const std::size_t rows = std::min(kBlockRows, data_.rows() - first);
      fill_lobes(group_shapes, first, rows, w);
      mix(model_.lobes(), w.lobes.data(), weights.data(), padded(rows), w.f);
      residuals(residual_, residual_inputs(data_, c, first, rows, w.f), w.r, w.slope);
      apply_loss(residual_.loss, rows, w.r, w.rho, w.root, w.curvature);
      fill_jacobian(weights.data(), rows, w);
      multiply(w.f, w.slope, rows, w.r);
      for (int times = 0; robust && times < 2; ++times) scale(w.root, rows, w.r);
      for (std::size_t i = 0; i < v.size(); ++i) {
        mix(columns, w.scaled.data(), &by_column(i, 0), rows, w.mixed);
        multiply_squares(w.mixed, w.r, rows, w.rho);
        out[i].add(std::span<const double>(w.rho, rows));
      }
    }
  }
  spare_->give(std::move(own));
  return out;
}

ValueErrors SampleStream::value_errors(std::span<const double> p, const Matrix& covariance) const {
  const std::size_t channels = data_.channels.size(), columns = model_.lobes() + model_.partials();
  const std::vector none(channels, std::vector<double>(data_.rows()));
  ValueErrors out{none, none};
  std::vector<double> weights(model_.lobes());
  std::vector<Shapes> group_shapes;
  for (std::size_t g = 0; g < model_.groups(); ++g) group_shapes.push_back(shapes(p, g, true));
  std::vector<Matrix> by_column;
  for (std::size_t c = 0; c < channels; ++c)
    by_column.push_back(of_columns(contributions(model_, p, c), covariance));
  std::unique_ptr<Workspace> own = spare_->take(model_);
  Workspace& w = *own;
  std::fill(w.slope, w.slope + kBlockRows, 1.0);
  for (std::size_t first = 0; first < data_.rows(); first += kBlockRows) {
    const std::size_t rows = std::min(kBlockRows, data_.rows() - first);
    for (std::size_t c = 0; c < channels; ++c) {
      if (c == 0 || model_.groups() > 1) fill_lobes(group_shapes[model_.group_of(c)], first, rows, w);
      model_.lobe_weights(p, c, weights);
      mix(model_.lobes(), w.lobes.data(), weights.data(), padded(rows), w.f);
      std::copy(w.f, w.f + rows, out.values[c].begin() + std::ptrdiff_t(first));
      fill_jacobian(weights.data(), rows, w);
      quadratic_forms(columns, w.scaled.data(), by_column[c].a.data(), padded(rows), w.mixed);
      for (std::size_t j = 0; j < rows; ++j) out.errors[c][first + j] = std::sqrt(std::max(w.mixed[j], 0.0));
    }
  }
  spare_->give(std::move(own));
  return out;
}

}  // namespace brdf::fit
