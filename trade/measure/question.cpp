#include "trade/measure/question.h"

#include <algorithm>
#include <cmath>

namespace brdf::trade {
namespace {

std::vector<double> values_of(const Kernel& kernel, const Columns<double>& in, std::size_t count,
                              Precision precision) {
  std::vector<double> out(count);
  if (precision == Precision::double_) {
    kernel.in_double(pointers(in), out);
    return out;
  }
  Columns<float> narrow;
  for (std::size_t k = 0; k < kInputs; ++k) narrow[k].assign(in[k].begin(), in[k].end());
  std::vector<float> result(count);
  kernel.in_float(pointers(narrow), result);
  std::copy(result.begin(), result.end(), out.begin());
  return out;
}

// The first points of the domain, again and again until there are enough, in one precision.
template <class T>
struct TimedRun {
  Slab<T> slab;
  Inputs<T> in;
  std::span<T> out;
  TimedRun(const Points& points, std::size_t count) : slab(kInputs, count), out(slab.output(), count) {
    for (std::size_t k = 0; k < kInputs; ++k) {
      in[k] = slab.column(k);
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
  return choice.judged.in_double ? choice.judged : choice.kernel;
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
  std::sort(distances.begin(), distances.end());
  error.p99 = timing::quantile(distances, 0.99);
  error.where = describe(domain, points.at[worst]);
  return error;
}

double image_error(std::span<const double> f, std::span<const double> exact, const PicturePoints& picture) {
  double difference = 0, total = 0;
  for (std::size_t k = 0; k < picture.count();) {
    double l = 0, l_exact = 0;
    for (const std::size_t pixel = picture.pixel[k]; k < picture.count() && picture.pixel[k] == pixel; ++k) {
      const double w = picture.weight[k] * picture.columns[2][k];
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
    for (std::size_t c = 0; c < kInputs; ++c) fewer.columns[c].push_back(picture.columns[c][k]);
    fewer.weight.push_back(picture.weight[k]);
    fewer.pixel.push_back(picture.pixel[k]);
  }
  return fewer;
}

std::vector<LedgerRow> measure(const Question& question, const MeasureOptions& options) {
  const std::size_t count = question.points ? std::min(question.points, options.points) : options.points;
  const Points points = sample(question.everyday, count);
  const Choice& exact = question.choices.front();
  const auto reference_of = [&](const Points& p) {
    return values_of(question.reference.in_double ? question.reference : judged_by(exact), p.columns,
                     p.count(), Precision::double_);
  };
  const std::vector<double> reference = reference_of(points);
  const std::vector<timing::Timing> costs = costs_of(question, points, options);
  options.tick();

  PicturePoints fewer;
  if (options.picture && question.pixels) fewer = thinned(*options.picture, question.pixels);
  const PicturePoints* const picture = question.pixels ? &fewer : options.picture;
  std::vector<double> exact_picture;
  if (picture && exact.picture.in_double)
    exact_picture = values_of(exact.picture, picture->columns, picture->count(), Precision::double_);

  struct Extremity {
    const Domain* domain;
    Points points;
    std::vector<double> reference;
  };
  std::vector<Extremity> extremities;
  for (const Domain& extreme : question.extremes) {
    Points there = sample(extreme, count / 4);
    std::vector<double> values = reference_of(there);
    extremities.push_back({&extreme, std::move(there), std::move(values)});
  }

  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < question.choices.size(); ++k) {
    const Choice& choice = question.choices[k];
    LedgerRow row;
    row.question = question.name;
    row.choice = choice.name;
    row.exact = exact.name;
    row.unit = question.unit;
    set_cost(row, costs[k], double(question.timed_points));
    // An exact choice without a better reference is the reference: no need to evaluate it again.
    const bool is_reference = k == 0 && !question.reference.in_double && choice.error == Precision::double_;
    const auto values_on = [&](const Points& p, const std::vector<double>& known) {
      return is_reference ? known : values_of(judged_by(choice), p.columns, p.count(), choice.error);
    };
    row.error = error_of(values_on(points, reference), reference, question.measure, question.floor,
                         question.everyday, points);
    row.quantity = question.quantity;
    row.domain = describe(question.everyday);
    row.note = choice.note;
    if (!exact_picture.empty() && choice.picture.in_double)
      row.image_error =
          image_error(values_of(choice.picture, picture->columns, picture->count(), choice.error),
                      exact_picture, *picture);
    for (const Extremity& e : extremities)
      row.extremes.push_back(
          {describe(*e.domain), error_of(values_on(e.points, e.reference), e.reference, question.measure,
                                         question.floor, *e.domain, e.points)
                                    .max});
    rows.push_back(std::move(row));
  }
  mark_dominated(rows);
  options.tick();
  return rows;
}

}  // namespace brdf::trade
