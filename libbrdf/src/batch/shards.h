// Compiles the models of the catalogue in parts. Forms are assigned to the parts by their position; all
// parts therefore take about the same time.
#pragma once

#include <array>

#include "brdf/forms.h"
#include "brdf/reflectance_of.h"

namespace brdf {

// Not inlined, because callers in other sources need it.
template <class F>
[[gnu::noinline]] const ReflectanceModel& model_in_library() {
  static const detail::FormModel<F> model;
  return model;
}

// One function per form, by position. A table of functions forces the compiler to keep them for all callers
// that name the form.
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
