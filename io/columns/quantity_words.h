// Recognises the words of quantities in the names of columns, in comments and in titles.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/columns/name_tokens.h"
#include "io/columns/quantities.h"

namespace brdf::io {

// The rows of the table of quantities (quantities.cpp), in the same order.
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
    contradicts,  // the words or the unit contradict each other
    no_values     // the unit belongs to something else
  };

  std::optional<Kind> kind;
  double factor = 1;
  Quantity::Scale scale = Quantity::Scale::linear;
  Fault fault = Fault::none;
  std::string reason;         // for `contradicts`: the end of a sentence about the column
  std::string bare;           // the text without its unit
  std::string rest;           // the text without its unit and without the words of its quantity
  std::string plain;          // `bare` in plain symbols
  std::vector<Token> tokens;  // of `plain`; those that were read are marked as used
  bool is_first = false;      // the words are at the beginning of the text
  bool is_doubtful = false;   // f_r follows from the unit alone; the word has other meanings
  bool is_default = false;    // `fr` without a unit, a name that any values may have
};

// Reads the words and the unit of a text. A unit is in brackets, follows `/`, `,`, `_` or a blank, or is
// the whole text.
QuantityWords read_quantity_words(std::string_view text);

// Returns whether the text consists only of words without meaning: "values", "of the".
bool is_filling(std::string_view rest);

}  // namespace brdf::io
