#include "trade/measure/question.h"

#include <algorithm>
#include <cmath>

namespace brdf::trade {
namespace {

std::vector<double> kernel_values(const Kernel& kernel, const Columns<double>& in, Precision precision) {
  const std::size_t count = count_of(in);
  std::vector<double> out(count);
  if (precision == Precision::double_) {
    kernel.in_double(pointers(in), out);
    return out;
  }
  Columns<float> narrow;
  for (const std::vector<double>& column : in) narrow.emplace_back(column.begin(), column.end());
  std::vector<float> result(count);
  kernel.in_float(pointers(narrow), result);
  std::copy(result.begin(), result.end(), out.begin());
  return out;
}

Values kernel_values(const Kernel& kernel, Precision precision) {
  if (!kernel) return {};
  return [&kernel, precision](const Columns<double>& in) { return kernel_values(kernel, in, precision); };
}

// The first points of the domain, repeated until there are `count` points, in one precision.
template <class T>
struct TimedRun {
  Slab<T> slab;
  Inputs<T> in;
  std::span<T> out;
  TimedRun(const Points& points, std::size_t count)
      : slab(points.columns.size(), count), out(slab.output(), count) {
    for (std::size_t k = 0; k < points.columns.size(); ++k) {
      in.push_back(slab.column(k));
      for (std::size_t n = 0; n < count; ++n) slab.column(k)[n] = T(points.columns[k][n % points.count()]);
    }
  }
};

std::vector<timing::Timing> costs_of(const Question& question, const Points& everyday,
                                     const MeasureOptions& options) {
  const std::size_t count = question.timed_points;
  const Points points = question.timed.axes.empty() ? everyday : sample(question.timed, 4 * count);
  TimedRun<double> wide(points, count);
  TimedRun<float> narrow(points, count);
  std::vector<std::function<void()>> calls;
  for (const Choice& choice : question.choices) {
    if (choice.cost == Precision::double_)
      calls.push_back([&] {
        choice.kernel.in_double(wide.in, wide.out);
        timing::keep(wide.out[0]);
      });
    else
      calls.push_back([&] {
        choice.kernel.in_float(narrow.in, narrow.out);
        timing::keep(narrow.out[0]);
      });
  }
  timing::Options timing_options;
  timing_options.rounds = options.rounds;
  timing_options.clock = timing::Clock::thread;
  if (question.unit != Unit::evaluation) timing_options.neighbours = 4;  // long calls
  return timing::interleaved(calls, timing_options);
}

const Kernel& judged_by(const Choice& choice) {
  return choice.judged ? choice.judged : choice.kernel;
}

double largest(std::span<const double> values) {
  double most = 0;
  for (double v : values) most = std::max(most, std::abs(v));
  return most;
}

}  // namespace

Error error_of(std::span<const double> values, std::span<const double> reference, Measure measure,
               double floor, const Domain& domain, const Points& points) {
  Error error;
  error.measure = measure;
  std::vector<double> distances;
  const double peak = measure == Measure::of_peak ? largest(reference) : 1;
  std::size_t worst = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (measure == Measure::relative && !(std::abs(reference[k]) > floor)) continue;
    const double scale = measure == Measure::relative ? std::abs(reference[k]) : peak;
    const double d = std::isfinite(values[k]) ? std::abs(values[k] - reference[k]) / scale : kNotFinite;
    if (distances.empty() || d > error.max) error.max = d, worst = k;
    error.mean += d;
    distances.push_back(d);
  }
  if (distances.empty()) return error;
  error.mean /= double(distances.size());
  std::ranges::sort(distances);
  error.p99 = timing::quantile(distances, 0.99);
  error.where = describe(domain, points.at[worst]);
  return error;
}

double image_error(std::span<const double> f, std::span<const double> exact, const PicturePoints& picture) {
  double difference = 0, total = 0;
  for (std::size_t k = 0; k < picture.count();) {
    double l = 0, l_exact = 0;
    for (const std::size_t pixel = picture.pixel[k]; k < picture.count() && picture.pixel[k] == pixel; ++k) {
      const double w = picture.weight[k] * row_at<DirectionRow>(picture.columns, k).wi.z;
      l += w * f[k];
      l_exact += w * exact[k];
    }
    difference += std::abs(l - l_exact);
    total += l_exact;
  }
  return total > 0 ? difference / total : 0;
}

void set_cost(LedgerRow& row, const timing::Timing& t, double units) {
  row.cost = {t.lower / units, t.spread(), t.rounds, t.ratio_spread};
  row.cost_ratio = t.ratio;
}

PicturePoints thinned(const PicturePoints& picture, std::size_t count) {
  const std::size_t step = std::max<std::size_t>(1, picture.count() / count);
  PicturePoints fewer;
  for (std::size_t k = step / 2; k < picture.count(); k += step) {
    append(fewer.columns, fields_of(row_at<DirectionRow>(picture.columns, k)));
    fewer.weight.push_back(picture.weight[k]);
    fewer.pixel.push_back(picture.pixel[k]);
  }
  return fewer;
}

Yardstick::Yardstick(ErrorDomains domains, const Values& exact, const PicturePoints* picture,
                     const Values& exact_picture)
    : domains_(std::move(domains)),
      everyday_(place(domains_.everyday, domains_.points, exact)),
      picture_(exact_picture ? picture : nullptr) {
  for (const Domain& extreme : domains_.extremes)
    extremes_.push_back(place(extreme, domains_.extreme_points, exact));
  if (picture_) exact_picture_ = exact_picture(picture_->columns);
}

Yardstick::Place Yardstick::place(const Domain& domain, std::size_t count, const Values& exact) const {
  Points points = sample(domain, count);
  std::vector<double> values = exact(points.columns);
  return {domain, std::move(points), std::move(values)};
}

Error Yardstick::error(const Place& place, const Values& values) const {
  return error_of(values ? values(place.points.columns) : place.exact, place.exact, domains_.measure,
                  domains_.floor, place.domain, place.points);
}

void Yardstick::judge(LedgerRow& row, const Values& values, const Values& in_picture) const {
  row.domain = describe(everyday_.domain);
  row.error = error(everyday_, values);
  for (const Place& extreme : extremes_)
    row.extremes.push_back({describe(extreme.domain), error(extreme, values).max});
  if (picture_ && in_picture)
    row.image_error = image_error(in_picture(picture_->columns), exact_picture_, *picture_);
}

std::vector<LedgerRow> measure(const Question& question, const MeasureOptions& options) {
  const std::size_t count = question.points ? std::min(question.points, options.points) : options.points;
  const Choice& exact = question.choices.front();
  PicturePoints fewer;
  if (options.picture && question.pixels) fewer = thinned(*options.picture, question.pixels);
  const Yardstick yardstick(
      {question.everyday, question.extremes, count, count / 4, question.measure, question.floor},
      kernel_values(question.reference ? question.reference : judged_by(exact), Precision::double_),
      options.picture && question.pixels ? &fewer : options.picture,
      kernel_values(exact.picture, Precision::double_));
  const std::vector<timing::Timing> costs = costs_of(question, yardstick.points(), options);

  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < question.choices.size(); ++k) {
    const Choice& choice = question.choices[k];
    LedgerRow row;
    row.question = question.name;
    row.choice = choice.name;
    row.exact = exact.name;
    row.unit = question.unit;
    row.quantity = question.quantity;
    row.note = choice.note;
    set_cost(row, costs[k], double(question.timed_points));
    // An exact choice without a better reference is the reference itself and need not be evaluated again.
    const bool is_reference = k == 0 && !question.reference && choice.error == Precision::double_;
    yardstick.judge(row, is_reference ? Values{} : kernel_values(judged_by(choice), choice.error),
                    kernel_values(choice.picture, choice.error));
    rows.push_back(std::move(row));
  }
  mark_dominated(rows);
  return rows;
}

}  // namespace brdf::trade
