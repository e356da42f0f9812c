#include "io/columns/quantities.h"

#include <array>
#include <cmath>

#include "brdf/scalar.h"
#include "io/columns/quantity_words.h"
#include "io/columns/unread_words.h"
#include "io/columns/wavelengths.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using Use = QuantityKind::Use;

// The order is that of the enumerators of Kind in quantity_words.h.
constexpr std::array kKinds{
    QuantityKind{
        "f_r", "f_r in 1/sr", 1, 0, 0, Use::converted, "",
        "f_r; BRDF; BSDF; bidirectional reflectance distribution function; radiance coefficient; "
        "luminance coefficient",
        "brdfs; bidirectional scattering distribution function; bidirectional scatter distribution function; "
        "bidirectional reflection distribution function; reflectance distribution function",
        "rho (1/sr); q (cd/m2/lx); 1/sr"},
    QuantityKind{"BRF", "a reflectance factor", kPi, 0, 0, Use::converted, "",
                 "BRF; HDRF; HCRF; BCRF; CCRF; REFF; reflectance factor; radiance factor; luminance factor",
                 "RF; brfs; cdrf; reflectance factors; reflection factor; refl factor; bidirectional "
                 "reflectance factor; "
                 "hemispherical directional reflectance factor; biconical reflectance factor"},
    QuantityKind{
        "f_r*cos_o", "f_r times cos_o", 1, 0, 1, Use::converted, "",
        "ARS; DSC; angle-resolved scatter; cosine-corrected BRDF; ccBRDF; intensity",
        "angle resolved scattering; angular resolved scattering; differential scatter coefficient; "
        "differential "
        "scattering coefficient; cos corrected brdf; cosine corrected bsdf; brdf cosine corrected; brdf cos "
        "corrected; cosine corrected; cos corrected; ccbsdf",
        "f_r*cos_o; BRDF*cos; BRDF cos(theta_r)"},
    QuantityKind{"f_r*cos_i", "f_r times cos_i", 1, 1, 0, Use::converted, "", "", "",
                 "f_r*cos_i; BRDF cos(theta_i)"},
    QuantityKind{"f_r*cos_i*cos_o", "f_r times cos_i cos_o", 1, 1, 1, Use::converted, "", "", "",
                 "f_r*cos_i*cos_o"},
    QuantityKind{"I/F", "a radiance factor I/F (pi f_r cos_i)", kPi, 1, 0, Use::converted, "", "I/F; RADF",
                 "i over f; iof"},
    QuantityKind{"R_A", "a coefficient of retroreflection", 1, 1, 1, Use::converted, "",
                 "coefficient of retroreflection; retroreflection; retroreflectivity",
                 "retroreflection coefficient; retroreflective coefficient", "R_A (cd/lx/m2)"},
    QuantityKind{"r", "a reduced luminance coefficient times 10^4", 1e4, 3, 0, Use::converted, "",
                 "reduced luminance coefficient", "r table; r tables", "r (as `quantity`)"},
    QuantityKind{"reflectance", "a reflectance, which may or may not be a reflectance factor", 1, 0, 0,
                 Use::asked,
                 "for a reflectance factor give --quantity BRF (BRF % if the values are in percent), or a "
                 "line '# quantity: BRF' above the header row; a hemispherical reflectance is not f_r",
                 "reflectance; reflection; reflectivity; rho", "refl; reflectances; reflectance value"},
    QuantityKind{"scatter", "scattered light, f_r or f_r times cos_o", 1, 0, 0, Use::asked,
                 "give --quantity f_r or --quantity f_r*cos_o (ARS), with 'ppm' if the unit is ppm/sr",
                 "scatter; scattering", "scattered; scatter function", "ppm/sr"},
    QuantityKind{
        "percent", "in percent, of a quantity that the name does not state", 1, 0, 0, Use::asked,
        "for reflectance factors give --quantity 'BRF %', or a line '# quantity: BRF %' above the header row",
        "", "", "%"},
    QuantityKind{"decibels", "in decibels of a ratio that the name does not state", 1, 0, 0, Use::refused,
                 "BRDF (dB) and dB sr^-1 are read; a ratio of powers lacks the solid angle of the detector",
                 "", "", "R (dB); dB"},
    QuantityKind{"BTDF", "of transmitted light", 1, 0, 0, Use::refused,
                 "only reflected light is read: export the reflection", "BTDF; transmission; transmittance",
                 "ccbtdf; transmissivity; transmitted; bidirectional transmittance distribution function; "
                 "transmission "
                 "factor; transmittance factor; btf"},
    QuantityKind{"radiance", "a radiance", 1, 0, 0, Use::refused,
                 "the irradiance of the sample is missing: f_r is the radiance divided by it", "radiance",
                 "radiances", "W/m2/sr"},
    QuantityKind{"luminance", "a luminance", 1, 0, 0, Use::refused,
                 "the illuminance of the sample is missing: f_r is the luminance divided by it", "luminance",
                 "luminances", "cd/m2"},
    QuantityKind{"radiant intensity", "an intensity that is not divided by the incident light", 1, 0, 0,
                 Use::refused, "the incident flux is missing", "radiant intensity; luminous intensity", "",
                 "W/sr; cd"},
    QuantityKind{
        "signal", "a detector's signal", 1, 0, 0, Use::refused,
        "the signal of a white standard, or the irradiance, is missing: divide the values by one of the two; "
        "values proportional to f_r are read with '# quantity: f_r' above the header row and fitted with "
        "--free-scale",
        "counts; signal; voltage; current; power; irradiance; digital number",
        "signals; count; cts; adu; dn; photocurrent; illuminance; flux; digital numbers; raw signal; grey "
        "level; gray level; pixel value",
        "V; A; W; W/m2; lx"},
    QuantityKind{"colour", "a colour coordinate or a gloss", 1, 0, 0, Use::refused,
                 "the geometry and the spectrum are missing: export reflectance factors for each wavelength",
                 "CIELAB; chroma; hue; gloss; tristimulus",
                 "gloss units; gu; l star; a star; b star; lightness; delta e", "L*; a*; b*"},
    QuantityKind{
        "hemispherical reflectance", "a reflectance of a whole hemisphere", 1, 0, 0, Use::refused,
        "values for each pair of directions are missing",
        "albedo; TIS; haze; emissivity; absorptance; hemispherical reflectance",
        "emittance; absorptivity; total integrated scatter; total scatter; dhr; directional hemispherical "
        "reflectance; total reflectance; diffuse reflectance; specular reflectance; d/8; 8/d; d/0; 0/d"},
    QuantityKind{"radar", "a radar cross section", 1, 0, 0, Use::refused, "the illuminated area is missing",
                 "RCS; radar cross section; sigma0", "nrcs; cross section; sigma nought", "dBsm"},
    QuantityKind{"phase", "a phase or an amplitude", 1, 0, 0, Use::refused,
                 "intensities are missing: export f_r", "phase; amplitude; retardance"},
    QuantityKind{
        "relative values", "relative, without a scale", 1, 0, 0, Use::refused,
        "a calibration is missing; if the values are f_r times an unknown factor, write '# quantity: f_r' "
        "above the header row and fit with --free-scale",
        "relative; normalised; arbitrary units; uncalibrated",
        "normalized; normed; norm; rel; arb units; arb; arbitrary", "a.u."}};

static_assert(kKinds.size() == kKindCount);

const QuantityKind& of(Kind kind) {
  return kKinds[static_cast<std::size_t>(kind)];
}

}  // namespace

std::span<const QuantityKind> quantity_kinds() {
  return kKinds;
}

bool Quantity::is_f_r() const {
  return kind == &kKinds[0] && factor == 1 && scale == Scale::linear;
}

bool Quantity::is_other_fraction() const {
  return kind == &of(Kind::percent) && factor != 0.01;
}

std::string Quantity::meaning() const {
  std::string text(kind->meaning);
  if (kind == &kKinds[0] && (factor != 1 || scale != Scale::linear)) text = "f_r";
  if (factor == 0.01)
    text += " in percent";
  else if (factor == 1e-6)
    text += " in parts per million";
  else if (factor != 1)
    text += " times " + to_text(std::round(1e12 / factor) / 1e12);
  switch (scale) {
    case Scale::log10:
      return "the decimal logarithm of " + text;
    case Scale::ln:
      return "the natural logarithm of " + text;
    case Scale::decibel:
      return text + " in decibels";
    case Scale::linear:
      break;
  }
  return text;
}

std::string Quantity::operation() const {
  std::string raised = scale == Scale::log10     ? "10 to the power of the value"
                       : scale == Scale::ln      ? "e to the power of the value"
                       : scale == Scale::decibel ? "10 to the power of a tenth of the value"
                                                 : "";
  const bool has_pi = kind->divisor == kPi;
  const double number = (has_pi ? 1 : kind->divisor) / factor;
  std::string by;
  const auto add = [&](const std::string& word) { by += (by.empty() ? "" : " ") + word; };
  if (number > 1 + 1e-12) add(to_text(std::round(number)));
  if (has_pi) add("pi");
  const auto add_cosine = [&](const char* name, int power) {
    if (power > 0) add(std::string(name) + (power > 1 ? "^" + std::to_string(power) : ""));
  };
  add_cosine("cos_i", kind->cos_i);
  add_cosine("cos_o", kind->cos_o);
  std::string text = raised;
  if (number < 1 - 1e-12) text += (text.empty() ? "" : ", ") + std::string("times ") + to_text(1 / number);
  if (!by.empty()) text += (text.empty() ? "" : ", ") + std::string("divided by ") + by;
  return text.empty() ? "used unchanged" : text;
}

namespace {

double divisor_of(const Quantity& q, double cos_i, double cos_o) {
  double divisor = q.kind->divisor / q.factor;
  for (int k = 0; k < q.kind->cos_i; ++k) divisor *= cos_i;
  for (int k = 0; k < q.kind->cos_o; ++k) divisor *= cos_o;
  return divisor;
}

}  // namespace

double Quantity::f_r(double value, double cos_i, double cos_o) const {
  if (scale == Scale::log10) value = std::pow(10.0, value);
  if (scale == Scale::ln) value = std::exp(value);
  if (scale == Scale::decibel) value = std::pow(10.0, value / 10);
  return value / divisor_of(*this, cos_i, cos_o);
}

double Quantity::sigma(double value, double deviation, double cos_i, double cos_o) const {
  const double ten = std::log(10.0);
  switch (scale) {
    case Scale::log10:
      return deviation * ten * f_r(value, cos_i, cos_o);
    case Scale::ln:
      return deviation * f_r(value, cos_i, cos_o);
    case Scale::decibel:
      return deviation * ten / 10 * f_r(value, cos_i, cos_o);
    case Scale::linear:
      break;
  }
  return deviation / divisor_of(*this, cos_i, cos_o);
}

std::string known_quantities() {
  std::string text;
  for (const QuantityKind& kind : kKinds)
    if (kind.use == Use::converted) (text += text.empty() ? "" : ", ") += kind.name;
  return text + "; with %, ppm, milli, x1000, log10, ln or dB";
}

std::string refusal_of(const QuantityKind& kind) {
  const bool may_be = kind.use == Use::asked;
  return "is " + std::string(kind.meaning) + (may_be ? ": " : ", not f_r: ") + std::string(kind.advice);
}

namespace {

// Returns the position at which the wavelength at the end of a name begins.
std::size_t begin_of_wavelength(const std::string& name) {
  constexpr std::string_view kOfNumber = "0123456789.";
  std::size_t begin = 0;
  for (std::size_t k = 0; k < name.size(); ++k) {
    const bool is_start = kOfNumber.find(name[k]) != kOfNumber.npos &&
                          (k == 0 || kOfNumber.find(name[k - 1]) == kOfNumber.npos);
    if (is_start && wavelength_of(name.substr(k))) begin = k;
  }
  return begin;
}

// Returns the channel's name that is left without the words of the quantity: "BRF_1" becomes fr_1, "BRF
// 550" the band 550nm.
std::string rest_as_name(const std::string& rest) {
  double number;
  const bool is_number = parse_number(rest, number) && with_band_unit(rest) == rest;
  return is_number ? "fr_" + rest : rest;
}

}  // namespace

// Combines the words of a name with its unit.
NamedQuantity quantity_of_column(std::string_view name) {
  const QuantityWords words = read_quantity_words(name);
  NamedQuantity out;
  out.quantity.factor = words.factor;
  out.quantity.scale = words.scale;
  out.bare = out.name = words.bare;
  if (words.fault == QuantityWords::Fault::no_values) {
    out.says = NamedQuantity::Says::no_values;
    return out;
  }
  if (words.kind) out.quantity.kind = &of(*words.kind);
  if (out.name.empty() && !name.empty()) out.name = "fr";
  if (words.fault == QuantityWords::Fault::contradicts) {
    out.says = NamedQuantity::Says::contradicts;
    out.reason = words.reason;
    return out;
  }
  const bool is_refused = words.kind && of(*words.kind).use == Use::refused;
  if (const auto unread = is_refused ? std::nullopt : unread_part(words)) {
    out.says = NamedQuantity::Says::contradicts;
    out.reason = unread->reason;
    out.is_derived = unread->is_derived;
    return out;
  }
  if (!words.kind) return out;
  out.says = NamedQuantity::Says::quantity;
  out.needs_a_line = words.is_doubtful;
  out.is_default = words.is_default && out.quantity.is_f_r();
  if (!out.quantity.is_f_r() && out.quantity.kind->use == Use::converted) out.name = rest_as_name(words.rest);
  if (out.name.empty() && !name.empty()) out.name = "fr";
  return out;
}

std::string channel_key(std::string_view name) {
  const QuantityWords words = read_quantity_words(name);
  std::string key = with_band_unit(words.kind ? words.rest : words.bare);
  // A last "A" is an article in titles, and a sample in the name of a column.
  if (key.empty() && !words.tokens.empty() && words.tokens.back().text == "a") key = "A";
  // The wavelength is the shortest end of the name that is one; what is before it names the sample.
  std::string band;
  if (const auto nm = wavelength_of(key)) {
    const std::size_t begin = begin_of_wavelength(key);
    band = " " + to_text(*nm) + "nm";
    key.resize(begin);
  }
  std::erase_if(key, [](char c) { return c == ' ' || c == '_' || c == '-'; });
  return key + band;
}

std::optional<Quantity> quantity_named(std::string_view text) {
  const std::string lower = lower_case(trimmed(text));
  if (lower == "r") return Quantity{&of(Kind::reduced_luminance)};
  const QuantityWords words = read_quantity_words(text);
  const bool has_symbol = words.rest.size() == 1;  // a symbol: luminance coefficient q, reflectance factor R
  if (!words.kind || words.fault != QuantityWords::Fault::none || !(is_filling(words.rest) || has_symbol) ||
      unread_part(words))
    return std::nullopt;
  return Quantity{&of(*words.kind), words.factor, words.scale};
}

std::string unapplied_in_title(std::string_view title) {
  constexpr std::size_t kLongestFormula = 6;  // tokens; a longer title is a sentence
  const QuantityWords words = read_quantity_words(title);
  if (!words.kind || words.tokens.size() > kLongestFormula) return "";
  if (words.fault == QuantityWords::Fault::contradicts) return words.reason;
  const auto unread = unread_part(words);
  return unread ? unread->reason : "";
}

std::optional<Quantity> quantity_in_title(std::string_view title) {
  const QuantityWords words = read_quantity_words(title);
  if (!words.kind || words.fault != QuantityWords::Fault::none) return std::nullopt;
  const Quantity found{&of(*words.kind), words.factor, words.scale};
  // Many words have other meanings within a title: laser intensity, transmission.
  const bool is_plain = words.kind == Kind::f_r || words.kind == Kind::reflectance_factor;
  if (!words.is_first && !is_plain) return std::nullopt;
  return found;
}

}  // namespace brdf::io
