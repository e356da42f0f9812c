#pragma once

#include <filesystem>
#include <string>

#include "maps/stack_fit.h"

namespace brdf::cli {

inline constexpr const char* kSceneFile = "scene.json";

// The fitted surface for `brdf render` and `brdf view`: scene.json, a plane as large as the maps in the
// folder of these, with albedo.png, roughness.png and normal.png, which the renderer's rule
// (render/scene/texture_rule.h) turns back into the diffuse weight and the width of every texel. These have 8
// bits; every other parameter has its middle value in all texels. Returns what is lost by that, in words, or
// why there is no scene: a sum of forms, shapes for each channel, or channels that are neither r, g, b nor
// one.
std::string write_scene(const std::filesystem::path& folder, const texel::Stack& stack,
                        const maps::Settings& settings, const texel::Planes& maps);

}  // namespace brdf::cli
