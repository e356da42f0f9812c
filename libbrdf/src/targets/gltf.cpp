#include "brdf/targets/gltf.h"

#include "brdf/reflectance_of.h"

namespace brdf {

template const ReflectanceModel& reflectance_of<gltf_metallic_roughness>();

}  // namespace brdf
