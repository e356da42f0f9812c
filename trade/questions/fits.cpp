#include "trade/questions/fits.h"
#include "brdf/forms.h"

#include <algorithm>
#include <cmath>

#include "fit/fit.h"
#include "synth/random.h"

namespace brdf::trade {
namespace {

fit::FitOptions relative_metric(bool anisotropic) {
  fit::FitOptions options;
  options.metric = fit::Metric::log_relative;
  options.weighting = fit::Weighting::uniform;
  options.max_theta = 90;
  options.anisotropic = anisotropic;
  options.cross_validation = false;
  return options;
}

}  // namespace

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
      table.add_directions(polar(wi), azimuth(wi), polar(wo), azimuth(wo));
      const double factor = noise > 0 ? std::exp(noise * normal.next().first - noise * noise / 2) : 1;
      table.values[0].push_back(value[0] * factor);
      ++added;
    }
  };
  add(anywhere, rows / 2);
  add(mirror, rows - rows / 2);
  return table;
}

Material fitted(const Reflectance& form, const io::SampleTable& table, bool anisotropic) {
  return fit::fit(table, {{form}}, relative_metric(anisotropic)).ranking.front().material;
}

std::vector<Reflectance> fittable_forms() {
  std::vector<Reflectance> forms;
  for (const auto& model : fit::every_model()) forms.push_back(model.front());
  return forms;
}

std::string families_question(const Reflectance& family) {
  return "families for a material of " + std::string(info(family).name);
}

std::vector<LedgerRow> family_rows(const Reflectance& family, const EvaluationTimes& times,
                                   const FitRowsOptions& options) {
  const std::vector<Reflectance> forms = fittable_forms();
  const Domain domain = pairs_domain(0, 80), grazing = pairs_domain(80, 89.5);
  const Points points = sample(domain, options.quick ? 2048 : 8192), extreme = sample(grazing, 2048);
  const auto own = std::size_t(std::find(forms.begin(), forms.end(), family) - forms.begin());
  const Material truth = make_material(family, {"fr"});
  const io::SampleTable table = sample_material(truth, options.quick ? 1000 : 4000, 0);
  const std::vector<double> reference = values_at(truth, points.columns, points.count()),
                            beyond = values_at(truth, extreme.columns, extreme.count()),
                            picture = values_at(truth, options.picture->columns, options.picture->count());
  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < forms.size(); ++k) {
    const Material other = k == own ? truth : fitted(forms[k], table);
    LedgerRow row;
    row.question = families_question(family);
    row.choice = info(forms[k]).name;
    row.exact = info(family).name;
    set_cost(row, times.timings[k], times.count);
    row.cost_ratio /= times.timings[own].ratio;
    row.error = error_of(values_at(other, points.columns, points.count()), reference, Measure::relative, 0,
                         domain, points);
    row.extremes.push_back({describe(grazing), error_of(values_at(other, extreme.columns, extreme.count()),
                                                        beyond, Measure::relative, 0, grazing, extreme)
                                                   .max});
    row.quantity = "f_r";
    row.image_error = image_error(values_at(other, options.picture->columns, options.picture->count()),
                                  picture, *options.picture);
    row.domain = describe(domain) + "; at the table's defaults, refitted to noise-free samples";
    rows.push_back(std::move(row));
  }
  mark_dominated(rows);
  return rows;
}

std::vector<LedgerRow> sample_count_rows(const FitRowsOptions& options) {
  Material truth = make_material(cook_torrance{}, {"fr"});
  truth.terms[0].shape[0] = {0.1, 0.1};
  truth.terms[0].weights[0] = {0.2, 0.8, 0.2};
  const Domain domain = pairs_domain(0, 80), grazing = pairs_domain(80, 89.5);
  const Points points = sample(domain, 8192), extreme = sample(grazing, 2048);
  const std::vector<double> reference = values_at(truth, points.columns, points.count()),
                            beyond = values_at(truth, extreme.columns, extreme.count());
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
  add("1e6 samples", options.quick ? 200000 : 1000000, fit::Metric::log);
  if (options.quick) cases.back().name = "2e5 samples";
  add("1e5 samples", 100000, fit::Metric::log);
  add("1e4 samples", 10000, fit::Metric::log);
  add("1e3 samples", 1000, fit::Metric::log);
  add("1e2 samples", 100, fit::Metric::log);
  add("1e4 samples, cosine_l2", 10000, fit::Metric::cosine_l2);
  add("1e4 samples, cube_root", 10000, fit::Metric::cube_root);
  add("1e4 samples, log_relative", 10000, fit::Metric::log_relative);
  std::vector<std::function<void()>> calls;
  for (Case& c : cases)
    calls.push_back([&c] {
      c.result = fit::fit(c.table, {{Reflectance(cook_torrance{})}}, c.options).ranking.front().material;
    });
  timing::Options clock;
  clock.clock = timing::Clock::thread;
  clock.least_seconds = 0;
  clock.neighbours = calls.size();
  const std::vector<timing::Timing> timings = timing::interleaved(calls, clock);
  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    LedgerRow row;
    row.question = "samples for a fit";
    row.choice = cases[k].name;
    row.exact = cases[0].name;
    row.unit = Unit::fit;
    set_cost(row, timings[k], 1);
    row.error = error_of(values_at(cases[k].result, points.columns, points.count()), reference,
                         Measure::relative, 0, domain, points);
    row.extremes.push_back(
        {describe(grazing), error_of(values_at(cases[k].result, extreme.columns, extreme.count()), beyond,
                                     Measure::relative, 0, grazing, extreme)
                                .max});
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

}  // namespace brdf::trade
