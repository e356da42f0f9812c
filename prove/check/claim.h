// Claims about a form and their enclosure on a box: shared by the search and the checker.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "brdf/names.h"
#include "prove/scalar/enclosed.h"

namespace brdf::prove {

enum class Property { finite, non_negative, reciprocity, energy, rounding };

// Returns whether the property is claimed separately for float and for double. A property that is shown of
// the formula itself holds in any precision.
constexpr bool is_of_a_precision(Property p) {
  return p != Property::reciprocity && p != Property::energy;
}

// proved: over the whole domain. bounded: within [low, high]; some boxes are open, or the bound does not
// settle the property. refuted: a place violates the property. no_method: nothing is claimed.
enum class Verdict { proved, bounded, refuted, no_method };

struct Claim {
  int form;  // index in the catalogue
  Property property;
  Precision precision;
};

// Returns the domain of the quantity that the property bounds. finite and non_negative bound f and f cos_i.
// energy bounds the largest albedo that the box permits, with kd + ks <= 1 or a diffuse weight of at most
// 1. rounding bounds the largest error of a lobe (rounding.h). std::nullopt: the property is not shown by
// boxes.
std::optional<Domain> domain_of(const Claim& claim);
// Returns the bounds of that quantity on a box of the claim's domain.
Bounds enclose(const Claim& claim, std::span<const Bounds> box);
// Returns whether these bounds settle the property: nothing leaves the range of the precision, nothing is
// negative, and the albedo is at most `most`.
bool settles(Property property, Bounds bounds, double most);

// Returns "float" or "double", or "any" for a property that is shown of the formula itself.
std::string_view scalar_of(const Claim& claim);
// The arithmetic of proofs about the albedo at given parameters, and about its growth.
inline constexpr std::string_view kExact = "exact";
// Returns the kind of numbers for which the property holds, in words. `bit_for_bit` applies to reciprocity:
// whether both orders give the same bits.
std::string arithmetic_of(const Claim& claim, bool bit_for_bit = false);
// Returns the statement of a proof of finite or non_negative, as a sentence.
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
