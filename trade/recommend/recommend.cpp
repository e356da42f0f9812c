#include "trade/recommend/recommend.h"

#include <algorithm>
#include <cmath>

#include "io/columns/foreign_json.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/formats/read.h"
#include "io/material/material_json.h"
#include "trade/questions/fits.h"
#include "trade/questions/variants.h"
#include "trade/recommend/costs.h"
#include "trade/recommend/reasons.h"

namespace brdf::trade {
namespace {

constexpr std::size_t kFitRows = 2500;

RgbFunction read_reference(const std::filesystem::path& path) {
  io::Content content = io::read_content(path);
  if (io::may_be_material(content)) return rgb_function(io::read_material(content));
  return rgb_function(io::read_samples(std::move(content)));
}

// Returns mean |f - g| cos_i / mean g cos_i over both hemispheres up to 85 degrees.
double brdf_error(const RgbFunction& model, const RgbFunction& reference) {
  static const Points points = sample(direction_domain(0, 85), 4096);
  double difference = 0, total = 0;
  for (std::size_t k = 0; k < points.count(); ++k) {
    const auto row = row_at<DirectionRow>(points.columns, k);
    const auto f = model(row.wi, row.wo), g = reference(row.wi, row.wo);
    for (std::size_t c = 0; c < 3; ++c) {
      difference += std::abs(f[c] - g[c]) * row.wi.z;
      total += g[c] * row.wi.z;
    }
  }
  return total > 0 ? difference / total : 0;
}

Candidate fitted_candidate(const Reflectance& model, bool anisotropic, const io::SampleTable& table) {
  Candidate c{.model = model, .anisotropic = anisotropic};
  c.material = fit_to_picture(model, table, anisotropic);
  c.values = rgb_function(c.material);
  return c;
}

// Fits every model with one width, and also with two if the model has two and the reference is anisotropic.
std::vector<Candidate> fitted_candidates(const std::vector<Reflectance>& models, const Costs& costs,
                                         const io::SampleTable& table, bool isotropic,
                                         const RecommendOptions& options) {
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < models.size(); ++k) {
    options.progress(0.05 + 0.8 * double(k) / double(models.size()), std::string(info(models[k]).name));
    for (const bool anisotropic : {false, true}) {
      if (anisotropic && (isotropic || !info(models[k]).anisotropic())) continue;
      candidates.push_back(fitted_candidate(models[k], anisotropic, table));
      candidates.back().cost_ns = costs.ns[k];
      candidates.back().cost_measured = costs.measured[k];
    }
  }
  return candidates;
}

std::optional<Ledger> ledger_of(const RecommendOptions& options) {
  return options.ledger.empty() ? std::nullopt : read_current_ledger(options.ledger);
}

std::string measured_now(const Recommendation& r, const RecommendOptions& options, bool has_ledger) {
  if (options.ledger.empty()) return "";
  if (!has_ledger) return r.costs_from + " is from another version, so all costs were measured now";
  std::vector<std::string> labels;
  for (const Candidate& c : r.candidates)
    if (c.cost_measured && !c.anisotropic) labels.push_back(c.label());
  if (labels.empty()) return "";
  return r.costs_from + " lacks some costs, which were measured now: " + io::joined(labels);
}

// Renders the model's picture and the reference's, and keeps both.
double rendered(Recommendation& r, Candidate& c, const SceneView& view, const RgbFunction& reference) {
  RenderedPair pair = render_both(view, c.values, reference);
  r.picture = std::move(pair.model);
  r.reference_picture = std::move(pair.reference);
  c.rendered_error = pair.image_error;
  return pair.image_error;
}

// Chooses the cheapest candidate that meets the tolerance, first by the directions of the pixels and then by
// two pictures.
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

std::vector<Reflectance> recommendable_models() {
  std::vector<Reflectance> models = fittable_forms();
  for (std::size_t k = 0; k < kNames<Variant>.size(); ++k) models.push_back(variant_form(Variant(k)));
  return models;
}

std::string Candidate::form() const {
  return std::string(find_variant(model) ? info(model).family : info(model).name);
}
std::string Candidate::choice() const {
  return std::string(find_variant(model) ? info(model).name : "");
}
std::string Candidate::label() const {
  return form() + (anisotropic ? ", two widths" : "") + (choice().empty() ? "" : ", " + choice());
}

std::optional<Material> material_for_file(const Candidate& candidate) {
  if (find_variant(candidate.model)) return in_reference_form(candidate.material);
  return catalogue_index(candidate.model) >= 0 ? std::optional(candidate.material) : std::nullopt;
}

Recommendation recommend(const RecommendOptions& options) {
  Recommendation r;
  r.tolerance = options.tolerance;
  r.metric = options.judge == Judge::image ? "image" : "brdf";
  options.progress(0, "reference and scene");
  const RgbFunction reference =
      options.made ? rgb_function(*options.made) : read_reference(options.reference);
  const SceneView view = view_of(render::load_scene(options.scene));
  if (view.points.empty()) throw InputError(options.scene.string() + ": the picture shows no lit surface");
  r.coverage = coverage_of(view);
  const std::vector<Reflectance> models = options.models.empty() ? recommendable_models() : options.models;
  for (const Reflectance& model : models)
    if (!info(model).fittable())
      throw InputError(std::string(info(model).name) + " cannot be fitted, so it cannot be recommended");
  const std::optional<Ledger> ledger = ledger_of(options);
  r.costs_from = options.ledger.empty() ? "measured now" : options.ledger.filename().string();
  r.isotropic_reference = is_isotropic(reference);
  r.candidates = fitted_candidates(models, costs_of(models, ledger), scene_samples(view, reference, kFitRows),
                                   r.isotropic_reference, options);
  for (Candidate& c : r.candidates) {
    c.image_error = image_error(view, c.values, reference);
    c.brdf_error = brdf_error(c.values, reference);
  }
  std::ranges::stable_sort(r.candidates, {}, &Candidate::cost_ns);
  r.measured_now = measured_now(r, options, ledger.has_value());
  options.progress(0.9, "rendering model and reference");
  choose(r, options, view, reference);
  explain(r, options);
  options.progress(1, "");
  return r;
}

}  // namespace brdf::trade
