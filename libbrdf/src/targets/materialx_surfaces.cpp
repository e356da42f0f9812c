#include "brdf/targets/materialx_surfaces.h"

#include "brdf/reflectance_of.h"

namespace brdf {

template const ReflectanceModel& reflectance_of<materialx_gltf_pbr>();
template const ReflectanceModel& reflectance_of<open_pbr_surface>();
template const ReflectanceModel& reflectance_of<standard_surface>();
template const ReflectanceModel& reflectance_of<usd_preview_surface>();
template const ReflectanceModel& reflectance_of<disney_principled>();

}  // namespace brdf
