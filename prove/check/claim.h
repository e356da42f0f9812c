// What can be claimed of a form, and what it takes on a box: all that the search and the checker share.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "brdf/names.h"
#include "prove/scalar/enclosed.h"

namespace brdf::prove {

enum class Property { finite, non_negative, reciprocity, energy, rounding };

// Whether it is asked of float and of double apart: what is shown of the formula itself holds in any.
constexpr bool is_of_a_precision(Property p) {
  return p != Property::reciprocity && p != Property::energy;
}

// proved: over the whole domain. bounded: within [low, high], some boxes are open or the bound does not
// settle it. refuted: there is a place that violates it. no_method: nothing is claimed.
enum class Verdict { proved, bounded, refuted, no_method };

struct Claim {
  int form;  // place in the catalogue
  Property property;
  Precision precision;
};

// The quantity that the property bounds: f and f cos_i of finite and non_negative; of energy the largest
// albedo that the box allows, with kd + ks <= 1 or the diffuse weight at most 1; of rounding the largest
// error of a lobe (rounding.h). None: the property is not shown by boxes.
std::optional<Domain> domain_of(const Claim& claim);
Bounds enclose(const Claim& claim, std::span<const Bounds> box);
// Whether these bounds settle the property: nothing leaves the precision's range, nothing is negative, the
// albedo is at most `most`.
bool settles(Property property, Bounds bounds, double most);

// "float", "double", or "any" of what is shown of the formula itself.
std::string_view scalar_of(const Claim& claim);
// In which numbers it holds, in words; kExact: of the albedo at given parameters and of its growth.
inline constexpr std::string_view kExact = "exact";
// Of reciprocity: `bit_for_bit` or not.
std::string arithmetic_of(const Claim& claim, bool bit_for_bit = false);
// What such a proof says, in a sentence: of finite and non_negative.
std::string_view statement_of(Property property);

}  // namespace brdf::prove

template <>
inline constexpr std::array<std::string_view, 5> brdf::kNames<brdf::prove::Property>{
    "finite", "non_negative", "reciprocity", "energy", "rounding"};
template <>
inline constexpr std::array<std::string_view, 4> brdf::kNames<brdf::prove::Verdict>{"proved", "bounded",
                                                                                    "refuted", "no_method"};
template <>
inline constexpr std::array<std::string_view, 2> brdf::kNames<brdf::prove::Precision>{"float", "double"};
