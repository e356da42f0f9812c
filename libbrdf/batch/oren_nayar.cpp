#include "batch/family.h"

namespace brdf {
template BatchTable<float> family_batches<"oren_nayar", float>();
template BatchTable<double> family_batches<"oren_nayar", double>();
}  // namespace brdf
