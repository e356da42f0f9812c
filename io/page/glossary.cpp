#include "io/page/glossary.h"

#include <algorithm>
#include <map>

namespace brdf::io {
namespace {

// Quantities and statistics. A term that is also the name of a parameter is described in the tables of the
// forms instead.
const std::vector<GlossaryTerm>& quantities() {
  static const std::vector<GlossaryTerm> terms{
      {"f_r", "BRDF value: reflected radiance in one direction per irradiance from another; in 1/sr.", true},
      {"theta_i",
       "Angle of incidence, from the surface normal: 0 at normal incidence, 90 degrees at grazing incidence.",
       true},
      {"theta_o",
       "Viewing angle (polar angle of the detector): 0 along the normal, 90 degrees at the horizon.", true},
      {"phi_i", "Azimuth of the incident direction about the normal.", true},
      {"phi_o", "Azimuth of the viewing direction about the normal.", true},
      {"theta_h",
       "Angle between the normal and the half vector, the bisector of incident and viewing direction. It is "
       "0 at the mirror direction.",
       true},
      {"theta_d", "Difference angle: angle between the incident direction and the half vector.", true},
      {"form", "The formula that is fitted, by its name in the catalogue."},
      {"verdict",
       "Whether the fitted material is usable. converged: yes, every parameter is identifiable. at_bound: "
       "yes, a parameter is at a bound of its range. determined: yes, its reflectance is well determined, "
       "although some parameters are not identifiable. not_identifiable, misfit, diverged, interrupted: no."},
      {"held out",
       "Cross-validation error: the residual at measurements that were held out of the fit, fold by fold. "
       "Smaller is better; forms are ranked by this error."},
      {"median", "Median of the relative errors."},
      {"median error (fitted)",
       "Median of the relative errors |fitted - measured|/measured at the measurements that were fitted."},
      {"median error (held out)",
       "Median of the relative errors at measurements that were held out of the fit, fold by fold."},
      {"90 % (fitted)", "90th percentile of the relative errors at the measurements that were fitted."},
      {"90 % (held out)", "90th percentile of the relative errors at held-out measurements."},
      {"off by 2 (fitted)",
       "Share of the reflected light in fitted values with an error of more than a factor of two."},
      {"off by 2 (held out)",
       "Share of the reflected light in held-out values with an error of more than a factor of two."},
      {"x scatter",
       "Typical residual of the fit divided by the measurement noise. Near 1 the residuals are consistent "
       "with the noise; well above 1 the form has a lack of fit."},
      {"scatter",
       "Measurement noise: relative differences of measured values from a smooth interpolant of their "
       "neighbours."},
      {"lack of fit",
       "Systematic deviation that no choice of parameters removes, beyond the measurement noise."},
      {"worst at", "Half and difference angles at which the residuals are largest."},
      {"ratio there", "Median of measured over fitted values in that region: above 1 the fit is too dark."},
      {"BIC",
       "Bayesian information criterion (Schwarz, 1978): misfit plus a penalty for every parameter. Only "
       "differences are meaningful; smaller is better.",
       true},
      {"parameters", "Number of fitted parameters."},
      {"residual",
       "The quantity that the fit minimises: a measure of the difference between a fitted and a measured "
       "value."},
      {"log",
       "Residual: difference of ln(1 + f_r cos theta_i) between fit and measurement. It is relative for "
       "bright values and absolute for dark values."},
      {"cosine L2",
       "Residual: difference of f_r cos theta_i between fit and measurement. Bright values dominate."},
      {"cube root",
       "Residual: cube root of the squared difference of f_r cos theta_i. Large differences have little "
       "weight."},
      {"log-relative",
       "Residual: difference of ln(f_r cos theta_i cos theta_o + 0.001) between fit and measurement. The "
       "same relative error has the same weight for dark and bright values."},
      {"free", "Fitted, and identifiable from the measurements."},
      {"95 % (statistical)", "95 % confidence interval, assuming that the form is correct."},
      {"95 % with lack of fit",
       "95 % confidence interval, widened by the changes of the parameter when incidences are held out. It "
       "applies if the form does not fit within the noise."},
      {"folds held out", "Range of the parameter over fits with some incidences held out."},
      {"other metrics", "Range of the parameter over fits with the other metrics."},
      {"standard error", "Standard deviation of the parameter, assuming that the form is correct."},
      {"status",
       "free: fitted and identifiable. fixed: given. at_bound: at a bound of its range. unidentified: not "
       "identifiable from the measurements."},
      {"correlation",
       "Degree to which two parameters can replace each other: near 1 or -1 only a combination of the two is "
       "identifiable."},
      {"starts", "Number of starting points that converged here."},
      {"cost", "The minimised quantity; in a table of choices, time relative to the exact method."},
      {"reflected fraction",
       "Directional albedo: the share of light from one direction that is reflected into all directions. "
       "Above 1 a material violates energy conservation."},
      {"energy", "Whether the directional albedo is at most 1 (energy conservation)."},
      {"reciprocity",
       "Whether f_r is unchanged when the two directions are exchanged (Helmholtz reciprocity)."},
      {"positivity", "Whether no value is negative."},
      {"noise_floor", "The measurement noise, a lower bound for the residuals of any fit."},
      {"coverage", "Share of the hemisphere of directions that the measurements cover."},
      {"isotropy", "Whether values are independent of rotations of the sample about its normal."},
      {"mean", "Average over the domain that the figure names."},
      {"p99", "99th percentile of the errors."},
      {"max", "The largest error found, at the point given with it."},
      {"ns", "Nanoseconds for one evaluation on the machine given at the top."},
      {"image error",
       "Mean difference of radiance between the two pictures, divided by the mean radiance of the "
       "reference."},
      {"brdf error",
       "Mean difference of f_r cos over all directions, divided by the mean. It includes directions that "
       "this scene may not show."},
      {"front",
       "Pareto front: every other choice is more expensive or less accurate than one of these choices."},
      {"dominated", "Another choice is not more expensive, and no error of it is larger."},
  };
  return terms;
}

std::string_view words(Role role) {
  switch (role) {
    case Role::diffuse:
      return "diffuse weight";
    case Role::specular:
      return "specular weight";
    case Role::f0:
      return "reflectance along the normal";
    case Role::width:
      return "surface roughness";
    case Role::width_across:
      return "surface roughness across";
    case Role::exponent:
      return "sharpness";
    case Role::exponent_across:
      return "sharpness across";
    case Role::slope:
      return "roughness (slope of the microfacets)";
    case Role::index:
      return "index of refraction";
    case Role::extinction:
      return "extinction";
    case Role::tint:
      return "tint of the reflectance along the normal";
    case Role::other:
      break;
  }
  return "";
}

// Returns whether a name is a symbol rather than an everyday word.
bool is_symbol(std::string_view name) {
  return name.size() <= 2 || name.find_first_of("_0123456789") != name.npos;
}

// Returns the names of all parameters, each with the description that most forms give it.
std::vector<GlossaryTerm> parameters() {
  std::map<std::string, std::map<std::string, int>> found;
  std::vector<std::string> order;
  for (const Reflectance& form : catalogue())
    for (const auto& table : {form.info().shape, form.info().weights})
      for (const ParameterInfo& p : table) {
        const std::string name(p.name), plain = plain_name(form.info(), p);
        if (!found.contains(name)) order.push_back(name);
        ++found[name][(plain == p.doc ? "" : plain + ": ") + std::string(p.doc) +
                      (p.unit.empty() ? "" : ", in " + std::string(p.unit)) + "."];
      }
  std::vector<GlossaryTerm> terms;
  for (const std::string& name : order) {
    const auto& meanings = found[name];
    const auto most =
        std::ranges::max_element(meanings, [](const auto& a, const auto& b) { return a.second < b.second; });
    terms.push_back({name, "Parameter. " + most->first, is_symbol(name)});
  }
  return terms;
}

}  // namespace

const std::vector<GlossaryTerm>& glossary() {
  static const std::vector<GlossaryTerm> all = [] {
    std::vector<GlossaryTerm> terms = quantities(), of_forms = parameters();
    terms.insert(terms.end(), of_forms.begin(), of_forms.end());
    return terms;
  }();
  return all;
}

const GlossaryTerm* glossary_term(std::string_view word) {
  const auto& terms = glossary();
  const auto found = std::ranges::find_if(terms, [&](const GlossaryTerm& t) { return t.term == word; });
  return found == terms.end() ? nullptr : &*found;
}

std::string plain_name(const ReflectanceInfo& form, const ParameterInfo& parameter, bool along_is_all) {
  const std::string_view plain = words(parameter.role);
  if (plain.empty()) return std::string(parameter.doc);
  const bool along = parameter.role == Role::width || parameter.role == Role::exponent;
  return std::string(plain) + (along && form.anisotropic() && !along_is_all ? " along" : "");
}

}  // namespace brdf::io
