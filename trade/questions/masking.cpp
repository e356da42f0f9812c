#include "trade/questions/names.h"
#include "trade/questions/picture.h"
#include "trade/questions/questions.h"

namespace brdf::trade {
namespace {

const Axis kAlpha{"alpha", 0.05, 1, true};
Domain grazing(Axis alpha) {
  return directions(std::move(alpha), 89.43, 85);
}

template <class V>
Choice masking_choice(std::string name, V v, std::string note) {
  return {std::move(name), kernel(visibility<V>{v}), std::move(note), on_ball(v, schlick_fresnel)};
}

Question masked_ggx_question() {
  return {names::kMasking,
          "G of both directions",
          Measure::relative,
          directions(kAlpha, 85),
          {directions({"alpha", 1e-4, 1e-4}, 85), grazing(kAlpha)},
          {masking_choice("Smith, correlated", smith_correlated, "Heitz 2014"),
           masking_choice("Smith, separable", smith_separable, "Walter et al. 2007"),
           masking_choice("Hammon", hammon_correlated, "Hammon 2017: square roots made linear"),
           masking_choice("Schlick-GGX, k = alpha/2", schlick_ggx_half, "Karis 2013, image-based light"),
           masking_choice("Schlick-GGX, k = (roughness+1)^2/8", schlick_ggx_analytic,
                          "Karis 2013, analytic light; the thesis's listing"),
           masking_choice("V-cavities", v_shaped_cavities, "Torrance and Sparrow 1967"),
           masking_choice(names::kMaskingDropped, masking_dropped,
                          "the lookup-texture article: G is meaningless")}};
}

Question g1_question() {
  const auto domain = [](double least_cos, Axis alpha) {
    return cosines({"cos", least_cos, 1}, std::move(alpha));
  };
  // The picture uses the product of both directions.
  return {"masking of one direction, GGX",
          "G1",
          Measure::relative,
          domain(0.01, {"alpha", 0.0036, 1, true}),
          {domain(0.01, {"alpha", 1e-4, 1e-4}), domain(1e-4, {"alpha", 0.0036, 1, true})},
          {{"Smith", kernel(g1_smith_ggx), "", on_ball(smith_separable, schlick_fresnel)},
           {"Schlick-GGX, k = alpha/2", kernel(g1_schlick_half), "Karis 2013, image-based light",
            on_ball(schlick_ggx_half, schlick_fresnel)},
           {"Schlick-GGX, k = (roughness+1)^2/8", kernel(g1_schlick_analytic),
            "the thesis's listing, roughness = sqrt(alpha)", on_ball(schlick_ggx_analytic, schlick_fresnel)},
           {"Schlick-GGX, k = (alpha+1)^2/8", kernel(g1_schlick_printed), "the thesis's equation",
            on_ball(schlick_ggx_printed, schlick_fresnel)}}};
}

Question beckmann_question() {
  return {"masking for Beckmann",
          "G of both directions",
          Measure::relative,
          directions(kAlpha, 85),
          {directions({"alpha", 1e-4, 1e-4}, 85), grazing(kAlpha)},
          {masking_choice("Smith, exact", smith_beckmann, "by a polynomial for erfcx"),
           masking_choice("rational", rational_beckmann, "Walter et al. 2007")}};
}

Question beckmann_g1_question() {
  return {"masking of one direction, Beckmann",
          "G1",
          Measure::relative,
          cosines({"cos", 0.01, 1}, kAlpha),
          {cosines({"cos", 0.01, 1}, {"alpha", 1e-4, 1e-4}), cosines({"cos", 1e-4, 0.01}, kAlpha)},
          {{"Smith, exact", kernel(g1_smith_beckmann), "", on_ball(smith_beckmann, schlick_fresnel)},
           {"rational", kernel(g1_rational_beckmann), "Walter et al. 2007",
            on_ball(rational_beckmann, schlick_fresnel)}}};
}

}  // namespace

std::vector<Question> masking_questions() {
  return {masked_ggx_question(), g1_question(), beckmann_question(), beckmann_g1_question()};
}

}  // namespace brdf::trade
