#include "brdf/targets/blender.h"

#include "brdf/reflectance_of.h"

namespace brdf {

template const ReflectanceModel& reflectance_of<blender_glossy>();
template const ReflectanceModel& reflectance_of<blender_principled>();
template const ReflectanceModel& reflectance_of<blender_metallic>();

}  // namespace brdf
