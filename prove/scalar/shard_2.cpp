// The forms of shard 2 of the catalogue on boxes.
#include "prove/scalar/shard.h"

namespace brdf::prove {

template Bounds enclose_of_shard<2>(int, Precision, std::span<const Bounds>);
template std::vector<LobeRounding> rounding_of_shard<2>(int, Precision, std::span<const Bounds>);

}  // namespace brdf::prove
