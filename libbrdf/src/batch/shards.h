// The catalogue's models are compiled in parts, dealt out
// by their places so that all parts take about as long.
#pragma once

#include <array>

#include "brdf/forms.h"
#include "brdf/reflectance.h"

namespace brdf {

// By the forms' places. Functions, so that the compiler must keep them for everyone who names the form.
using ModelTable = std::array<const ReflectanceModel& (*)(), kFormCount>;

template <std::size_t shard, std::size_t shards>
void add_models(ModelTable& table) {
  [&]<std::size_t... place>(std::index_sequence<place...>) {
    const auto add = [&]<std::size_t k>() {
      if constexpr (k % shards == shard) table[k] = &reflectance_of<std::variant_alternative_t<k, AnyForm>>;
    };
    (add.template operator()<place>(), ...);
  }(std::make_index_sequence<kFormCount>{});
}

}  // namespace brdf
