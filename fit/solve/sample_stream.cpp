#include "fit/solve/sample_stream.h"

#include <algorithm>
#include <cmath>

#include "fit/solve/workspace.h"

namespace brdf::fit {

// Returns the contributions of the columns (lobes, partials, residual) of one channel. The residual
// contributes nothing.
Contributions contributions(const Model& model, std::span<const double> p, std::size_t channel) {
  Contributions out(model.lobes() + model.partials());
  const std::size_t group = model.group_of(channel);
  for (const WeightSlope& w : model.weight_slopes(p, channel)) out[w.lobe].push_back({w.slot, w.value});
  for (std::size_t q = 0; q < model.partials(); ++q)
    for (const auto& [slot, slope] : model.slopes_of_partial(p, q, group))
      out[model.lobes() + q].push_back({slot, slope});
  return out;
}

void add_mapped(const Contributions& map, const Matrix& raw, Matrix& out) {
  for (std::size_t i = 0; i < map.size(); ++i)
    for (std::size_t j = 0; j < map.size(); ++j) {
      const double value = i <= j ? raw(i, j) : raw(j, i);
      for (const Contribution& x : map[i])
        for (const Contribution& y : map[j]) out(x.slot, y.slot) += x.factor * y.factor * value;
    }
}

// Transforms a matrix of the solver's parameters to the columns of one channel.
Matrix of_columns(const Contributions& map, const Matrix& m) {
  Matrix out(map.size(), map.size());
  for (std::size_t i = 0; i < map.size(); ++i)
    for (std::size_t j = 0; j < map.size(); ++j)
      for (const Contribution& x : map[i])
        for (const Contribution& y : map[j]) out(i, j) += x.factor * y.factor * m(x.slot, y.slot);
  return out;
}

void mirror(Matrix& m) {
  for (std::size_t i = 0; i < m.rows; ++i)
    for (std::size_t j = 0; j < i; ++j) m(i, j) = m(j, i);
}

ResidualInputs residual_inputs(const FitData& data, std::size_t channel, std::size_t first, std::size_t rows,
                               const double* f) {
  return {f,
          &data.values[channel][first],
          &data.wi_z[first],
          &data.wo_z[first],
          data.weight.empty() ? nullptr : &data.weight[first],
          data.sigma.empty() ? nullptr : &data.sigma[channel][first],
          rows,
          data.value_slope.empty() ? nullptr : &data.value_slope[channel][first]};
}

void note_value_slopes(FitData& data, Metric metric) {
  data.value_slope.clear();
  if (metric != Metric::log && metric != Metric::log_relative) return;
  // Assigned only when all channels are complete, because the inputs contain the slopes of every channel.
  std::vector<std::vector<double>> slopes(data.values.size(), std::vector<double>(data.rows()));
  for (std::size_t c = 0; c < slopes.size(); ++c)
    slopes_at_values({metric, {}, false}, residual_inputs(data, c, 0, data.rows(), nullptr),
                     slopes[c].data());
  data.value_slope = std::move(slopes);
}

SampleStream::SampleStream(const FitData& data, const Model& model, const Residual& residual, double aperture,
                           std::shared_ptr<Spare> spare)
    : data_(data),
      model_(model),
      residual_(residual),
      aperture_(aperture),
      part_{{0, data.rows()}},
      spare_(spare ? std::move(spare) : std::make_shared<Spare>()) {
  static std::atomic<std::uint64_t> streams{0};
  id_ = ++streams;
  if (aperture > 0) detector_ = aperture_nodes(degrees(aperture), kFitRings);
}

SampleStream::SampleStream(const SampleStream& all, std::vector<RowRange> part) : SampleStream(all) {
  part_ = std::move(part);
}

SampleStream::Shapes SampleStream::shapes(std::span<const double> p, std::size_t group,
                                          bool derivatives) const {
  Shapes s;
  for (std::size_t t = 0; t < model_.terms().size(); ++t) s.shape.push_back(model_.shape(p, t, group));
  s.tangent_phi = model_.tangent_phi(p);
  s.normal = model_.normal(p);
  s.derivatives = derivatives;
  // On the square scale, the derivative is divided by the parameter itself: keep away from 0.
  for (const Slot& slot : model_.slots())
    if (slot.scale == Scale::square && slot.in_group(group))
      for (std::size_t m : slot.members)
        s.shape[slot.term][m] = std::max(s.shape[slot.term][m], kSquareFloor);
  return s;
}

void SampleStream::fill_lobes(const Shapes& shapes, std::size_t first, std::size_t rows, Workspace& w) const {
  if (w.stream == id_ && w.first == first && w.rows == rows && w.shapes == shapes) return;
  w.stream = 0;  // invalid until the lobes are complete
  evaluate_lobes(shapes, first, rows, w);
  w.stream = id_;
  w.shapes = shapes;
  w.first = first;
  w.rows = rows;
}

void SampleStream::evaluate_lobes(const Shapes& shapes, std::size_t first, std::size_t rows,
                                  Workspace& w) const {
  const Directions<double> directions =
      model_.fits_normal() ? tilt(shapes.normal, first, rows, w) : data_.directions(first, rows);
  for (std::size_t t = 0; t < model_.terms().size(); ++t) {
    const TermModel& term = model_.terms()[t];
    LobeColumns& columns = w.terms[t];
    const bool derivatives = shapes.derivatives && term.partials > 0;
    const Partial partial = !derivatives                ? Partial::none
                            : term.tangent_partial >= 0 ? Partial::shape_and_phi
                                                        : Partial::shape;
    columns.evaluate(shapes.shape[t], shapes.tangent_phi, partial, directions, detector_);
    for (std::size_t k = 0; k < term.lobes; ++k) {
      w.lobes[term.first_lobe + k] = columns.lobe(k);
      if (!derivatives) continue;
      std::vector<bool> taken(term.partials, false);
      for (std::size_t m = 0; m < term.partial.size(); ++m) {
        if (term.partial[m] < 0) continue;
        const std::size_t q = std::size_t(term.partial[m]);
        double*& column = w.derivatives[term.first_partial + q][k];
        if (taken[q])  // tied parameters move together, so their derivatives are added
          add(columns.derivative(k, m), padded(rows), column);
        else
          column = columns.derivative(k, m);
        taken[q] = true;
      }
      if (term.tangent_partial >= 0)
        w.derivatives[term.first_partial + std::size_t(term.tangent_partial)][k] =
            columns.derivative(k, term.partial.size());
    }
  }
  if (model_.fits_normal()) fill_tilted(shapes, first, rows, w);
}

// Computes the derivatives of one channel's residuals by the weights of its lobes and by the shapes, before
// the scales.
void SampleStream::fill_jacobian(const double* weights, std::size_t rows, Workspace& w) const {
  const std::size_t entries = padded(rows);
  for (std::size_t k = 0; k < model_.lobes(); ++k) multiply(w.lobes[k], w.slope, entries, w.scaled[k]);
  for (const TermModel& term : model_.terms())
    for (std::size_t q = term.first_partial; q < term.first_partial + term.partials; ++q) {
      mix(term.lobes, w.derivatives[q].data(), weights + term.first_lobe, entries, w.mixed);
      multiply(w.mixed, w.slope, entries, w.scaled[model_.lobes() + q]);
    }
}

SampleStream::Spare::~Spare() {
  delete kept_.load();
}

std::unique_ptr<SampleStream::Workspace> SampleStream::Spare::take(const Model& model) {
  std::unique_ptr<Workspace> workspace(kept_.exchange(nullptr));
  return workspace ? std::move(workspace) : std::make_unique<Workspace>(model);
}

void SampleStream::Spare::give(std::unique_ptr<Workspace> workspace) {
  delete kept_.exchange(workspace.release());
}

// Calls visit(first, rows) for every block.
template <class Visit>
void SampleStream::for_each_block(Visit&& visit) const {
  for (const RowRange& range : part_)
    for (std::size_t done = 0; done < range.rows; done += kBlockRows)
      visit(range.first + done, std::min(kBlockRows, range.rows - done));
}

SampleStream::ChannelSums SampleStream::accumulate(std::span<const double> p, const Matrix& weights,
                                                   const Residual& residual, bool derivatives,
                                                   Besides* besides) const {
  const std::size_t channels = data_.channels.size(), columns = model_.lobes() + model_.partials() + 1;
  const bool robust = residual.loss.kind != LossFunction::Kind::none && !residual.linearised;
  std::vector<Shapes> group_shapes;
  for (std::size_t g = 0; g < model_.groups(); ++g) group_shapes.push_back(shapes(p, g, derivatives));
  std::unique_ptr<Workspace> own = spare_->take(model_);
  Workspace& w = *own;
  ChannelSums out{std::vector<Matrix>(channels, Matrix(columns, columns)), 0};
  double robust_sum = 0;
  const bool expects = besides && residual.loss.kind == LossFunction::Kind::none;
  std::vector<Contributions> map;
  for (std::size_t c = 0; expects && c < channels; ++c) map.push_back(contributions(model_, p, c));
  for_each_block([&](std::size_t first, std::size_t rows) {
    const std::size_t entries = padded(rows);
    std::fill(w.slope + rows, w.slope + entries, 0.0);
    std::fill(w.r + rows, w.r + entries, 0.0);
    for (std::size_t k = 0; expects && k < w.scores.size(); ++k)
      std::fill(w.scores[k], w.scores[k] + entries, 0.0);
    for (std::size_t c = 0; c < channels; ++c) {
      if (c == 0 || model_.groups() > 1) fill_lobes(group_shapes[model_.group_of(c)], first, rows, w);
      mix(model_.lobes(), w.lobes.data(), &weights.a[c * weights.cols], entries, w.f);
      if (besides) std::copy(w.f, w.f + rows, besides->values[c].begin() + std::ptrdiff_t(first));
      residuals(residual, residual_inputs(data_, c, first, rows, w.f), w.r, w.slope);
      if (robust) {
        apply_loss(residual.loss, rows, w.r, w.rho, w.root, w.curvature);
        for (std::size_t j = 0; j < rows; ++j) {
          robust_sum += w.rho[j];
          w.r[j] *= w.root[j];
          w.slope[j] *= w.root[j];
        }
      }
      if (derivatives)
        fill_jacobian(&weights.a[c * weights.cols], rows, w);
      else
        for (std::size_t k = 0; k < model_.lobes(); ++k) multiply(w.lobes[k], w.slope, entries, w.scaled[k]);
      std::copy(w.r, w.r + entries, w.scaled.back());
      add_gram(columns, w.scaled.data(), columns, w.scaled.data(), true, entries, out.raw[c].a.data());
      if (!expects) continue;
      multiply(w.f, w.slope, rows, w.r);
      add_to_scores(map[c], false, rows, w);
    }
    if (expects)
      add_gram(w.scores.size(), w.scores.data(), w.scores.size(), w.scores.data(), true, entries,
               besides->expected_meat.a.data());
  });
  if (expects) mirror(besides->expected_meat);

  double sum = 0;
  for (const Matrix& raw : out.raw) sum += raw(columns - 1, columns - 1);
  out.cost = 0.5 * (robust ? robust_sum : sum);
  spare_->give(std::move(own));
  return out;
}

NormalEquations SampleStream::mapped(const ChannelSums& sums, std::span<const double> p) const {
  NormalEquations out;
  out.hessian = Matrix(model_.size(), model_.size());
  out.gradient.assign(model_.size(), 0);
  out.cost = sums.cost;
  for (std::size_t c = 0; c < sums.raw.size(); ++c) {
    const Matrix& raw = sums.raw[c];
    const Contributions map = contributions(model_, p, c);
    add_mapped(map, raw, out.hessian);
    for (std::size_t i = 0; i < map.size(); ++i)
      for (const Contribution& x : map[i]) out.gradient[x.slot] += x.factor * raw(i, raw.cols - 1);
  }
  return out;
}

Matrix SampleStream::lobe_weights(std::span<const double> p) const {
  Matrix weights(data_.channels.size(), model_.lobes());
  for (std::size_t c = 0; c < weights.rows; ++c)
    model_.lobe_weights(p, c, std::span(&weights(c, 0), weights.cols));
  return weights;
}

NormalEquations SampleStream::normal_equations(std::span<const double> p, Besides* besides) const {
  if (besides) {
    besides->values.resize(data_.channels.size());
    for (std::vector<double>& channel : besides->values) channel.resize(data_.rows());
    besides->expected_meat = Matrix(model_.size(), model_.size());
  }
  NormalEquations out = mapped(accumulate(p, lobe_weights(p), residual_, true, besides), p);
  add_cuts(p, out);
  return out;
}

NormalEquations SampleStream::without_cuts(std::span<const double> p) const {
  return mapped(accumulate(p, lobe_weights(p), residual_, true), p);
}

void SampleStream::add_cuts(std::span<const double> p, NormalEquations& to) const {
  std::vector<double> weights(model_.lobes());
  for (const Cut& cut : model_.cuts()) {
    model_.lobe_weights(p, cut.channel, weights);
    const double shortfall = cut.shortfall(weights);
    to.cost += 0.5 * cut.stiffness * shortfall * shortfall;
    if (shortfall == 0) continue;
    for (const WeightSlope& w : model_.weight_slopes(p, cut.channel))
      to.gradient[w.slot] -= cut.stiffness * shortfall * cut.lobes[w.lobe] * w.value;
  }
  add_cuts(p, to.hessian);
}

void SampleStream::add_cuts(std::span<const double> p, Matrix& hessian) const {
  std::vector<double> weights(model_.lobes());
  for (const Cut& cut : model_.cuts()) {
    model_.lobe_weights(p, cut.channel, weights);
    if (!cut.is_reached(weights)) continue;
    const std::vector<WeightSlope> slopes = model_.weight_slopes(p, cut.channel);
    for (const WeightSlope& a : slopes)
      for (const WeightSlope& b : slopes)
        hessian(a.slot, b.slot) += cut.stiffness * cut.lobes[a.lobe] * a.value * cut.lobes[b.lobe] * b.value;
  }
}

NormalEquations SampleStream::linearised_weights(std::span<const double> p) const {
  std::vector<double> q(p.begin(), p.end());
  std::fill(q.begin() + std::ptrdiff_t(model_.shape_slots()), q.end(), 0.0);
  Residual linear = residual_;
  linear.linearised = true;
  return mapped(accumulate(q, lobe_weights(q), linear, false), q);
}

LobeQuadratic SampleStream::linearised_lobes(std::span<const double> p) const {
  const std::size_t lobes = model_.lobes(), last = lobes + model_.partials();
  Residual linear = residual_;
  linear.linearised = true;
  const ChannelSums sums = accumulate(p, Matrix(data_.channels.size(), lobes), linear, false);
  LobeQuadratic out{{}, Matrix(sums.raw.size(), lobes), sums.cost};
  for (std::size_t c = 0; c < sums.raw.size(); ++c) {
    const Matrix& raw = sums.raw[c];
    Matrix hessian(lobes, lobes);
    for (std::size_t i = 0; i < lobes; ++i) {
      for (std::size_t j = 0; j < lobes; ++j) hessian(i, j) = raw(std::min(i, j), std::max(i, j));
      out.gradient(c, i) = raw(i, last);
    }
    out.hessian.push_back(std::move(hessian));
  }
  return out;
}

LobeGram SampleStream::lobe_gram(std::span<const double> p, std::size_t group) const {
  const std::size_t channels = data_.channels.size();
  LobeGram out;
  out.lobes = model_.lobes();
  std::vector<std::size_t> members;
  for (std::size_t c = 0; c < channels; ++c)
    if (model_.group_of(c) == group) members.push_back(c);
  for (const TermModel& term : model_.terms()) out.derivatives += term.partials * term.lobes;
  const std::size_t columns = out.lobes + out.derivatives, all = columns + members.size();
  const Shapes group_shapes = shapes(p, group, true);
  std::unique_ptr<Workspace> own = spare_->take(model_);
  Workspace& w = *own;
  std::vector<double> scaled(all * kBlockRows);
  std::vector<double*> column;
  for (std::size_t k = 0; k < all; ++k) column.push_back(&scaled[k * kBlockRows]);
  Matrix products(columns, all);
  out.square.assign(members.size(), 0);
  for_each_block([&](std::size_t first, std::size_t rows) {
    const std::size_t entries = padded(rows);
    fill_lobes(group_shapes, first, rows, w);
    for (std::size_t j = 0; j < entries; ++j) w.slope[j] = j < rows ? data_.wi_z[first + j] : 0.0;
    if (!data_.weight.empty())
      for (std::size_t j = 0; j < rows; ++j) w.slope[j] *= std::sqrt(data_.weight[first + j]);
    std::size_t next = 0;
    for (double* lobe : w.lobes) multiply(lobe, w.slope, entries, column[next++]);
    for (const auto& partial : w.derivatives)
      for (double* derivative : partial) multiply(derivative, w.slope, entries, column[next++]);
    for (std::size_t m = 0; m < members.size(); ++m) {
      const double* y = &data_.values[members[m]][first];
      double* out_column = column[next++];
      double square = 0;
      for (std::size_t j = 0; j < rows; ++j) {
        out_column[j] = y[j] * w.slope[j];
        square += out_column[j] * out_column[j];
      }
      std::fill(out_column + rows, out_column + entries, 0.0);
      out.square[m] += square;
    }
    // Only j >= i is computed. The measurements are to the right of the lobes, so every required product is
    // included.
    add_gram(columns, column.data(), all, column.data(), true, entries, products.a.data());
  });
  spare_->give(std::move(own));
  out.gram = Matrix(columns, columns);
  out.cross = Matrix(members.size(), columns);
  for (std::size_t i = 0; i < columns; ++i) {
    for (std::size_t j = 0; j < columns; ++j) out.gram(i, j) = products(std::min(i, j), std::max(i, j));
    for (std::size_t m = 0; m < members.size(); ++m) out.cross(m, i) = products(i, columns + m);
  }
  return out;
}

std::vector<std::vector<double>> SampleStream::values(std::span<const double> p) const {
  std::vector out(data_.channels.size(), std::vector<double>(data_.rows()));
  values(p, out);
  return out;
}

void SampleStream::values(std::span<const double> p, std::vector<std::vector<double>>& out) const {
  std::unique_ptr<Workspace> own = spare_->take(model_);
  Workspace& w = *own;
  std::vector<double> weights(model_.lobes());
  std::vector<Shapes> group_shapes;
  for (std::size_t g = 0; g < model_.groups(); ++g) group_shapes.push_back(shapes(p, g, false));
  for_each_block([&](std::size_t first, std::size_t rows) {
    for (std::size_t c = 0; c < out.size(); ++c) {
      if (c == 0 || model_.groups() > 1) fill_lobes(group_shapes[model_.group_of(c)], first, rows, w);
      model_.lobe_weights(p, c, weights);
      mix(model_.lobes(), w.lobes.data(), weights.data(), padded(rows), w.f);
      std::copy(w.f, w.f + rows, out[c].begin() + std::ptrdiff_t(first));
    }
  });
  spare_->give(std::move(own));
}

std::vector<std::vector<double>> SampleStream::residual_values(std::span<const double> p) const {
  return residuals_of(values(p));
}

std::vector<std::vector<double>> SampleStream::of_values(std::vector<std::vector<double>> values,
                                                         bool slopes) const {
  std::vector<double> r(kBlockRows), slope(kBlockRows);
  const std::vector<double>& wanted = slopes ? slope : r;
  for_each_block([&](std::size_t first, std::size_t rows) {
    for (std::size_t c = 0; c < values.size(); ++c) {
      double* column = &values[c][first];
      residuals(residual_, residual_inputs(data_, c, first, rows, column), r.data(), slope.data());
      std::copy(wanted.begin(), wanted.begin() + std::ptrdiff_t(rows), column);
    }
  });
  return values;
}

}  // namespace brdf::fit
