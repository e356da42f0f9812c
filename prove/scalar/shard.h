// The catalogue in parts that take about as long to compile.
#pragma once

#include "prove/scalar/on_box.h"

namespace brdf::prove {

inline constexpr int kShards = 4;

template <int kShard>
Bounds enclose_of_shard(int place, Precision precision, std::span<const Bounds> box, bool with_cosine) {
  Bounds result{};
  const auto visit = [&]<std::size_t k>(std::integral_constant<std::size_t, k>) {
    if constexpr (k % kShards == kShard) {
      using F = std::variant_alternative_t<k, AnyForm>;
      if (int(k) == place)
        result = precision == Precision::float_type ? enclose<F, float>(box, with_cosine)
                                                    : enclose<F, double>(box, with_cosine);
    }
  };
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (visit(std::integral_constant<std::size_t, k>{}), ...);
  }(std::make_index_sequence<kFormCount>{});
  return result;
}

}  // namespace brdf::prove
