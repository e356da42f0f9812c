#include "brdf/targets/mitsuba.h"

#include "brdf/reflectance_of.h"

namespace brdf {

template const ReflectanceModel& reflectance_of<mitsuba_roughconductor>();
template const ReflectanceModel& reflectance_of<mitsuba_principled>();

}  // namespace brdf
