#include "trade/fits.h"

#include <cmath>

#include "brdf/batch.h"
#include "fit/fit.h"
#include "synth/random.h"
#include "trade/timing.h"

namespace brdf::trade {
namespace {

constexpr std::size_t kBatch = 1024;

template <class T>
DirectionArrays<T> spread_directions(std::size_t count, double most_theta) {
  const Points points = sample(direction_domain({"-", 0, 0}, {"-", 0, 0}, most_theta), count);
  DirectionArrays<T> arrays(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = [&](std::size_t c) { return T(points.columns[c][k % points.count()]); };
    arrays.set(k, {at(0), at(1), at(2)}, {at(3), at(4), at(5)});
  }
  return arrays;
}

template <class T>
std::vector<T> defaults(std::span<const ParameterInfo> table) {
  std::vector<T> values;
  for (const ParameterInfo& p : table) values.push_back(T(p.initial));
  return values;
}

Cost cost_of(const timing::Timing& t, double units) {
  return {t.lower / units, t.spread(), t.rounds};
}

timing::Options thread_timing(int rounds) {
  timing::Options options;
  options.rounds = rounds;
  options.clock = timing::Clock::thread;
  return options;
}

// f_r of one channel at every point.
std::vector<double> values_at(const Material& material, const Columns<double>& in, std::size_t count) {
  std::vector<double> out(count), channels(material.channels.size());
  for (std::size_t k = 0; k < count; ++k) {
    eval(material, {in[0][k], in[1][k], in[2][k]}, {in[3][k], in[4][k], in[5][k]}, channels);
    out[k] = channels[0];
  }
  return out;
}

fit::FitOptions relative_metric(bool anisotropic) {
  fit::FitOptions options;
  options.metric = fit::Metric::kLogRelative;
  options.weighting = fit::Weighting::kUniform;
  options.max_theta = 90;
  options.anisotropic = anisotropic;
  options.cross_validation = false;
  return options;
}

}  // namespace

std::vector<Cost> evaluation_costs(const std::vector<AnyForm>& forms, int rounds) {
  const DirectionArrays<float> directions = spread_directions<float>(kBatch, 80);
  std::vector<float> out(kBatch);
  std::vector<std::vector<float>> parameters;
  std::vector<std::function<void()>> calls;
  for (const AnyForm& form : forms) {
    const BatchKernels<float>& kernels = batch_kernels<float>(form);
    calls.push_back(
        [&, weights = defaults<float>(info(form).weights), shape = defaults<float>(info(form).shape)] {
          kernels.eval(weights, weights, shape, directions.view(), out.data());
          timing::keep(out[0]);
        });
  }
  std::vector<Cost> costs;
  for (const timing::Timing& t : timing::interleaved(calls, thread_timing(rounds)))
    costs.push_back(cost_of(t, double(kBatch)));
  return costs;
}

io::SampleTable sample_material(const Material& material, std::size_t rows, double noise, double most_theta) {
  // Half the rows anywhere, half within a few degrees to tens of degrees of the mirror direction.
  const Domain anywhere = direction_domain({"-", 0, 0}, {"-", 0, 0}, most_theta);
  const Domain mirror = lobe_domain({"alpha", 0.02, 0.5, true}, {"-", 0, 0}, 2, most_theta);
  io::SampleTable table;
  table.channels = {"fr"};
  table.values.resize(1);
  table.sigma.resize(1);
  table.reserve(rows);
  synth::NormalPairs normal(1);
  std::vector<double> value(material.channels.size());
  const auto add = [&](const Domain& domain, std::size_t count) {
    const Points points = sample(domain, 2 * count + 64);
    for (std::size_t k = 0, added = 0; k < points.count() && added < count; ++k) {
      Vec3<double> wi{points.columns[0][k], points.columns[1][k], points.columns[2][k]};
      Vec3<double> wo{points.columns[3][k], points.columns[4][k], points.columns[5][k]};
      const double least = std::cos(most_theta * kPi / 180);
      if (wi.z < least || wo.z < least) continue;
      eval(material, wi, wo, value);
      const auto polar = [](const Vec3<double>& w) { return std::acos(std::min(1.0, w.z)) * 180 / kPi; };
      const auto azimuth = [](const Vec3<double>& w) { return std::atan2(w.y, w.x) * 180 / kPi; };
      table.theta_i.push_back(polar(wi));
      table.phi_i.push_back(azimuth(wi));
      table.theta_o.push_back(polar(wo));
      table.phi_o.push_back(azimuth(wo));
      const double factor = noise > 0 ? std::exp(noise * normal.next().first - noise * noise / 2) : 1;
      table.values[0].push_back(value[0] * factor);
      ++added;
    }
  };
  add(anywhere, rows / 2);
  add(mirror, rows - rows / 2);
  return table;
}

Material fitted(const AnyForm& form, const io::SampleTable& table, bool anisotropic) {
  return fit::fit(table, {{form}}, relative_metric(anisotropic)).ranking.front().material;
}

std::vector<LedgerRow> family_rows(const FitRowsOptions& options) {
  std::vector<AnyForm> forms;
  for (const auto& model : fit::every_model()) forms.push_back(model.front());
  const std::vector<Cost> costs = evaluation_costs(forms, options.quick ? 21 : 41);
  const Domain domain = [] {
    Domain d = direction_domain({"-", 0, 0}, {"-", 0, 0}, 80);
    d.axes.resize(3);
    d.inputs = [](std::span<const double> at, Row<double>& row) {
      return direction_row(at[0], at[1], at[2], 0, 0, row);
    };
    return d;
  }();
  const Points points = sample(domain, options.quick ? 2048 : 8192);
  std::vector<LedgerRow> rows;
  for (std::size_t r = 0; r < forms.size(); ++r) {
    if (!info(forms[r]).canonical) continue;
    const std::string name(info(forms[r]).name);
    options.tick("families for a material of " + name);
    const Material truth = make_material(forms[r], {"fr"});
    const io::SampleTable table = sample_material(truth, options.quick ? 1000 : 4000, 0);
    const std::vector<double> reference = values_at(truth, points.columns, points.count());
    const std::vector<double> picture = values_at(truth, options.picture->columns, options.picture->count());
    std::vector<LedgerRow> some;
    for (std::size_t k = 0; k < forms.size(); ++k) {
      const Material other = k == r ? truth : fitted(forms[k], table);
      LedgerRow row;
      row.question = "families for a material of " + name;
      row.choice = info(forms[k]).name;
      row.exact = name;
      row.cost = costs[k];
      row.cost_ratio = costs[k].seconds / costs[r].seconds;
      row.error = error_of(values_at(other, points.columns, points.count()), reference, Measure::relative, 0,
                           domain, points);
      row.quantity = "f_r";
      row.image_error = image_error(values_at(other, options.picture->columns, options.picture->count()),
                                    picture, *options.picture);
      row.domain = describe(domain) + "; at the table's defaults, refitted to noise-free samples";
      some.push_back(std::move(row));
    }
    mark_dominated(some);
    std::move(some.begin(), some.end(), std::back_inserter(rows));
  }
  return rows;
}

std::vector<LedgerRow> sample_count_rows(const FitRowsOptions& options) {
  Material truth = make_material(cook_torrance{}, {"fr"});
  truth.terms[0].shape[0] = {0.1, 0.1};
  truth.terms[0].weights[0] = {0.2, 0.8, 0.2};
  const Domain domain = direction_domain({"-", 0, 0}, {"-", 0, 0}, 80);
  const Points points = sample(domain, 8192);
  const std::vector<double> reference = values_at(truth, points.columns, points.count());
  const std::vector<double> picture = values_at(truth, options.picture->columns, options.picture->count());
  struct Case {
    std::string name;
    io::SampleTable table;
    fit::FitOptions options;
    Material result;
  };
  std::vector<Case> cases;
  const auto add = [&](const char* name, std::size_t count, fit::Metric metric) {
    Case c{std::string(name), sample_material(truth, count, 0.05), {}, {}};
    c.options.metric = metric;
    c.options.max_theta = 90;
    c.options.cross_validation = false;
    cases.push_back(std::move(c));
  };
  options.tick("fits from 1e2 to 1e6 samples");
  add("1e6 samples", options.quick ? 200000 : 1000000, fit::Metric::kLog);
  if (options.quick) cases.back().name = "2e5 samples";
  add("1e5 samples", 100000, fit::Metric::kLog);
  add("1e4 samples", 10000, fit::Metric::kLog);
  add("1e3 samples", 1000, fit::Metric::kLog);
  add("1e2 samples", 100, fit::Metric::kLog);
  add("1e4 samples, cosine_l2", 10000, fit::Metric::kCosineL2);
  add("1e4 samples, cube_root", 10000, fit::Metric::kCubeRoot);
  add("1e4 samples, log_relative", 10000, fit::Metric::kLogRelative);
  std::vector<std::function<void()>> calls;
  for (Case& c : cases)
    calls.push_back([&c] {
      c.result = fit::fit(c.table, {{AnyForm(cook_torrance{})}}, c.options).ranking.front().material;
    });
  timing::Options clock = thread_timing(21);
  clock.least_seconds = 0;
  const std::vector<timing::Timing> timings = timing::interleaved(calls, clock);
  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    LedgerRow row;
    row.question = "samples for a fit";
    row.choice = cases[k].name;
    row.exact = cases[0].name;
    row.unit = Unit::fit;
    row.cost = cost_of(timings[k], 1);
    row.cost_ratio = timings[k].lower / timings[0].lower;
    row.error = error_of(values_at(cases[k].result, points.columns, points.count()), reference,
                         Measure::relative, 0, domain, points);
    row.quantity = "f_r, against the truth";
    row.image_error =
        image_error(values_at(cases[k].result, options.picture->columns, options.picture->count()), picture,
                    *options.picture);
    row.domain = describe(domain) + "; cook_torrance, alpha 0.1, kd 0.2, ks 0.8, f0 0.2, noise 5 %";
    char note[80];
    std::snprintf(note, sizeof note, "%s residual; alpha %.5f", k < 5 ? "log" : "other",
                  cases[k].result.terms[0].shape[0][0]);
    row.note = note;
    rows.push_back(std::move(row));
  }
  mark_dominated(rows);
  return rows;
}

std::vector<LedgerRow> batch_rows(const FitRowsOptions& options) {
  options.tick("batches against scalar");
  const AnyForm form = cook_torrance{};
  const DirectionArrays<double> wide = spread_directions<double>(kBatch, 80);
  const DirectionArrays<float> narrow = spread_directions<float>(kBatch, 80);
  const Material material = make_material(form, {"fr"});
  const std::vector<double> w = defaults<double>(info(form).weights), s = defaults<double>(info(form).shape);
  const std::vector<float> wf = defaults<float>(info(form).weights), sf = defaults<float>(info(form).shape);
  std::vector<double> scalar(kBatch), batch(kBatch);
  std::vector<float> batch_float(kBatch);
  const Directions<double> d = wide.view();
  const std::vector<std::function<void()>> calls{
      [&] {
        for (std::size_t k = 0; k < kBatch; ++k) eval(material, d.wi(k), d.wo(k), std::span(&scalar[k], 1));
        timing::keep(scalar[0]);
      },
      [&] {
        batch_kernels<double>(form).eval(w, w, s, d, batch.data());
        timing::keep(batch[0]);
      },
      [&] {
        batch_kernels<float>(form).eval(wf, wf, sf, narrow.view(), batch_float.data());
        timing::keep(batch_float[0]);
      }};
  const std::vector<timing::Timing> timings =
      timing::interleaved(calls, thread_timing(options.quick ? 21 : 41));
  const Domain domain = direction_domain({"-", 0, 0}, {"-", 0, 0}, 80);
  const Points points = sample(domain, kBatch);
  const std::vector<double> widened(batch_float.begin(), batch_float.end());
  const char* names[] = {"a material, pair by pair", "batch, double", "batch, float"};
  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < 3; ++k) {
    LedgerRow row;
    row.question = "one by one or in batches";
    row.choice = names[k];
    row.exact = names[0];
    row.cost = cost_of(timings[k], double(kBatch));
    row.cost_ratio = timings[k].lower / timings[0].lower;
    const std::vector<double>& values = k == 0 ? scalar : k == 1 ? batch : widened;
    row.error = error_of(std::span(values).first(std::min(values.size(), points.count())),
                         std::span(scalar).first(std::min(values.size(), points.count())), Measure::relative,
                         0, domain, points);
    row.quantity = "f_r";
    row.domain = describe(domain) + "; cook_torrance at its defaults";
    rows.push_back(std::move(row));
  }
  mark_dominated(rows);
  return rows;
}

}  // namespace brdf::trade
