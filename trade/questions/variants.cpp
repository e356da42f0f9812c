#include "trade/questions/variants.h"

#include "brdf/forms/cook_torrance.h"
#include "brdf/reflectance_of.h"
#include "trade/questions/form_kernel.h"
#include "trade/questions/materials.h"
#include "trade/questions/picture.h"

namespace brdf::trade {
namespace {

template <class T>
struct OneWidth {
  T alpha;
  static constexpr auto fields() {
    return std::array{Field{&OneWidth::alpha, ParameterInfo{"alpha", 1e-4, 1, 0.3, 1, "", true,
                                                            "width of the slope distribution", Role::width}}};
  }
};

// Without a Fresnel term, ks is the reflectance along the normal.
template <Variant kVariant, auto kMasking, bool kFresnel>
struct variant_of
    : std::conditional_t<kFresnel, Takes<SchlickWeights, OneWidth>, Takes<LobeWeights, OneWidth>> {
  static constexpr std::string_view name = name_of(kVariant);
  static constexpr std::string_view family = names::kReferenceForm;
  static constexpr Kink kink = Kink::none;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static auto lobes(const OneWidth<S>& shape, const Geometry<G>& g) {
    const Roughness<S> alpha{shape.alpha, shape.alpha};
    const S vd = quotient(d_ggx(alpha, g), kMasking(alpha, g));
    if constexpr (kFresnel)
      return std::array<S, 3>{S(1 / kPi), vd, vd * schlick(g)};
    else
      return std::array<S, 2>{S(1 / kPi), vd};
  }
};

template <class F>
Choice choice_of(const char* note) {
  const Kernel k = kernel(form_kernel<F, Own, true>{});
  return {std::string(F::name), k, note, fixed_at(k, 0.3, 0.04)};
}

struct Entry {
  Reflectance form;
  Choice choice;
};
template <class F>
Entry entry(const char* note) {
  return {F{}, choice_of<F>(note)};
}

// Returns the variants in the order of the enum.
const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      entry<variant_of<Variant::hammon, hammon_correlated, true>>("no square roots"),
      entry<variant_of<Variant::schlick_ggx, schlick_ggx_half, true>>("k = alpha/2"),
      entry<variant_of<Variant::no_masking, masking_dropped, true>>("G = 1"),
      entry<variant_of<Variant::no_fresnel, smith_correlated, false>>(
          "the reflectance at normal incidence for every angle"),
      entry<variant_of<Variant::hammon_no_fresnel, hammon_correlated, false>>("both")};
  return all;
}

}  // namespace

const Reflectance& variant_form(Variant variant) {
  return entries()[std::size_t(variant)].form;
}

std::optional<Variant> find_variant(const Reflectance& reflectance) {
  for (std::size_t k = 0; k < entries().size(); ++k)
    if (entries()[k].form == reflectance) return Variant(k);
  return std::nullopt;
}

std::vector<Question> variant_questions() {
  const Axis alpha{"alpha", 0.05, 1, true}, f0{"f0", 0.02, 1, true};
  Question q{
      names::kVariants,
      "f_r",
      Measure::relative,
      direction_domain(0, 80, {alpha, f0}),
      {direction_domain(0, 80, {{"alpha", 1e-4, 1e-4}, f0}),
       direction_domain(0, 80, {alpha, {"f0", 1e-4, 1e-4}}),
       direction_domain(0, 80, {alpha, {"f0", 0.9999, 0.9999}}), direction_domain(0, 89.5, {alpha, f0})},
      {choice_of<cook_torrance>("Smith's correlated masking, Schlick")}};
  for (const Entry& e : entries()) q.choices.push_back(e.choice);
  return {q};
}

Material in_reference_form(const Material& variant) {
  const Reflectance form = reference_form();
  Material material = make_material(form, variant.channels);
  const Term& from = variant.terms.front();
  const ReflectanceInfo& about = info(from.form);
  set_parameter(material, Role::width, from.shape[0][std::size_t(about.shape_index(Role::width))]);
  for (std::size_t c = 0; c < variant.channels.size(); ++c) {
    std::vector<double> lobes = linear_weights(about, from.weights[c]);
    lobes.resize(info(form).lobes.size());
    std::vector<double>& weights = material.terms.front().weights[c];
    weights.clear();
    for (const auto& weight : form->weights_of(lobes)) weights.push_back(weight.value);
  }
  return material;
}

}  // namespace brdf::trade
