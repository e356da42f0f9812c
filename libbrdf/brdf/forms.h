// The catalogue. To add a form: write its struct in a header of brdf/forms/
// and add its name to AnyForm. Everything else (command line, JSON, fits,
// checks, shaders, batches, tests, documentation) follows from there.
//
// For code that needs the structs themselves; all others ask brdf/reflectance.h.
#pragma once

#include <variant>

#include "brdf/forms/all.h"  // written by cmake: every header of the folder

namespace brdf {

// clang-format off
using AnyForm =
    std::variant<lambert,
                 oren_nayar, oren_nayar_full, oren_nayar_energy, oren_nayar_as_coded,
                 phong, phong_unnormalised, phong_classic, phong_as_coded,
                 blinn_phong, blinn_phong_n8, blinn_phong_unnormalised, blinn_phong_as_coded,
                 ward, ward_duer, ward_bounded, ward_as_coded,
                 cook_torrance, cook_torrance_beckmann, cook_torrance_student, cook_torrance_dielectric, cook_torrance_conductor,
                 cook_torrance_vcavity, cook_torrance_1982, cook_torrance_schlick_ggx, cook_torrance_as_printed,
                 cook_torrance_as_coded>;
// clang-format on

inline constexpr std::size_t kFormCount = std::variant_size_v<AnyForm>;

// Calls f(form) for every form of the catalogue, in order.
template <class F>
constexpr void for_each_form(F&& f) {
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (f(std::variant_alternative_t<k, AnyForm>{}), ...);
  }(std::make_index_sequence<kFormCount>{});
}

// Calls f(form) for the form at this place of the catalogue, 0 <= place < kFormCount.
template <class F>
void with_form(int place, F&& f) {
  int k = 0;
  for_each_form([&](auto form) {
    if (k++ == place) f(form);
  });
}

}  // namespace brdf
