#include "brdf/targets/materialx.h"

#include "brdf/reflectance_of.h"

namespace brdf {

template const ReflectanceModel& reflectance_of<materialx_schlick>();

}  // namespace brdf
