// Cases for the question whether a scene's own weighting matters: scenes, materials, and forms fitted to
// them.
#pragma once

namespace brdf::trade {

struct HeldOutCase {
  const char* scene;
  const char* material;
  const char* form;  // of another family than the material, to rule out exact fits
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
