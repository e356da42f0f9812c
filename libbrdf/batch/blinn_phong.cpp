#include "batch/family.h"

namespace brdf {
template BatchTable<float> family_batches<"blinn_phong", float>();
template BatchTable<double> family_batches<"blinn_phong", double>();
}  // namespace brdf
