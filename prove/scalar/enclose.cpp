#include "prove/scalar/enclosed.h"

namespace brdf::prove {

inline constexpr int kShards = 4;
template <int kShard>
Bounds enclose_of_shard(int place, Precision precision, std::span<const Bounds> box, bool with_cosine);
extern template Bounds enclose_of_shard<0>(int, Precision, std::span<const Bounds>, bool);
extern template Bounds enclose_of_shard<1>(int, Precision, std::span<const Bounds>, bool);
extern template Bounds enclose_of_shard<2>(int, Precision, std::span<const Bounds>, bool);
extern template Bounds enclose_of_shard<3>(int, Precision, std::span<const Bounds>, bool);

namespace {

Bounds enclose_any(int form, Precision precision, std::span<const Bounds> box, bool with_cosine) {
  static constexpr decltype(&enclose_of_shard<0>) kParts[kShards] = {
      enclose_of_shard<0>, enclose_of_shard<1>, enclose_of_shard<2>, enclose_of_shard<3>};
  return kParts[form % kShards](form, precision, box, with_cosine);
}

}  // namespace

Bounds enclose_value(int form, Precision precision, std::span<const Bounds> box) {
  return enclose_any(form, precision, box, true);
}
Bounds enclose_f(int form, Precision precision, std::span<const Bounds> box) {
  return enclose_any(form, precision, box, false);
}

}  // namespace brdf::prove
