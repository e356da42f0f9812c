// The words of quantities in the names of columns, in comments and in titles.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "io/columns/quantities.h"

namespace brdf::io {

// The rows of the table of quantities.
enum class Kind {
  f_r,
  reflectance_factor,
  f_r_cos_o,
  f_r_cos_i,
  f_r_cos_i_cos_o,
  radiance_factor,
  retroreflection,
  reduced_luminance,
  reflectance,
  scatter,
  percent,
  decibels,
  transmittance,
  radiance,
  luminance,
  radiant_intensity,
  signal,
  colour,
  hemispherical,
  radar,
  phase,
  relative
};
inline constexpr std::size_t kKindCount = std::size_t(Kind::relative) + 1;

struct QuantityWords {
  enum class Fault {
    none,
    contradicts,  // the words or the unit do not go together
    no_values     // the unit is one of something else
  };

  std::optional<Kind> kind;
  double factor = 1;
  Quantity::Scale scale = Quantity::Scale::linear;
  Fault fault = Fault::none;
  std::string reason;        // of `contradicts`, as the end of a sentence about the column
  std::string bare;          // the text without its unit
  std::string rest;          // and without the words of its quantity
  bool is_first = false;     // the words open the text
  bool is_doubtful = false;  // the unit alone says f_r; the word has other meanings
  bool is_default = false;   // `fr` without a unit, the name that any values may have
};

// Reads the words and the unit of a text. A unit stands in brackets, behind `/`, `,`, `_` or a blank, or is
// the whole text.
QuantityWords read_quantity_words(std::string_view text);

// Whether nothing but words without meaning is left: "values", "of the".
bool is_filling(std::string_view rest);

}  // namespace brdf::io
