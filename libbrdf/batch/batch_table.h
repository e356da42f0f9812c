// The tables of batches, one per family.
#pragma once

#include <algorithm>

#include "brdf/batch.h"

namespace brdf {

// A family's name as a template argument.
struct FamilyName {
  char text[24] = {};
  constexpr FamilyName(std::string_view name) { std::ranges::copy(name, text); }
  constexpr FamilyName(const char* name) : FamilyName(std::string_view(name)) {}
  constexpr bool operator==(std::string_view name) const { return std::string_view(text) == name; }
};

template <class T>
using BatchTable = std::array<BatchKernels<T>, kFormCount>;

// The batches of a family's forms; entries of other families are empty.
template <FamilyName family, class T>
BatchTable<T> family_batches();

}  // namespace brdf
