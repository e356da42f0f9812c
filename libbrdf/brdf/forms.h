// The catalogue. To add a form: write its struct in brdf/forms/<family>.h and add its name to AnyForm.
// Everything else (command line, JSON, fits, checks, shaders, batches, tests, documentation) follows from
// there.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>

#include "brdf/forms/blinn_phong.h"
#include "brdf/forms/cook_torrance.h"
#include "brdf/forms/lambert.h"
#include "brdf/forms/oren_nayar.h"
#include "brdf/forms/phong.h"
#include "brdf/forms/ward.h"

namespace brdf {

using AnyForm =
    std::variant<lambert,                                                                                 //
                 oren_nayar, oren_nayar_full, oren_nayar_energy, oren_nayar_as_coded,                     //
                 phong, phong_unnormalised, phong_classic, phong_as_coded,                                //
                 blinn_phong, blinn_phong_n8, blinn_phong_unnormalised, blinn_phong_as_coded,             //
                 ward, ward_duer, ward_bounded, ward_as_coded,                                            //
                 cook_torrance, cook_torrance_beckmann, cook_torrance_dielectric, cook_torrance_vcavity,  //
                 cook_torrance_1982, cook_torrance_schlick_ggx, cook_torrance_as_printed,
                 cook_torrance_as_coded>;

inline constexpr std::size_t kFormCount = std::variant_size_v<AnyForm>;

// Calls f(form) for every form of the catalogue, in order.
template <class F>
constexpr void for_each_form(F&& f) {
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (f(std::variant_alternative_t<k, AnyForm>{}), ...);
  }(std::make_index_sequence<kFormCount>{});
}

// What can be said of a form without evaluating it.
struct FormInfo {
  std::string_view name;
  std::string_view family;
  bool fittable;                           // linear in its weights given its shape
  bool canonical;                          // the family's own form
  std::span<const ParameterInfo> weights;  // per channel
  std::span<const ParameterInfo> shape;
  std::span<const Violation> violations;

  bool anisotropic() const { return shape_index("alpha_y") >= 0; }
  // Position in the table, -1 where the form has no such parameter.
  int shape_index(std::string_view parameter) const;
  int weight_index(std::string_view parameter) const;
};

const FormInfo& info(const AnyForm& form);
std::optional<AnyForm> find_form(std::string_view name);

}  // namespace brdf
