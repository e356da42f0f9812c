// The catalogue in parts that take about the same time to compile.
#pragma once

#include "prove/scalar/matt_box.h"
#include "prove/scalar/on_box.h"
#include "prove/scalar/on_rounding.h"

namespace brdf::prove {

inline constexpr int kShards = 4;

// Calls f(form) for the form at this index, if the form belongs to this shard.
template <int kShard, class Call>
void with_form_of_shard(int place, const Call& call) {
  const auto visit = [&]<std::size_t k>(std::integral_constant<std::size_t, k>) {
    if constexpr (k % kShards == kShard)
      if (int(k) == place) call(std::variant_alternative_t<k, AnyForm>{});
  };
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (visit(std::integral_constant<std::size_t, k>{}), ...);
  }(std::make_index_sequence<kFormCount>{});
}

// Encloses f and f cos_i of a form of this shard.
template <int kShard>
Bounds enclose_of_shard(int place, Precision precision, std::span<const Bounds> box) {
  Bounds result{};
  with_form_of_shard<kShard>(place, [&](auto form) {
    using F = decltype(form);
    const auto value = [&]<class Base>(Base) {
      if constexpr (MattForm<F>)
        return enclose_matt<F, Base>(box);
      else
        return enclose<F, Base>(box);
    };
    result = precision == Precision::float_type ? value(float()) : value(double());
  });
  return result;
}

// Returns the rounding errors of a form of this shard.
template <int kShard>
std::vector<LobeRounding> rounding_of_shard(int place, Precision precision, std::span<const Bounds> box) {
  std::vector<LobeRounding> result;
  with_form_of_shard<kShard>(place, [&](auto form) {
    using F = decltype(form);
    result = precision == Precision::float_type ? rounding<F, float>(box) : rounding<F, double>(box);
  });
  return result;
}

}  // namespace brdf::prove
