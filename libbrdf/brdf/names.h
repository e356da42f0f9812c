// Names of enumerators, one list per enum, for files, the command line and messages:
//
//   template <> inline constexpr std::array<std::string_view, 3> kNames<Fruit>{"apple", "pear", "plum"};
//
// The list has the order of the enumerators, which count from 0.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace brdf {

template <class Enum>
inline constexpr std::array<std::string_view, 0> kNames{};

// Returns the name of an enumerator.
template <class Enum>
constexpr std::string_view name_of(Enum e) {
  return kNames<Enum>[std::size_t(e)];
}

// Returns the enumerator with this name, or std::nullopt.
template <class Enum>
constexpr std::optional<Enum> find_named(std::string_view name) {
  for (std::size_t k = 0; k < kNames<Enum>.size(); ++k)
    if (kNames<Enum>[k] == name) return Enum(k);
  return std::nullopt;
}

// Returns "apple, pear, plum", for messages.
template <class Enum>
std::string known_names() {
  std::string text;
  for (const std::string_view name : kNames<Enum>) (text += text.empty() ? "" : ", ") += name;
  return text;
}

}  // namespace brdf
