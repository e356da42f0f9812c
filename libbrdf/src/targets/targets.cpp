#include "brdf/targets.h"

#include <vector>

#include "brdf/targets/blender.h"
#include "brdf/targets/gltf.h"
#include "brdf/targets/materialx.h"
#include "brdf/targets/materialx_surfaces.h"
#include "brdf/targets/mitsuba.h"
#include "brdf/targets/pbrt.h"
#include "brdf/targets/three.h"

namespace brdf {

std::span<const Reflectance> targets() {
  static const std::vector<Reflectance> all{
      blender_glossy{},     blender_principled{}, blender_metallic{},        mitsuba_roughconductor{},
      mitsuba_principled{}, pbrt_conductor{},     gltf_metallic_roughness{}, materialx_schlick{},
      open_pbr_surface{},   standard_surface{},   materialx_gltf_pbr{},      usd_preview_surface{},
      disney_principled{},  three_physical{}};
  return all;
}

}  // namespace brdf
