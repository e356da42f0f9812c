#include "trade/recommend/recommend.h"
#include "brdf/forms.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "io/error.h"
#include "io/material_json.h"
#include "trade/questions/fits.h"
#include "trade/questions/variants.h"
#include "trade/recommend/reasons.h"

namespace brdf::trade {
namespace {

constexpr std::size_t kFitRows = 2500;
const std::string kFamilies = families_question(cook_torrance{});

bool looks_like_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  char c = 0;
  file >> std::ws;
  return file.get(c) && c == '{';
}

RgbFunction read_reference(const std::filesystem::path& path) {
  if (looks_like_json(path)) return rgb_function(io::read_material(path));
  return rgb_function(io::read_samples(path));
}

// ns per evaluation by form and by variant.
class Costs {
 public:
  Costs(const std::filesystem::path& file, const std::vector<Reflectance>& forms) {
    Ledger measured;
    if (file.empty()) {
      const EvaluationTimes times = evaluation_times(forms, 41);
      for (std::size_t k = 0; k < forms.size(); ++k) {
        LedgerRow row;
        row.question = kFamilies;
        row.choice = info(forms[k]).name;
        set_cost(row, times.timings[k], times.count);
        measured.rows.push_back(row);
      }
      MeasureOptions options;
      options.points = 256;
      for (const Question& q : variant_questions())
        for (LedgerRow& row : measure(q, options)) measured.rows.push_back(std::move(row));
      ledger_ = std::move(measured);
    } else {
      ledger_ = read_ledger(file);
    }
  }
  double of_form(std::string_view form) const { return row(kFamilies, form).cost.seconds * 1e9; }
  double of_variant(std::string_view variant) const {
    return of_form("cook_torrance") * row(kVariantQuestion, variant).cost_ratio;
  }

 private:
  const LedgerRow& row(const std::string& question, std::string_view choice) const {
    const LedgerRow* found = ledger_.find(question, choice);
    if (!found)
      throw InputError("the ledger has no row '" + std::string(choice) + "' under '" + question +
                       "': write it anew with `brdf trade -o`");
    return *found;
  }
  Ledger ledger_;
};

// mean |f - g| cos_i / mean g cos_i over both hemispheres up to 85 degrees.
double brdf_error(const RgbFunction& model, const RgbFunction& reference) {
  static const Points points = sample(direction_domain({"-", 0, 0}, {"-", 0, 0}, 85), 4096);
  double difference = 0, total = 0;
  for (std::size_t k = 0; k < points.count(); ++k) {
    const auto at = [&](std::size_t c) { return points.columns[c][k]; };
    const Vec3<double> wi{at(0), at(1), at(2)}, wo{at(3), at(4), at(5)};
    const auto f = model(wi, wo), g = reference(wi, wo);
    for (std::size_t c = 0; c < 3; ++c) {
      difference += std::abs(f[c] - g[c]) * wi.z;
      total += g[c] * wi.z;
    }
  }
  return total > 0 ? difference / total : 0;
}

Candidate form_candidate(const Reflectance& form, const io::SampleTable& table, bool anisotropic,
                         const Costs& costs) {
  Candidate c;
  c.form = info(form).name;
  c.anisotropic = anisotropic;
  c.cost_ns = costs.of_form(c.form);
  c.material = fit_to_picture(form, table, anisotropic);
  c.reflectance = rgb_function(c.material);
  return c;
}

Candidate variant_candidate(const std::string& name, const io::SampleTable& table, const Costs& costs) {
  FittedVariant fitted = fit_variant(name, table);
  Candidate c;
  c.form = "cook_torrance";
  c.choice = name;
  c.cost_ns = costs.of_variant(name);
  c.material = make_material(cook_torrance{}, {"r", "g", "b"});
  c.material.terms[0].shape[0] = {fitted.alpha, fitted.alpha};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto w = SchlickWeights<double>::from_linear(fitted.weights[k]);
    c.material.terms[0].weights[k] = {w.kd, w.ks, w.f0};
  }
  c.reflectance = std::move(fitted.reflectance);
  return c;
}

// Renders the model's picture beside the reference's, and keeps both.
double rendered(Recommendation& r, Candidate& c, const SceneView& view, const RgbFunction& reference) {
  RenderedPair pair = render_both(view, c.reflectance, reference);
  r.picture = std::move(pair.model);
  r.reference_picture = std::move(pair.reference);
  c.rendered_error = pair.image_error;
  return pair.image_error;
}

// The cheapest that meets the tolerance, by the pixels' directions and then by two pictures.
void choose(Recommendation& r, const RecommendOptions& options, const SceneView& view,
            const RgbFunction& reference) {
  for (std::size_t k = 0; k < r.candidates.size(); ++k)
    if (judged(r.candidates[k], options.judge) < judged(r.candidates[r.best], options.judge)) r.best = k;
  for (std::size_t k = 0; k < r.candidates.size() && !r.chosen; ++k) {
    Candidate& c = r.candidates[k];
    const bool affordable = options.max_cost_ns <= 0 || c.cost_ns <= options.max_cost_ns;
    if (!affordable || judged(c, options.judge) > options.tolerance) continue;
    if (rendered(r, c, view, reference) <= options.tolerance || options.judge == Judge::brdf) r.chosen = k;
  }
  if (!r.chosen) rendered(r, r.candidates[r.best], view, reference);
}

}  // namespace

const Candidate& shown(const Recommendation& r) {
  return r.candidates[r.chosen.value_or(r.best)];
}

std::string Candidate::label() const {
  return form + (anisotropic ? ", two widths" : "") + (choice.empty() ? "" : ", " + choice);
}

Recommendation recommend(const RecommendOptions& options) {
  Recommendation r;
  r.tolerance = options.tolerance;
  r.metric = options.judge == Judge::image ? "image" : "brdf";
  r.costs_from = options.ledger.empty() ? "measured now" : options.ledger.filename().string();
  options.progress(0, "reference and scene");
  const RgbFunction reference = read_reference(options.reference);
  const SceneView view = view_of(render::load_scene(options.scene));
  if (view.points.empty()) throw InputError(options.scene.string() + ": no pixel shows a lit surface");
  r.coverage = coverage_of(view);
  const io::SampleTable table = scene_samples(view, reference, kFitRows);
  const std::vector<Reflectance> forms = fittable_forms();
  const Costs costs(options.ledger, forms);
  for (std::size_t k = 0; k < forms.size(); ++k) {
    options.progress(0.05 + 0.7 * double(k) / double(forms.size()), std::string(info(forms[k]).name));
    r.candidates.push_back(form_candidate(forms[k], table, false, costs));
    if (info(forms[k]).anisotropic()) r.candidates.push_back(form_candidate(forms[k], table, true, costs));
  }
  for (const std::string& name : variant_names()) {
    options.progress(0.8, name);
    r.candidates.push_back(variant_candidate(name, table, costs));
  }
  for (Candidate& c : r.candidates) {
    c.image_error = image_error(view, c.reflectance, reference);
    c.brdf_error = brdf_error(c.reflectance, reference);
  }
  std::stable_sort(r.candidates.begin(), r.candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost_ns < b.cost_ns; });
  options.progress(0.9, "rendering both");
  choose(r, options, view, reference);
  explain(r, options);
  options.progress(1, "");
  return r;
}

}  // namespace brdf::trade
