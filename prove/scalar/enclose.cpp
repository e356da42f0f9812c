#include "prove/scalar/enclosed.h"

namespace brdf::prove {

inline constexpr int kShards = 4;
template <int kShard>
Bounds enclose_of_shard(int place, Precision precision, std::span<const Bounds> box);
extern template Bounds enclose_of_shard<0>(int, Precision, std::span<const Bounds>);
extern template Bounds enclose_of_shard<1>(int, Precision, std::span<const Bounds>);
extern template Bounds enclose_of_shard<2>(int, Precision, std::span<const Bounds>);
extern template Bounds enclose_of_shard<3>(int, Precision, std::span<const Bounds>);

Bounds enclose_value(int form, Precision precision, std::span<const Bounds> box) {
  static constexpr decltype(&enclose_of_shard<0>) kParts[kShards] = {
      enclose_of_shard<0>, enclose_of_shard<1>, enclose_of_shard<2>, enclose_of_shard<3>};
  return kParts[form % kShards](form, precision, box);
}

}  // namespace brdf::prove
