#include "io/page/glossary.h"

#include <algorithm>
#include <map>

namespace brdf::io {
namespace {

// Quantities and statistics. A term that is also the name of a parameter is described in the tables of the
// forms instead.
const std::vector<GlossaryTerm>& quantities() {
  static const std::vector<GlossaryTerm> terms{
      {"f_r",
       "The BRDF: light reflected into one direction, per unit of light that arrives from another; in 1/sr.",
       true},
      {"theta_i", "Polar angle of the light: 0 along the surface's normal, 90 degrees at grazing.", true},
      {"theta_o", "Polar angle of the viewer (the detector): 0 along the normal, 90 degrees at grazing.",
       true},
      {"phi_i", "Azimuth of the light about the normal.", true},
      {"phi_o", "Azimuth of the viewer about the normal.", true},
      {"theta_h",
       "Angle between the normal and the half vector, which lies midway between light and viewer: 0 where a "
       "mirror would shine.",
       true},
      {"theta_d", "Angle between the light and the half vector: half of the angle between light and viewer.",
       true},
      {"form", "The formula that is fitted, by its name in the catalogue."},
      {"verdict",
       "Whether the fitted material may be used. converged: yes, every parameter is known. at_bound: yes, a "
       "parameter stands at the end of its range. determined: yes, what it gives is known though not every "
       "parameter. not_identifiable, misfit, diverged, interrupted: no."},
      {"left out",
       "The error on incidences that were not fitted, fold by fold: how well the form predicts what it has "
       "not seen. Smaller is better; forms are ranked by it."},
      {"median", "Half of the values are off by less than this share of themselves."},
      {"90 %", "Nine values in ten are off by less than this."},
      {"off by 2", "The share of the light in values that are off by more than a factor of two."},
      {"x scatter",
       "The usual deviation of fit from samples over how much the samples themselves scatter. 1: nothing is "
       "left to explain. Well above 1: the form lacks something."},
      {"scatter",
       "How much measured values differ from a smooth law through their neighbours, relative to themselves."},
      {"lack of fit",
       "What the form cannot follow however its parameters are chosen: the deviation that is left beyond the "
       "scatter."},
      {"worst at", "The half and difference angles where the deviation is largest."},
      {"ratio there", "Measured over fitted in the middle of that place: above 1 the fit is too dark."},
      {"BIC",
       "Bayesian information criterion (Schwarz, 1978): misfit plus a fee for every parameter. Only "
       "differences count; smaller is better.",
       true},
      {"parameters", "How many numbers were fitted."},
      {"residual",
       "What the fit makes small: how the difference of a fitted and a measured value is counted."},
      {"log",
       "Residual: difference of ln(1 + f_r cos theta_i) of fit and sample: of bright values a share, of dark "
       "ones the difference itself."},
      {"cosine L2", "Residual: difference of f_r cos theta_i of fit and sample; bright values decide."},
      {"cube root",
       "Residual: cube root of the squared difference of f_r cos theta_i; large differences count little."},
      {"log-relative",
       "Residual: difference of ln(f_r cos theta_i cos theta_o + 0.001) of fit and sample: a tenth too much "
       "counts alike in the dark and in the bright."},
      {"free", "Fitted, and determined by the samples."},
      {"95 % (statistical)",
       "Where the parameter lies in 95 of 100 repetitions of the measurement, if the form were right."},
      {"95 % with lack of fit",
       "The same, widened by how far the parameter moves when incidences are left out: the form is not quite "
       "right."},
      {"folds left out", "From where to where the parameter moves as incidences are left out."},
      {"other metrics", "From where to where it moves under the other residuals."},
      {"standard error", "One standard deviation of the parameter, if the form were right."},
      {"status",
       "free: fitted and known. fixed: given. at_bound: at the end of its range. unidentified: the samples "
       "say nothing of it."},
      {"correlation",
       "How far two parameters stand in for each other: near 1 or -1 only a combination of the two is "
       "known."},
      {"starts", "How many of the random starting points ended here."},
      {"cost", "What was minimised; or, among choices, time relative to the exact way."},
      {"reflected fraction",
       "The share of light from one direction that is reflected into all directions (directional albedo). "
       "Above 1 a material would give off more than it receives."},
      {"energy", "Whether no light gives back more than it brings: the reflected fraction is at most 1."},
      {"reciprocity", "Whether f_r stays the same when light and viewer change places (Helmholtz)."},
      {"positivity", "Whether no value is negative."},
      {"noise_floor", "The scatter of the samples: what no fit can undercut."},
      {"coverage", "How much of the hemisphere of directions the samples reach."},
      {"isotropy", "Whether turning the sample about its normal changes nothing."},
      {"mean", "Average over the domain that the figure names."},
      {"p99", "99 of 100 errors are below this."},
      {"max", "The largest error found, at the point named beside it."},
      {"ns", "Nanoseconds for one evaluation on the machine named at the top."},
      {"image error", "Mean difference of the two pictures' radiance over the mean of the reference's."},
      {"brdf error",
       "Mean difference of f_r cos over all directions over the mean: it counts directions that this scene "
       "may never show."},
      {"front", "The choices that nothing beats: every other is dearer or less accurate than one of these."},
      {"dominated", "Another choice is not dearer and in no error worse."},
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
      return "roughness, as the facets' slopes";
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
