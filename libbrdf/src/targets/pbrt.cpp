#include "brdf/targets/pbrt.h"

#include "brdf/reflectance_of.h"

namespace brdf {

template const ReflectanceModel& reflectance_of<pbrt_conductor>();

}  // namespace brdf
