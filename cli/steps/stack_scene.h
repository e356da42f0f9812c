// A scene that shows the fitted maps of a stack.
#pragma once

#include <filesystem>
#include <string>

#include "maps/stack_fit.h"

namespace brdf::cli {

inline constexpr const char* kSceneFile = "scene.json";

// Writes the fitted surface for `brdf render` and `brdf view`: scene.json, a plane as large as the maps, in
// the folder of the maps, with albedo.png, roughness.png and normal.png. The renderer's rule
// (render/scene/texture_rule.h) converts these maps to the diffuse weight and the width of every texel. The
// maps have 8 bits; every other parameter has its median in all texels.
// Returns a description of the resulting losses, or the reason for a missing scene: a sum of forms, shapes
// per channel, or channels other than r, g, b or a single channel.
std::string write_scene(const std::filesystem::path& folder, const texel::Stack& stack,
                        const maps::Settings& settings, const texel::Planes& maps);

}  // namespace brdf::cli
