#include "interop/width_parameters.h"

#include <algorithm>
#include <cmath>

#include "brdf/forms.h"
#include "fit/fit.h"
#include "interop/pairs.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/parallel.h"
#include "io/samples/samples.h"

namespace brdf::interop {
namespace {

double same(double x) {
  return x;
}
double squared(double x) {
  return x * x;
}
double root(double x) {
  return std::sqrt(x);
}
double alpha_of_rms(double x) {
  return std::sqrt(2.0) * x;
}
double rms_of_alpha(double x) {
  return x / std::sqrt(2.0);
}

std::span<const WidthParameter> all_widths() {
  static const std::vector<WidthParameter> all{
      {"phong_exponent", phong{}, "exponent", same, same, ""},
      {"blinn_phong_exponent", blinn_phong{}, "exponent", same, same, ""},
      {"ward_sigma", ward{}, "alpha_x", same, same, ""},
      {"beckmann_alpha", cook_torrance_beckmann{}, "alpha_x", same, same, ""},
      {"rms_slope", cook_torrance_beckmann{}, "alpha_x", alpha_of_rms, rms_of_alpha,
       "alpha = sqrt(2) times the rms slope along one axis (Heitz 2014)"},
      {"ggx_alpha", cook_torrance{}, "alpha_x", same, same, ""},
      {"roughness", cook_torrance{}, "alpha_x", squared, root,
       "alpha = roughness^2 (Burley 2012; glTF, Unreal, Blender)"},
      {"linear_roughness", cook_torrance{}, "alpha_x", same, same,
       "alpha = roughness (the linear convention: MaterialX, pbrt without remapping)"}};
  return all;
}

// A published rule between the shapes of two forms.
struct FormRule {
  Reflectance from, to;
  double (*shape)(double);
  std::string_view text;
};
const FormRule* find_rule(const Reflectance& from, const Reflectance& to) {
  constexpr std::string_view kWalter =
      "exponent = 2/alpha^2 - 2, equal peaks of the distributions (Walter et al. 2007)";
  constexpr std::string_view kFisher =
      "exponent of Blinn-Phong = 4 times that of Phong, equal widths near the normal (Fisher and Woo 1994)";
  constexpr std::string_view kWard =
      "alpha equal: both have the Gaussian exp(-tan^2/alpha^2) of facet slopes (Ward 1992, Walter et al. "
      "2007)";
  static const std::array all{
      FormRule{blinn_phong{}, cook_torrance_beckmann{}, [](double n) { return std::sqrt(2 / (n + 2)); },
               kWalter},
      FormRule{cook_torrance_beckmann{}, blinn_phong{}, [](double a) { return 2 / (a * a) - 2; }, kWalter},
      FormRule{phong{}, blinn_phong{}, [](double n) { return 4 * n; }, kFisher},
      FormRule{blinn_phong{}, phong{}, [](double n) { return n / 4; }, kFisher},
      FormRule{ward{}, cook_torrance_beckmann{}, same, kWard},
      FormRule{cook_torrance_beckmann{}, ward{}, same, kWard}};
  for (const FormRule& rule : all)
    if (rule.from == from && rule.to == to) return &rule;
  return nullptr;
}

// The lobe alone: weight 1, no diffuse part, and f0 = 1 if the form has it.
Material lobe_of(const WidthParameter& parameter, double shape) {
  Material lobe = make_material(parameter.form, {"f"});
  Term& term = lobe.terms[0];
  const ReflectanceInfo& form = info(term.form);
  for (std::size_t k = 0; k < form.weights.size(); ++k)
    term.weights[0][k] = form.weights[k].role == Role::diffuse ? 0 : 1;
  for (double& value : term.shape[0]) value = shape;  // every shape parameter of these forms is a width
  return lobe;
}

std::string range_of(const WidthParameter& parameter) {
  return io::short_number(parameter.low()) + " to " + io::short_number(parameter.high());
}

void check_range(const WidthParameter& parameter, double value, const std::string& origin) {
  // Rounding in a rule may leave the range by a little.
  const double slack = 1e-12;
  if (value >= parameter.low() * (1 - slack) - slack && value <= parameter.high() * (1 + slack)) return;
  throw InputError(origin + std::string(parameter.name) + " = " + io::short_number(value, 6) +
                   ": must lie in the range " + range_of(parameter));
}

// Fits the other form's lobe to the given one, with its weight.
Material nearest_lobe(const Material& given, const WidthParameter& to) {
  const io::SampleTable table = values_about(given, Pairs::fitted);
  fit::FitOptions options;
  options.cross_validation = options.profiles = false;
  options.threads = io::all_processors();
  for (const ParameterInfo& p : info(to.form).weights)
    if (p.role != Role::specular)
      options.fix.push_back({std::string(p.name), {p.role == Role::diffuse ? 0.0 : 1.0}});
  const fit::FormFit best = fit::fit(table, {{to.form}}, options).ranking.front();
  if (!best.solved())
    throw InputError("--to " + std::string(to.name) + ": the fit of the lobe ended without a solution");
  return best.material;
}

}  // namespace

std::span<const WidthParameter> width_parameters() {
  return all_widths();
}

const WidthParameter* find_width_parameter(std::string_view name) {
  const auto found = std::ranges::find(all_widths(), name, &WidthParameter::name);
  return found == all_widths().end() ? nullptr : &*found;
}

ConvertedWidth convert_width(const WidthParameter& from, double value, const WidthParameter& to) {
  check_range(from, value, "--from ");
  const double shape = from.to_shape(value);
  ConvertedWidth out;
  double other = shape;
  const auto add = [&out](std::string_view rule) {
    if (!rule.empty()) out.rule += (out.rule.empty() ? "" : "; ") + std::string(rule);
  };
  add(&from == &to ? std::string_view("the same parameter") : from.rule);
  const Material given = lobe_of(from, shape);
  std::optional<Material> carried;
  if (from.form != to.form) {
    if (const FormRule* rule = find_rule(from.form, to.form)) {
      out.kind = Conversion::rule;
      add(rule->text);
      other = rule->shape(shape);
    } else {
      out.kind = Conversion::fit;
      carried = nearest_lobe(given, to);
      other = carried->terms[0].shape[0][std::size_t(info(carried->terms[0].form).shape_index(to.shape))];
      out.weight = carried->terms[0]
                       .weights[0][std::size_t(info(carried->terms[0].form).weight_index(Role::specular))];
      add("fit: the lobe of " + std::string(info(to.form).name) + " that is nearest to the lobe of " +
          std::string(info(from.form).name) + " by the residual log");
    }
  }
  if (&from != &to) add(to.rule);
  out.value = to.from_shape(other);
  check_range(to, out.value, "--to ");
  if (out.kind == Conversion::fit && (out.value <= to.low() || out.value >= to.high()))
    throw InputError("--to " + std::string(to.name) + ": the nearest lobe lies at the end of the range " +
                     range_of(to) + ": no value of this parameter represents the lobe");
  if (out.kind != Conversion::exact)
    out.loss = Comparison(given).loss_of(carried ? *carried : lobe_of(to, other));
  return out;
}

}  // namespace brdf::interop
