#include "batch/family.h"

namespace brdf {
template BatchTable<float> family_batches<"lambert", float>();
template BatchTable<double> family_batches<"lambert", double>();
}  // namespace brdf
