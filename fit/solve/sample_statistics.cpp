// What uncertainty needs of the samples besides the normal equations.
#include <algorithm>
#include <cmath>

#include "fit/solve/workspace.h"

namespace brdf::fit {
namespace {

// How much of its own residual a value explains: at most 0.99, so that a value that fixes a parameter alone
// counts as very uncertain, not as infinitely so.
double leverage(const Matrix& inverse, const std::vector<double*>& columns, std::size_t row,
                double curvature) {
  double h = 0;
  for (std::size_t i = 0; i < inverse.rows; ++i)
    for (std::size_t j = 0; j < inverse.cols; ++j) h += columns[i][row] * inverse(i, j) * columns[j][row];
  return std::clamp(h * curvature, 0.0, 0.99);
}

}  // namespace

ScoreMatrices SampleStream::scores(std::span<const double> p, const Matrix* inverse) const {
  const std::size_t channels = data_.channels.size(), columns = model_.lobes() + model_.partials();
  const std::size_t size = model_.size();
  ScoreMatrices out{Matrix(size, size), Matrix(size, size)};
  std::vector<Matrix> raw(channels, Matrix(columns, columns));
  std::vector<Contributions> map;
  std::vector<Matrix> column_inverse;
  std::vector<Shapes> group_shapes;
  for (std::size_t g = 0; g < model_.groups(); ++g) group_shapes.push_back(shapes(p, g, true));
  Matrix weights(channels, model_.lobes());
  for (std::size_t c = 0; c < channels; ++c) {
    model_.lobe_weights(p, c, std::span(&weights(c, 0), model_.lobes()));
    map.push_back(contributions(model_, p, c));
    if (inverse) column_inverse.push_back(of_columns(map.back(), *inverse));
  }
  std::unique_ptr<Workspace> own = spare_.take(model_);
  Workspace& w = *own;
  std::vector<double> curved(columns * kBlockRows);
  std::vector<double*> curved_columns;
  for (std::size_t k = 0; k < columns; ++k) curved_columns.push_back(&curved[k * kBlockRows]);
  for (std::size_t first = 0; first < data_.rows(); first += kBlockRows) {
    const std::size_t rows = std::min(kBlockRows, data_.rows() - first);
    for (double* column : w.scores) std::fill(column, column + kBlockRows, 0.0);
    std::fill(w.slope + rows, w.slope + kBlockRows, 0.0);
    for (std::size_t c = 0; c < channels; ++c) {
      if (c == 0 || model_.groups() > 1) fill_lobes(group_shapes[model_.group_of(c)], first, rows, w);
      mix(model_.lobes(), w.lobes.data(), &weights(c, 0), w.f);
      residuals(residual_, residual_inputs(data_, c, first, rows, w.f), w.r, w.slope);
      apply_loss(residual_.loss, rows, w.r, w.rho, w.root, w.curvature);
      fill_jacobian(&weights(c, 0), w);
      if (inverse)
        for (std::size_t j = 0; j < rows; ++j)
          w.r[j] /= std::sqrt(1 - leverage(column_inverse[c], w.scaled, j, w.curvature[j]));
      for (std::size_t k = 0; k < columns; ++k) {
        for (std::size_t j = 0; j < rows; ++j) {
          curved_columns[k][j] = w.scaled[k][j] * w.curvature[j];
          const double score = w.scaled[k][j] * w.r[j] * w.root[j] * w.root[j];
          for (const Contribution& x : map[c][k]) w.scores[x.slot][j] += x.factor * score;
        }
        std::fill(curved_columns[k] + rows, curved_columns[k] + kBlockRows, 0.0);
      }
      add_gram(columns, curved_columns.data(), columns, w.scaled.data(), true, raw[c].a.data());
    }
    add_gram(size, w.scores.data(), size, w.scores.data(), true, out.meat.a.data());
  }
  for (std::size_t c = 0; c < channels; ++c) add_mapped(map[c], raw[c], out.bread);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < i; ++j) out.meat(i, j) = out.meat(j, i);
  return out;
}

std::vector<double> SampleStream::freedom(std::span<const double> p,
                                          const std::vector<std::vector<double>>& v) const {
  const std::size_t channels = data_.channels.size(), columns = model_.lobes() + model_.partials();
  std::vector<double> square(v.size(), 0), fourth(v.size(), 0), weights(model_.lobes());
  Workspace w(model_);
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
      mix(model_.lobes(), w.lobes.data(), weights.data(), w.f);
      residuals(residual_, residual_inputs(data_, c, first, rows, w.f), w.r, w.slope);
      apply_loss(residual_.loss, rows, w.r, w.rho, w.root, w.curvature);
      fill_jacobian(weights.data(), w);
      for (std::size_t j = 0; j < rows; ++j) {
        const double noise = w.f[j] * w.slope[j] * w.root[j] * w.root[j];
        for (std::size_t i = 0; i < v.size(); ++i) {
          double a = 0;
          for (std::size_t k = 0; k < columns; ++k) a += by_column(i, k) * w.scaled[k][j];
          a *= a * noise * noise;
          square[i] += a;
          fourth[i] += a * a;
        }
      }
    }
  }
  for (std::size_t i = 0; i < v.size(); ++i)
    square[i] = fourth[i] > 0 ? square[i] * square[i] / fourth[i] : double(data_.rows());
  return square;
}

std::vector<std::vector<double>> SampleStream::value_errors(std::span<const double> p,
                                                            const Matrix& covariance) const {
  const std::size_t channels = data_.channels.size(), columns = model_.lobes() + model_.partials();
  std::vector out(channels, std::vector<double>(data_.rows()));
  std::vector<double> weights(model_.lobes());
  Workspace w(model_);
  std::fill(w.slope, w.slope + kBlockRows, 1.0);
  for (std::size_t c = 0; c < channels; ++c) {
    const Shapes group_shapes = shapes(p, model_.group_of(c), true);
    model_.lobe_weights(p, c, weights);
    const Matrix by_column = of_columns(contributions(model_, p, c), covariance);
    for (std::size_t first = 0; first < data_.rows(); first += kBlockRows) {
      const std::size_t rows = std::min(kBlockRows, data_.rows() - first);
      fill_lobes(group_shapes, first, rows, w);
      fill_jacobian(weights.data(), w);
      for (std::size_t j = 0; j < rows; ++j) {
        double variance = 0;
        for (std::size_t i = 0; i < columns; ++i)
          for (std::size_t k = 0; k < columns; ++k)
            variance += w.scaled[i][j] * by_column(i, k) * w.scaled[k][j];
        out[c][first + j] = std::sqrt(std::max(variance, 0.0));
      }
    }
  }
  return out;
}

}  // namespace brdf::fit
