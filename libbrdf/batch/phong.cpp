#include "batch/family.h"

namespace brdf {
template BatchTable<float> family_batches<"phong", float>();
template BatchTable<double> family_batches<"phong", double>();
}  // namespace brdf
