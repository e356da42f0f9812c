// The list of the forms of the catalogue. To add a form, write its struct in a header of brdf/forms/ and add
// its name to AnyForm. Everything else (command line, JSON, fits, checks, shaders, batches, tests,
// documentation) is derived from that.
//
// The structs are only declared here, so that code below the forms can ask whether a type is one of them.
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>

namespace brdf {

// clang-format off
using AnyForm =
    std::variant<struct lambert,
                 struct oren_nayar, struct oren_nayar_full, struct oren_nayar_energy, struct oren_nayar_as_coded,
                 struct phong, struct phong_unnormalised, struct phong_classic, struct phong_as_coded,
                 struct blinn_phong, struct blinn_phong_n8, struct blinn_phong_unnormalised,
                 struct blinn_phong_as_coded,
                 struct ward, struct ward_duer, struct ward_bounded, struct ward_as_coded,
                 struct cook_torrance, struct cook_torrance_beckmann, struct cook_torrance_student,
                 struct cook_torrance_dielectric, struct cook_torrance_conductor, struct cook_torrance_vcavity,
                 struct cook_torrance_1982, struct cook_torrance_schlick_ggx, struct cook_torrance_as_printed,
                 struct cook_torrance_as_coded,
                 struct matt_2, struct matt_5, struct matt_8, struct matt_14, struct matt_20,
                 struct retro, struct retro_beckmann>;
// clang-format on

inline constexpr std::size_t kFormCount = std::variant_size_v<AnyForm>;

template <class F>
inline constexpr bool kInCatalogue = []<class... Forms>(std::type_identity<std::variant<Forms...>>) {
  return (std::is_same_v<F, Forms> || ...);
}(std::type_identity<AnyForm>{});

}  // namespace brdf
