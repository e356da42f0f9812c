// What can be claimed of a form, and what it takes on a box: all that the search and the checker share.
#pragma once

#include <optional>

#include "brdf/names.h"
#include "prove/scalar/enclosed.h"

namespace brdf::prove {

enum class Property { finite, non_negative, reciprocity, energy, rounding };

// Whether it is asked of float and of double apart: what is shown of the formula itself holds in any.
constexpr bool is_of_a_precision(Property p) {
  return p != Property::reciprocity && p != Property::energy;
}

struct Claim {
  int form;  // place in the catalogue
  Property property;
  Precision precision;
};

// The quantity that the property bounds: f and f cos_i of finite and non_negative; of energy the largest albedo that the
// box allows, with kd + ks <= 1 or the diffuse weight at most 1; of rounding the largest error of a lobe (rounding.h). None: the
// property is not shown by boxes.
std::optional<Domain> domain_of(const Claim& claim);
Bounds enclose(const Claim& claim, std::span<const Bounds> box);
// Whether these bounds settle the property: nothing leaves the precision's range, nothing is negative, the albedo is at
// most `most`.
bool settles(Property property, Bounds bounds, double most);

}  // namespace brdf::prove

template <>
inline constexpr std::array<std::string_view, 5> brdf::kNames<brdf::prove::Property>{
    "finite", "non_negative", "reciprocity", "energy", "rounding"};
template <>
inline constexpr std::array<std::string_view, 2> brdf::kNames<brdf::prove::Precision>{"float", "double"};
