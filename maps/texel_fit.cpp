#include "maps/texel_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "brdf/frame.h"
#include "fit/assess/verdict.h"
#include "fit/solve/columns.h"
#include "fit/solve/equivalence.h"
#include "fit/solve/minima.h"
#include "fit/solve/nearby.h"
#include "fit/solve/sample_stream.h"
#include "fit/solve/starts.h"
#include "io/columns/supplied.h"
#include "io/files/error.h"
#include "io/samples/degrees.h"
#include "io/samples/noise.h"

namespace brdf::maps {
namespace {

// If a texel has more than twice this number of rows, a starting point is first solved on this many rows.
constexpr std::size_t kCoarseRows = 4096;
// This limit applies to a start at the neighbour's solution, which is near.
constexpr std::size_t kNearRows = 2048;
constexpr std::size_t kSolvedStarts = 6;  // number of grid points of lowest cost that are solved
constexpr double kJump = 2;               // factor of the cost per value from one texel to the next
constexpr double kExact = 1e-10;          // relative to a black surface's cost; below it there is no noise
constexpr double kTolerance = 1e-12, kLoose = 1e-4;
constexpr int kIterations = 100, kFewIterations = 30, kRowRounds = 4;

}  // namespace

void check(const Settings& s) {
  if (s.forms.empty())
    throw InputError("--form auto: a stack is fitted with one form, or a sum, for all texels");
  if (s.options.loss != fit::Loss::none && s.options.loss_scale == 0)
    throw InputError("--robust: a stack needs the loss's scale, such as huber:0.1, for all texels");
  if (s.options.physical == fit::Physical::either)
    throw InputError(
        "--physical: not for stacks, because each texel could be judged to be a different kind of material");
  if (s.options.free_scale)
    throw InputError("--free-scale: not for stacks; divide all images by the same scale first");
  if (s.options.arrangement != io::Arrangement())
    throw InputError("--polarisation, --repeats: not for stacks, because images are used unchanged");
  if (s.options.supplied != io::Supplied())
    throw InputError(
        "--quantity, --mirror-side, --layout: not for stacks, because lights.csv gives the directions");
  if (s.options.smooth > 0)
    throw InputError("--shape smooth: not for stacks, because maps have one shape or one shape per channel");
  if (s.options.random_starts > 0 || !s.options.start.empty())
    throw InputError(
        "--start, --starts: not for stacks, because texels start from the grid or from their neighbours");
  if (s.options.bootstrap > 0)
    throw InputError("--bootstrap: not for stacks, because maps have one standard error per parameter");
  if (s.options.weighting == fit::Weighting::sigma)
    throw InputError("--weights sigma: a stack has no standard deviations");
}

double TexelFit::error(std::size_t channels) const {
  return std::sqrt(2 * cost / double(rows * channels));
}

io::SampleTable texel_table(const texel::Stack& stack, const TexelPixels& texel, const Vec3<double>& normal) {
  io::SampleTable table;
  table.source = stack.folder.string();
  table.set_channels(stack.channels);
  const DirectionArrays<double> arrays = texel::directions_at(stack, texel.x, texel.y);
  const std::size_t images = arrays.size();
  for (std::size_t k = 0; k < images; ++k) {
    const Vec3<double> wi = in_frame_of(normal, arrays.view().wi(k)),
                       wo = in_frame_of(normal, arrays.view().wo(k));
    bool known = wi.z > 0 && wo.z > 0;
    for (std::size_t c = 0; c < stack.channels.size(); ++c)
      known = known && std::isfinite(texel.pixels[c * images + k]);
    if (!known) continue;
    table.add_directions(wi, wo);
    for (std::size_t c = 0; c < stack.channels.size(); ++c)
      table.values[c].push_back(double(texel.pixels[c * images + k]) / wi.z);
  }
  return table;
}

namespace {

fit::FitOptions with_normal(const Settings& settings) {
  fit::FitOptions options = settings.options;
  if (settings.fits_normal) options.normal = {0, 0};
  return options;
}

}  // namespace

TexelFitter::TexelFitter(const texel::Stack& stack, const Settings& settings)
    : stack_(stack),
      settings_(settings),
      model_(settings.forms, stack.channels, with_normal(settings)),
      arrays_(texel::directions_at(stack, 0, 0)),
      turned_(arrays_.size()),
      low_(model_.low()),
      high_(model_.high()),
      starts_(fit::grid_starts(model_)) {
  data_.channels = stack.channels;
  data_.values.resize(stack.channels.size());
}

// Selects the images that show the surface at usable angles. Directions are in the frame of the surface's
// normal, or in the stack's frame if the normal is fitted.
void TexelFitter::select_rows(const Vec3<double>& normal) {
  const Directions<double> all = arrays_.view();
  const std::size_t channels = stack_.channels.size();
  const double least = io::cos_degrees(settings_.options.max_theta) - 1e-12;
  const bool weighted = settings_.options.weighting == fit::Weighting::solid_angle;
  // All columns get this length even if fewer rows are used, since rows are written in place.
  const auto resize = [&](std::size_t rows) {
    for (auto* column : {&data_.wi_x, &data_.wi_y, &data_.wi_z, &data_.wo_x, &data_.wo_y, &data_.wo_z})
      column->resize(rows);
    for (auto& values : data_.values) values.resize(rows);
    data_.weight.resize(weighted ? rows : 0);
    data_.row.resize(rows);
  };
  resize(all.count);
  fit::tilt_batch(all, normal, turned_);
  const Directions<double> local = turned_.view(), written = settings_.fits_normal ? all : local;
  std::size_t rows = 0;
  for (std::size_t k = 0; k < all.count; ++k) {
    const Vec3<double> wi = local.wi(k), wo = local.wo(k);
    bool used = wi.z >= least && wo.z >= least && wi.z > 0 && wo.z > 0;
    for (std::size_t c = 0; c < channels; ++c) used = used && std::isfinite(texel_.pixels[c * all.count + k]);
    if (!used) continue;
    const Vec3<double> light = written.wi(k), viewer = written.wo(k);
    data_.wi_x[rows] = light.x, data_.wi_y[rows] = light.y, data_.wi_z[rows] = light.z;
    data_.wo_x[rows] = viewer.x, data_.wo_y[rows] = viewer.y, data_.wo_z[rows] = viewer.z;
    for (std::size_t c = 0; c < channels; ++c)
      data_.values[c][rows] = double(texel_.pixels[c * all.count + k]) / light.z;
    if (weighted) data_.weight[rows] = std::hypot(wi.x, wi.y) * std::hypot(wo.x, wo.y);
    data_.row[rows++] = std::uint32_t(k);
  }
  resize(rows);
  data_.incidence = data_.row;
  if (fit::FitData inside = fit::within_domain(data_, settings_.options.metric); inside.rows() > 0)
    data_ = std::move(inside);
  fit::note_value_slopes(data_, settings_.options.metric);
  normal_ = normal;
}

fit::Solution TexelFitter::solve_from(const fit::FitData& data, std::span<const double> start,
                                      double tolerance, int iterations) const {
  const fit::SampleStream stream = stream_of(data);
  fit::SolveOptions options;
  options.tolerance = tolerance;
  options.max_iterations = iterations;
  options.interrupted = settings_.options.interrupted;
  return fit::solve_nearby([&](std::span<const double> p) { return stream.normal_equations(p); }, start, low_,
                           high_, options);
}

fit::Solution TexelFitter::solve_from_neighbour(const TexelFit& neighbour) {
  if (data_.rows() <= 2 * kCoarseRows) return solve_from(data_, neighbour.p, kTolerance, kIterations);
  const fit::FitData few = fit::thinned(data_, kNearRows);
  return solve_from(data_, solve_from(few, neighbour.p, kLoose, kIterations).p, kTolerance, kIterations);
}

// Returns the normal of a surface that scatters evenly, and the normal of a mirror that produces the
// brightest pixels.
std::vector<Vec3<double>> TexelFitter::likely_normals() const {
  std::vector<Vec3<double>> out{normal_};
  const std::size_t rows = data_.rows();
  std::vector<double> bright(rows, 0);
  for (const auto& channel : data_.values)
    for (std::size_t k = 0; k < rows; ++k) bright[k] += channel[k] * data_.wi_z[k];
  std::vector<std::size_t> order(rows);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return bright[a] > bright[b]; });
  const auto add = [&](Vec3<double> n) {
    const double length = std::sqrt(dot(n, n));
    if (length > 0 && n.z > 0.5 * length) out.push_back(n * (1 / length));
  };
  Vec3<double> mirror{0, 0, 0};
  for (std::size_t k = 0; k < std::min<std::size_t>(rows, 3 + rows / 100); ++k) {
    const Vec3<double> h = data_.directions(order[k], 1).wi(0) + data_.directions(order[k], 1).wo(0);
    mirror = mirror + h * (std::max(bright[order[k]], 0.0) / std::sqrt(dot(h, h)));
  }
  add(mirror);
  // Photometric stereo (Woodham 1980) on the pixels that are neither highlight nor shadow: normal equations
  // of v = n . l.
  double a[3][4] = {};
  for (std::size_t k = rows / 8; k < rows - rows / 4; ++k) {
    const Vec3<double> l = data_.directions(order[k], 1).wi(0);
    const double v[4] = {l.x, l.y, l.z, bright[order[k]]};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) a[i][j] += v[i] * v[j];
  }
  const Vec3<double> r0{a[0][0], a[0][1], a[0][2]}, r1{a[1][0], a[1][1], a[1][2]},
      r2{a[2][0], a[2][1], a[2][2]};
  const double determinant = dot(r0, cross(r1, r2));
  if (determinant > 1e-9 * a[0][0] * a[1][1] * a[2][2])
    add((cross(r1, r2) * a[0][3] + cross(r2, r0) * a[1][3] + cross(r0, r1) * a[2][3]) * (1 / determinant));
  return out;
}

fit::Solution TexelFitter::solve_from_grid() {
  const bool coarse = data_.rows() > 2 * kCoarseRows;
  const fit::FitData few = coarse ? fit::thinned(data_, kCoarseRows) : fit::FitData();
  const fit::FitData& first = coarse ? few : data_;
  const fit::SampleStream stream = stream_of(first);
  struct Start {
    std::vector<double> p;
    double cost;
  };
  std::vector<Start> starts;
  for (const Vec3<double>& normal :
       settings_.fits_normal ? likely_normals() : std::vector<Vec3<double>>{normal_})
    for (std::vector<double> p : starts_) {
      if (model_.fits_normal()) {
        p[model_.normal_slot()] = normal.x;
        p[model_.normal_slot() + 1] = normal.y;
      }
      fit::start_weights(stream, p);
      const double cost = stream.normal_equations(p).cost;
      if (std::isfinite(cost)) starts.push_back({std::move(p), cost});
    }
  std::ranges::stable_sort(starts, {}, &Start::cost);
  const std::size_t solved = model_.terms().size() > 1 ? starts.size() : kSolvedStarts;
  fit::Solution best;
  best.cost = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < std::min(starts.size(), solved); ++k)
    if (fit::Solution s = solve_from(first, starts[k].p, kLoose, kFewIterations); s.cost < best.cost)
      best = std::move(s);
  return best.p.empty() ? best : solve_from(data_, best.p, kTolerance, kIterations);
}

// Uses the solver of a table's fit, for the few texels with a valley too flat for quick steps.
fit::Solution TexelFitter::solve_at_length(std::span<const double> start) const {
  const fit::SampleStream stream = stream_of(data_);
  fit::SolveOptions options;
  options.interrupted = settings_.options.interrupted;
  return fit::refine(stream, start, options);
}

// A fitted normal determines the images that see the surface. The fit is repeated until the selection is
// stable.
fit::Solution TexelFitter::settle_rows(fit::Solution s) {
  for (int round = 0; round < kRowRounds && model_.fits_normal() && !s.p.empty(); ++round) {
    const std::vector<std::uint32_t> before = data_.row;
    select_rows(model_.normal(s.p));
    if (data_.row == before || data_.rows() == 0) break;
    s = solve_from(data_, s.p, kTolerance, kIterations);
  }
  return s;
}

bool TexelFitter::jumps(const fit::Solution& s, const TexelFit& neighbour) const {
  if (s.termination != fit::Termination::converged) return true;
  if (s.cost / double(data_.rows()) <= kJump * neighbour.cost / double(neighbour.rows)) return false;
  double black = 0;
  for (const auto& channel : data_.values)
    for (std::size_t k = 0; k < data_.rows(); ++k) black += std::pow(channel[k] * data_.wi_z[k], 2);
  return s.cost > kExact * black;
}

// Turns rows from the stack's frame to the frame of the normal, as in the texel's table: the data and
// `values`.
void TexelFitter::turn_rows(const Vec3<double>& normal, fit::FitData& data,
                            std::vector<std::vector<double>>& values) const {
  for (std::size_t k = 0; k < data.rows(); ++k) {
    const Vec3<double> wi = in_frame_of(normal, data_.directions(k, 1).wi(0)),
                       wo = in_frame_of(normal, data_.directions(k, 1).wo(0));
    const double ratio = data_.wi_z[k] / wi.z;
    for (std::size_t c = 0; c < values.size(); ++c) {
      data.values[c][k] *= ratio;
      values[c][k] *= ratio;
    }
    data.wi_x[k] = wi.x, data.wi_y[k] = wi.y, data.wi_z[k] = wi.z;
    data.wo_x[k] = wo.x, data.wo_y[k] = wo.y, data.wo_z[k] = wo.z;
  }
}

// `values` of the model are turned with the rows.
fit::Misfit TexelFitter::judged(std::vector<std::vector<double>>& values, const Vec3<double>& normal) const {
  fit::FitData turned;
  if (model_.fits_normal()) {
    turned = data_;
    turn_rows(normal, turned, values);
  }
  const fit::FitData& local = model_.fits_normal() ? turned : data_;
  fit::Misfit misfit = fit::judge(local, values, std::nullopt);
  if (!misfit.misfit) return misfit;
  // The noise is computed only if it is needed.
  const io::SampleTable table = texel_table(stack_, texel_, normal);
  std::vector<std::uint32_t> used;
  for (std::size_t k = 0; k < table.rows(); ++k)
    if (!table.is_beyond(k, settings_.options.max_theta)) used.push_back(std::uint32_t(k));
  return fit::judge(local, values, io::relative_noise(table, used).value);
}

fit::SampleStream TexelFitter::stream_of(const fit::FitData& data) const {
  return {data, model_, residual_, settings_.options.aperture.value_or(0), spare_};
}

void TexelFitter::assess(const fit::Solution& s, TexelFit& out) {
  const fit::SampleStream stream = stream_of(data_);
  fit::Minimum m{s.p, s.cost, 1, s.at_bound, s.termination, s.message};
  if (!holds_) fit::canonicalise(model_, m);
  const std::vector<double> before = m.p;
  const fit::NormalEquations n = fit::drop_negligible_lobes(stream, m, &besides_);
  // Without a loss function, the solver's matrices are also the matrices for the errors.
  const bool same = m.p == before && residual_.loss.kind == fit::LossFunction::Kind::none;
  const fit::KnownMatrices known{n.hessian, besides_.expected_meat};
  const fit::Uncertainty u = fit::uncertainty(stream, m, fit::Detail::estimates, same ? &known : nullptr);
  out.normal = model_.fits_normal() ? model_.normal(m.p) : normal_;
  out.verdict = fit::verdict_of(m, u, judged(besides_.values, out.normal));
  out.estimates = u.estimates;
  out.p = m.p;
  out.cost = n.cost;
  out.rows = data_.rows();
}

TexelFit TexelFitter::fit(const TexelPixels& texel, const Vec3<double>& normal, const TexelFit* neighbour) {
  texel_ = texel;
  if (stack_.rig.is_near()) arrays_ = texel::directions_at(stack_, texel.x, texel.y);
  TexelFit out;
  select_rows(neighbour && settings_.fits_normal ? neighbour->normal : normal);
  residual_ = fit::chosen_residual(data_, settings_.options);
  const auto reflects = [](const std::vector<double>& column) {
    return std::ranges::any_of(column, [](double value) { return value > 0; });
  };
  if (std::ranges::none_of(data_.values, reflects)) return out;
  fit::Solution s;
  s.cost = std::numeric_limits<double>::infinity();
  if (neighbour) s = settle_rows(solve_from_neighbour(*neighbour));
  out.from_grid = !neighbour || jumps(s, *neighbour);
  if (out.from_grid) {
    fit::Solution other = settle_rows(solve_from_grid());
    if (!other.p.empty() && other.cost < s.cost)
      s = std::move(other);
    else if (!s.p.empty() && model_.fits_normal())
      select_rows(model_.normal(s.p));
  }
  if (!s.p.empty())
    assess(!holds_ && (s.termination == fit::Termination::iteration_limit ||
                       s.termination == fit::Termination::failed)
               ? solve_at_length(s.p)
               : s,
           out);
  return out;
}

void TexelFitter::hold(std::span<const std::size_t> slots, std::span<const double> values) {
  low_ = model_.low();
  high_ = model_.high();
  holds_ = !slots.empty();
  for (std::size_t k = 0; k < slots.size(); ++k) low_[slots[k]] = high_[slots[k]] = values[k];
}

TexelFitter::SharedTerms TexelFitter::shared_terms(const TexelFit& last,
                                                   std::span<const std::size_t> slots) const {
  const fit::SampleStream stream = stream_of(data_);
  const fit::NormalEquations n = stream.normal_equations(last.p);
  std::vector<double> p = last.p;
  SharedTerms out{fit::profile(n, slots, fit::hold_at_bounds(n, p, low_, high_)), {}, n.cost};
  out.meat = fit::congruent(out.profile.follows, stream.meat(last.p, out.profile.inverse));
  return out;
}

}  // namespace brdf::maps
