#include "batch/family.h"

namespace brdf {
template BatchTable<float> family_batches<"ward", float>();
template BatchTable<double> family_batches<"ward", double>();
}  // namespace brdf
