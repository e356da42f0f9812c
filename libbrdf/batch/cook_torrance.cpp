#include "batch/family.h"

namespace brdf {
template BatchTable<float> family_batches<"cook_torrance", float>();
template BatchTable<double> family_batches<"cook_torrance", double>();
}  // namespace brdf
