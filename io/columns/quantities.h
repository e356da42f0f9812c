// The quantities that tables hold, by the words that name them, and how f_r in 1/sr is made of each. Names of
// columns, units, comments, titles, options and the documentation all read this one table.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace brdf::io {

// One row of the table.
struct QuantityKind {
  std::string_view name;     // as options and messages name it: "BRF"
  std::string_view meaning;  // with its article: "a reflectance factor"
  // f_r = value / (divisor cos_i^cos_i cos_o^cos_o); of a kind that is no f_r they mean nothing.
  double divisor = 1;
  int cos_i = 0, cos_o = 0;
  // How much of it becomes f_r: all; only if somebody states the quantity (the word has several meanings);
  // nothing.
  enum class Use { converted, asked, refused } use = Use::converted;
  std::string_view advice = "";     // of the last two: what is missing, or what to write
  std::string_view words = "";      // that name it, between semicolons
  std::string_view spellings = "";  // more of them, which the documentation leaves out
  std::string_view forms = "";      // units and formulas by which it is told, for the documentation
};

// All of them; f_r is the first.
std::span<const QuantityKind> quantity_kinds();

// A kind with its scale: percent, times 1000, a logarithm.
struct Quantity {
  enum class Scale { linear, log10, ln, decibel };

  const QuantityKind* kind = nullptr;
  double factor = 1;  // the quantity is the value times this: 0.01 for percent
  Scale scale = Scale::linear;

  bool operator==(const Quantity&) const = default;
  bool is_f_r() const;
  // "a reflectance factor in percent"
  std::string meaning() const;
  // How f_r is made: "divided by 100 pi".
  std::string operation() const;
  // f_r of a value in this direction, and its standard deviation.
  double f_r(double value, double cos_i, double cos_o) const;
  double sigma(double value, double sigma, double cos_i, double cos_o) const;
};

// What a column's name says about its values.
struct NamedQuantity {
  enum class Says {
    nothing,      // a neutral name: 550nm, r, value
    quantity,     // a kind, which is converted, asked about or refused
    contradicts,  // a unit that the name's word, or f_r, cannot have
    no_values     // a unit of something else: degrees, kelvin, seconds
  } says = Says::nothing;
  Quantity quantity;   // `kind` is null if only the scale is stated
  std::string bare;    // the name without its unit
  std::string name;    // the channel's: without its unit and, if the values are converted, without its words
  std::string reason;  // of `contradicts`
  bool needs_a_line = false;  // f_r by a word that also has other meanings
  bool is_default = false;    // `fr`, `f_r`: the name that any values may have
};
NamedQuantity quantity_of_column(std::string_view name);

// The quantity of a whole text, as a comment `# quantity:` or an option states it. std::nullopt for unknown
// words.
std::optional<Quantity> quantity_named(std::string_view text);
// The quantity that a title names: at its beginning any kind, within it f_r or a reflectance factor.
std::optional<Quantity> quantity_in_title(std::string_view title);

// The names that options take, for help and messages: "f_r, BRF, f_r*cos_o, ..."
std::string known_quantities();
// Its row in the documentation's table.
std::string documented(const QuantityKind& kind);
// Why a value of this kind is not read as f_r: "is a transmittance, not f_r: ..."
std::string refusal_of(const QuantityKind& kind);

}  // namespace brdf::io
