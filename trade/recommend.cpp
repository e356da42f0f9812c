#include "trade/recommend.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "io/error.h"
#include "io/material_json.h"
#include "trade/fits.h"
#include "trade/variants.h"

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

Reflectance read_reference(const std::filesystem::path& path) {
  if (looks_like_json(path)) return reflectance_of(io::read_material(path));
  return reflectance_of(io::read_samples(path));
}

// ns per evaluation by form and by variant.
class Costs {
 public:
  Costs(const std::filesystem::path& file, const std::vector<AnyForm>& forms) {
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
double brdf_error(const Reflectance& model, const Reflectance& reference) {
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

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

Candidate form_candidate(const AnyForm& form, const io::SampleTable& table, bool anisotropic,
                         const Costs& costs) {
  Candidate c;
  c.form = info(form).name;
  c.anisotropic = anisotropic;
  c.cost_ns = costs.of_form(c.form);
  c.material = fit_to_picture(form, table, anisotropic);
  c.reflectance = reflectance_of(c.material);
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

double judged(const Candidate& c, Judge judge) {
  return judge == Judge::image ? c.image_error : c.brdf_error;
}

void explain(Recommendation& r, const RecommendOptions& options) {
  for (std::size_t k = 0; k < r.candidates.size(); ++k) {
    Candidate& c = r.candidates[k];
    const double error = judged(c, options.judge);
    if (r.chosen == k)
      c.reason = "the cheapest that meets the tolerance: error " + number(error);
    else if (error > options.tolerance)
      c.reason = "error " + number(error) + " is above the tolerance";
    else if (options.max_cost_ns > 0 && c.cost_ns > options.max_cost_ns)
      c.reason = "meets the tolerance, but " + number(c.cost_ns) + " ns is above the limit";
    else if (r.chosen)
      c.reason = "meets the tolerance, but costs " + number(c.cost_ns) + " ns against " +
                 number(r.candidates[*r.chosen].cost_ns);
  }
}

// Smallest error among candidates that `of` admits.
double best_error(const Recommendation& r, Judge judge, const std::function<bool(const Candidate&)>& of) {
  double best = 1e300;
  for (const Candidate& c : r.candidates)
    if (of(c)) best = std::min(best, judged(c, judge));
  return best;
}

void find_unneeded(Recommendation& r, const RecommendOptions& options) {
  const Coverage& v = r.coverage;
  const auto say = [&](const std::string& text) { r.unneeded.push_back(text); };
  if (v.most_theta_o < 75)
    say("no pixel sees theta_o above " + number(v.most_theta_o) + " degrees: grazing accuracy is not needed");
  if (v.most_theta_i < 75)
    say("no lit pixel has theta_i above " + number(v.most_theta_i) + " degrees: grazing light is not shown");
  if (v.most_theta_d < 40)
    say("theta_d stays below " + number(v.most_theta_d) +
        " degrees: the Fresnel rise is not shown, f0 and ks cannot be told apart");
  if (v.least_theta_h > 5)
    say("no half vector comes closer to the normal than " + number(v.least_theta_h) +
        " degrees: the highlight's peak is not shown");
  if (v.most_theta_h < 20)
    say("no half vector is farther from the normal than " + number(v.most_theta_h) +
        " degrees: the lobe's tail is not shown");
  if (v.azimuth_spread < 30)
    say("half vectors stay within " + number(v.azimuth_spread) + " degrees of azimuth " +
        number(v.azimuth_of_h) +
        ": the view never leaves one direction of the grain, anisotropy is not identifiable");
  const auto with = [&](auto test) { return best_error(r, options.judge, test); };
  const auto is_diffuse = [](const Candidate& c) {
    return c.form == "lambert" || c.form.rfind("oren_nayar", 0) == 0;
  };
  const double diffuse = with(is_diffuse),
               isotropic = with([](const Candidate& c) { return !c.anisotropic; });
  const double anisotropic = with([](const Candidate& c) { return c.anisotropic; });
  if (diffuse <= options.tolerance)
    say("a diffuse model already has error " + number(diffuse) + ": no specular lobe is needed");
  if (isotropic <= options.tolerance && anisotropic < 1e300)
    say("two widths instead of one change the best error from " + number(isotropic) + " to " +
        number(std::min(anisotropic, isotropic)) + ": anisotropy is not needed");
  const double no_fresnel =
      with([](const Candidate& c) { return c.choice.find("no Fresnel") != std::string::npos; });
  if (no_fresnel <= options.tolerance)
    say("without any Fresnel term the GGX model has error " + number(no_fresnel) + ": it is not needed");
  const double no_masking = with([](const Candidate& c) { return c.choice == "masking dropped"; });
  if (no_masking <= options.tolerance)
    say("with masking dropped the GGX model has error " + number(no_masking) + ": it is not needed");
}

}  // namespace

std::string Candidate::label() const {
  return form + (anisotropic ? ", two widths" : "") + (choice.empty() ? "" : ", " + choice);
}

Recommendation recommend(const RecommendOptions& options) {
  Recommendation r;
  r.tolerance = options.tolerance;
  r.metric = options.judge == Judge::image ? "image" : "brdf";
  r.costs_from = options.ledger.empty() ? "measured now" : options.ledger.filename().string();
  options.progress(0, "reference and scene");
  const Reflectance reference = read_reference(options.reference);
  const SceneView view = view_of(render::load_scene(options.scene));
  if (view.points.empty()) throw InputError(options.scene.string() + ": no pixel shows a lit surface");
  r.coverage = coverage_of(view);
  const io::SampleTable table = scene_samples(view, reference, kFitRows);
  const std::vector<AnyForm> forms = fittable_forms();
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
  for (std::size_t k = 0; k < r.candidates.size(); ++k) {
    const Candidate& c = r.candidates[k];
    const double error = judged(c, options.judge);
    if (error < judged(r.candidates[r.best], options.judge)) r.best = k;
    const bool affordable = options.max_cost_ns <= 0 || c.cost_ns <= options.max_cost_ns;
    if (!r.chosen && error <= options.tolerance && affordable) r.chosen = k;
  }
  options.progress(0.9, "rendering both");
  RenderedPair pair = render_both(view, r.candidates[r.chosen.value_or(r.best)].reflectance, reference);
  r.rendered_error = pair.image_error;
  r.picture = std::move(pair.model);
  r.reference_picture = std::move(pair.reference);
  explain(r, options);
  find_unneeded(r, options);
  options.progress(1, "");
  return r;
}

}  // namespace brdf::trade
