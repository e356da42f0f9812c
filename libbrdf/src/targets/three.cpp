#include "brdf/targets/three.h"

#include "brdf/reflectance_of.h"

namespace brdf {

template const ReflectanceModel& reflectance_of<three_physical>();

}  // namespace brdf
