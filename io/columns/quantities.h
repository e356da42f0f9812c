// The quantities of tables, the words that name them, and their conversion to f_r in 1/sr. Names of
// columns, units, comments, titles, options and the documentation all use this one table.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace brdf::io {

// One row of the table.
struct QuantityKind {
  std::string_view name;     // as in options and messages: "BRF"
  std::string_view meaning;  // with its article: "a reflectance factor"
  // f_r = value / (divisor cos_i^cos_i cos_o^cos_o). These members have no meaning for kinds that are not
  // converted to f_r.
  double divisor = 1;
  int cos_i = 0, cos_o = 0;
  // The treatment of the kind: always converted; converted only if a quantity is stated, because the word
  // has several meanings; or refused.
  enum class Use { converted, asked, refused } use = Use::converted;
  std::string_view advice = "";     // for `asked` and `refused`: the missing fact, or the line to write
  std::string_view words = "";      // words that name the kind, separated by semicolons
  std::string_view spellings = "";  // more words, which the documentation omits
  std::string_view forms = "";      // units and formulas that identify the kind, for the documentation
};

// Returns all kinds; f_r is the first.
std::span<const QuantityKind> quantity_kinds();

// A kind with its scale: percent, times 1000, a logarithm.
struct Quantity {
  enum class Scale { linear, log10, ln, decibel };

  const QuantityKind* kind = nullptr;
  double factor = 1;  // the quantity is the value times this factor: 0.01 for percent
  Scale scale = Scale::linear;

  bool operator==(const Quantity&) const = default;
  // Returns whether the values are f_r itself, linear and without a factor.
  bool is_f_r() const;
  // Returns whether the values are a fraction other than a percentage, of a quantity that is not stated.
  bool is_other_fraction() const;
  // Returns the meaning in words: "a reflectance factor in percent".
  std::string meaning() const;
  // Returns the conversion to f_r in words: "divided by 100 pi".
  std::string operation() const;
  // Converts a value, and its standard deviation, to f_r. `cos_i`, `cos_o`: cosines of the polar angles of
  // the row.
  double f_r(double value, double cos_i, double cos_o) const;
  double sigma(double value, double sigma, double cos_i, double cos_o) const;
};

// The information in a column's name about its values.
struct NamedQuantity {
  enum class Says {
    nothing,      // a neutral name: 550nm, r, value
    quantity,     // a kind, which is converted, asked about or refused
    contradicts,  // a unit that contradicts the name's word, or f_r
    no_values     // a unit of something else: degrees, kelvin, seconds
  } says = Says::nothing;
  Quantity quantity;  // `kind` is null if only the scale is stated
  std::string bare;   // the name without its unit
  // The name of the channel: without its unit and, if the values are converted, without the words of the
  // quantity.
  std::string name;
  std::string reason;         // for `contradicts`
  bool needs_a_line = false;  // f_r, named by a word that also has other meanings
  bool is_default = false;    // `fr`, `f_r`: a name that any values may have
  bool is_derived = false;    // a number that accompanies values: fr_min, fr_dark
};
// Interprets a column's name.
NamedQuantity quantity_of_column(std::string_view name);

// Returns a key of a channel's name without the words of a quantity, without separators, and with its
// wavelength in nm. Two columns with one key are one channel.
std::string channel_key(std::string_view name);

// Returns the quantity that a whole text names, as in a comment `# quantity:` or an option; std::nullopt
// for unknown words.
std::optional<Quantity> quantity_named(std::string_view text);
// Returns the quantity that a title names: any kind at its beginning, f_r or a reflectance factor within
// the title. Returns std::nullopt for other titles.
std::optional<Quantity> quantity_in_title(std::string_view title);
// Returns the reason against reading a title that is a formula of a quantity, such as BRDF/1000, as the end
// of a sentence; an empty string for other titles.
std::string unapplied_in_title(std::string_view title);

// Returns the names that options accept, for help and messages: "f_r, BRF, f_r*cos_o, ..."
std::string known_quantities();
// Returns the reason against reading values of this kind as f_r: "is a transmittance, not f_r: ..."
std::string refusal_of(const QuantityKind& kind);

}  // namespace brdf::io
