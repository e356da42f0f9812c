// Does a scene's own weighting matter? Scenes, materials, and forms fitted to them.
#pragma once

namespace brdf::trade {

struct HeldOutCase {
  const char* scene;
  const char* material;
  const char* form;  // another family than the material's, so that no fit can be exact
};
inline constexpr HeldOutCase kHeldOutCases[] = {
    {"recommend_close_up", "glossy_grey_paper", "blinn_phong"},
    {"recommend_close_up", "rolled_brass", "cook_torrance"},
    {"recommend_close_up", "article_glass", "ward"},
    {"recommend_grazing", "glossy_grey_paper", "cook_torrance"},
    {"recommend_grazing", "ivory_plastic", "blinn_phong"},
    {"recommend_grazing", "article_glass", "phong"},
    {"recommend_distant", "glossy_grey_paper", "cook_torrance"},
    {"recommend_distant", "ivory_plastic", "blinn_phong"},
    {"recommend_distant", "article_glass", "ward"},
    {"recommend_distant", "rolled_brass", "blinn_phong"},
};

}  // namespace brdf::trade
