#include "trade/questions/fits.h"

#include <algorithm>
#include <cmath>

#include "fit/fit.h"
#include "io/files/numbers.h"
#include "synth/random.h"
#include "trade/questions/materials.h"
#include "trade/questions/names.h"

namespace brdf::trade {
namespace {

fit::FitOptions over_all_directions(fit::Metric metric) {
  fit::FitOptions options;
  options.metric = metric;
  options.max_theta = 90;
  options.cross_validation = false;
  return options;
}

// Returns a yardstick that measures errors against the values of a material.
Yardstick yardstick_of(const Material& truth, std::size_t points, const PicturePoints* picture) {
  const ErrorDomains domains{direction_domain(0, 80), {direction_domain(80, 89.5)}, points, 2048};
  return {domains, values_of(truth), picture, values_of(truth)};
}

// A fit of the reference form to samples of a material.
struct SampleFit {
  std::string name;
  io::SampleTable table;
  fit::FitOptions options;
  Material result = {};
};

std::vector<SampleFit> sample_fits(const Material& truth, bool quick) {
  const struct {
    const char* name;
    std::size_t count;
    fit::Metric metric;
  } cases[] = {{quick ? "2e5 samples" : "1e6 samples", quick ? 200000ul : 1000000ul, fit::Metric::log},
               {"1e5 samples", 100000, fit::Metric::log},
               {"1e4 samples", 10000, fit::Metric::log},
               {names::kThousandSamples, 1000, fit::Metric::log},
               {"1e2 samples", 100, fit::Metric::log},
               {"1e4 samples, cosine_l2", 10000, fit::Metric::cosine_l2},
               {"1e4 samples, cube_root", 10000, fit::Metric::cube_root},
               {"1e4 samples, log_relative", 10000, fit::Metric::log_relative}};
  std::vector<SampleFit> fits;
  for (const auto& [name, count, metric] : cases)
    fits.push_back({name, sample_material(truth, count, 0.05), over_all_directions(metric)});
  return fits;
}

std::vector<timing::Timing> run(std::vector<SampleFit>& fits) {
  std::vector<std::function<void()>> calls;
  for (SampleFit& f : fits)
    calls.push_back(
        [&f] { f.result = fit::fit(f.table, {{reference_form()}}, f.options).ranking.front().material; });
  timing::Options options;
  options.clock = timing::Clock::thread;
  options.least_seconds = 0;
  options.neighbours = calls.size();
  return timing::interleaved(calls, options);
}

}  // namespace

io::SampleTable sample_material(const Material& material, std::size_t rows, double noise, double most_theta) {
  io::SampleTable table;
  table.set_channels({"fr"});
  table.reserve(rows);
  synth::NormalPairs normal(1);
  std::vector<double> value(material.channels.size());
  const double least_cosine = std::cos(degrees(most_theta).radians());
  const auto add = [&](const Domain& domain, std::size_t count) {
    const Points points = sample(domain, 2 * count + 64);
    for (std::size_t k = 0, added = 0; k < points.count() && added < count; ++k) {
      const auto row = row_at<DirectionRow>(points.columns, k);
      if (row.wi.z < least_cosine || row.wo.z < least_cosine) continue;
      eval(material, row.wi, row.wo, value);
      table.add_directions(row.wi, row.wo);
      const double factor = noise > 0 ? std::exp(noise * normal.next().first - noise * noise / 2) : 1;
      table.values[0].push_back(value[0] * factor);
      ++added;
    }
  };
  // Half of the rows are anywhere, the other half within a few degrees to tens of degrees of the mirror
  // direction.
  add(direction_domain(0, most_theta), rows / 2);
  add(lobe_domain({"width", 0.02, 0.5, true}, 2, most_theta), rows - rows / 2);
  return table;
}

Material fitted(const Reflectance& form, const io::SampleTable& table, bool anisotropic) {
  fit::FitOptions options = over_all_directions(fit::Metric::log_relative);
  options.weighting = fit::Weighting::uniform;
  options.anisotropic = anisotropic;
  options.profiles = false;
  return fit::fit(table, {{form}}, options).ranking.front().material;
}

std::vector<Reflectance> fittable_forms() {
  std::vector<Reflectance> forms;
  for (const auto& model : fit::every_model()) forms.push_back(model.front());
  return forms;
}

std::string families_question(const Reflectance& family) {
  return names::families(info(family).name);
}

std::vector<LedgerRow> family_rows(const Reflectance& family, const EvaluationTimes& times,
                                   const FitRowsOptions& options) {
  const std::vector<Reflectance> forms = fittable_forms();
  const auto own = std::size_t(std::ranges::find(forms, family) - forms.begin());
  const Material truth = make_material(family, {"fr"});
  const io::SampleTable table = sample_material(truth, options.quick ? 1000 : 4000, 0);
  const Yardstick yardstick = yardstick_of(truth, options.quick ? 2048 : 8192, options.picture);
  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < forms.size(); ++k) {
    const Material other = k == own ? truth : fitted(forms[k], table);
    LedgerRow row;
    row.question = families_question(family);
    row.choice = info(forms[k]).name;
    row.exact = info(family).name;
    row.quantity = "f_r";
    set_cost(row, times.timings[k], times.count);
    row.cost_ratio /= times.timings[own].ratio;
    yardstick.judge(row, values_of(other), values_of(other));
    row.domain += "; at the table's defaults, refitted to noise-free samples";
    rows.push_back(std::move(row));
  }
  mark_dominated(rows);
  return rows;
}

std::vector<LedgerRow> sample_count_rows(const FitRowsOptions& options) {
  Material truth = make_material(reference_form(), {"fr"});
  set_parameter(truth, Role::width, 0.1);
  set_parameter(truth, Role::diffuse, 0.2);
  set_parameter(truth, Role::specular, 0.8);
  set_parameter(truth, Role::f0, 0.2);
  std::vector<SampleFit> fits = sample_fits(truth, options.quick);
  const std::vector<timing::Timing> timings = run(fits);
  const Yardstick yardstick = yardstick_of(truth, 8192, options.picture);
  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < fits.size(); ++k) {
    const Term& term = fits[k].result.terms[0];
    const ReflectanceInfo& about = info(term.form);
    LedgerRow row;
    row.question = names::kSampleCounts;
    row.choice = fits[k].name;
    row.exact = fits[0].name;
    row.unit = Unit::fit;
    row.quantity = "f_r, against the truth";
    row.note = std::string(fits[k].options.metric == fit::Metric::log ? "log" : "other") + " residual; " +
               std::string(about.tied_name()) + " " +
               io::short_number(term.shape[0][std::size_t(about.shape_index(Role::width))], 5);
    set_cost(row, timings[k], 1);
    const Values values = values_of(fits[k].result);
    yardstick.judge(row, values, values);
    row.domain += "; " + described(truth) + ", noise 5 %";
    rows.push_back(std::move(row));
  }
  mark_dominated(rows);
  return rows;
}

}  // namespace brdf::trade
