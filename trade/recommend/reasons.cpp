#include "trade/recommend/reasons.h"

#include <algorithm>

#include "trade/ledger/number.h"
#include "trade/questions/materials.h"
#include "trade/questions/variants.h"

namespace brdf::trade {
namespace {

// Returns true if the model only has diffuse weights.
bool is_diffuse(const Candidate& c) {
  const auto weights = info(c.model).weights;
  return std::ranges::all_of(weights, [](const ParameterInfo& p) { return p.role == Role::diffuse; });
}

// Returns the reference form's name for its weight of this role.
std::string weight_name(Role role) {
  const ReflectanceInfo& about = info(reference_form());
  return std::string(about.weights[std::size_t(about.weight_index(role))].name);
}

void give_reasons(Recommendation& r, const RecommendOptions& options) {
  for (std::size_t k = 0; k < r.candidates.size(); ++k) {
    Candidate& c = r.candidates[k];
    const double error = judged(c, options.judge);
    if (r.chosen == k)
      c.reason = "the cheapest choice that meets the tolerance: error " + number(error);
    else if (c.rendered_error && options.judge == Judge::image && *c.rendered_error > options.tolerance &&
             error <= options.tolerance)
      c.reason = "error " + number(*c.rendered_error) + " in the rendered picture is above the tolerance";
    else if (error > options.tolerance)
      c.reason = "error " + number(error) + " is above the tolerance";
    else if (options.max_cost_ns > 0 && c.cost_ns > options.max_cost_ns)
      c.reason = "meets the tolerance, but " + number(c.cost_ns) + " ns is above the limit";
    else if (r.chosen)
      c.reason = "meets the tolerance, but costs " + number(c.cost_ns) + " ns instead of " +
                 number(r.candidates[*r.chosen].cost_ns);
  }
}

// Returns the smallest error among candidates that `of` admits.
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
    say("no pixel has theta_o above " + number(v.most_theta_o) + " degrees: grazing accuracy is not needed");
  if (v.most_theta_i < 75)
    say("no lit pixel has theta_i above " + number(v.most_theta_i) +
        " degrees: grazing incidence does not occur");
  if (v.most_theta_d < 40)
    say("theta_d stays below " + number(v.most_theta_d) +
        " degrees: the rise of the Fresnel term does not occur, and " + weight_name(Role::f0) + " and " +
        weight_name(Role::specular) + " cannot be distinguished");
  if (v.least_theta_h > 5)
    say("no half vector is closer to the normal than " + number(v.least_theta_h) +
        " degrees: the peak of the highlight does not occur");
  if (v.most_theta_h < 20)
    say("no half vector is farther from the normal than " + number(v.most_theta_h) +
        " degrees: the tail of the lobe does not occur");
  if (v.azimuth_spread < 30)
    say("half vectors stay within " + number(v.azimuth_spread) + " degrees of azimuth " +
        number(v.azimuth_of_h) +
        ": only one direction of the grain is visible, so anisotropy is not identifiable");
  const auto with = [&](auto test) { return best_error(r, options.judge, test); };
  const double diffuse = with(is_diffuse),
               isotropic = with([](const Candidate& c) { return !c.anisotropic; });
  const double anisotropic = with([](const Candidate& c) { return c.anisotropic; });
  if (diffuse <= options.tolerance)
    say("a diffuse model already has error " + number(diffuse) + ": no specular lobe is needed");
  if (r.isotropic_reference)
    say("the reference does not change under rotation: anisotropy is not needed");
  else if (isotropic <= options.tolerance && anisotropic < 1e300 &&
           !(r.chosen && r.candidates[*r.chosen].anisotropic))
    say("two widths instead of one change the best error from " + number(isotropic) + " to " +
        number(std::min(anisotropic, isotropic)) + ": anisotropy is not needed");
  else if (isotropic <= options.tolerance && r.chosen)
    say("a model of one width has error " + number(isotropic) +
        " at a higher cost: the two widths of the chosen model allow a cheaper formula and are not a "
        "property of the reference");
  const auto with_variants = [&](std::initializer_list<Variant> variants) {
    return with([&](const Candidate& c) {
      const std::optional<Variant> variant = find_variant(c.model);
      return variant && std::ranges::find(variants, *variant) != variants.end();
    });
  };
  const double no_fresnel = with_variants({Variant::no_fresnel, Variant::hammon_no_fresnel});
  if (no_fresnel <= options.tolerance)
    say("without any Fresnel term the GGX model has error " + number(no_fresnel) +
        ": the Fresnel term is not needed");
  const double no_masking = with_variants({Variant::no_masking});
  if (no_masking <= options.tolerance)
    say("without masking the GGX model has error " + number(no_masking) + ": masking is not needed");
}

}  // namespace

double judged(const Candidate& c, Judge judge) {
  return judge == Judge::image ? c.image_error : c.brdf_error;
}

void explain(Recommendation& r, const RecommendOptions& options) {
  give_reasons(r, options);
  find_unneeded(r, options);
  if (!r.chosen) return;
  const Candidate& chosen = r.candidates[*r.chosen];
  for (const Violation& v : info(chosen.model).violations)
    r.warnings.push_back(chosen.form() + " is known to violate " + std::string(v.check) + ": " +
                         std::string(v.statement));
}

}  // namespace brdf::trade
