#include "io/columns/quantity_words.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "io/columns/angle_names.h"
#include "io/columns/name_tokens.h"
#include "io/columns/name_unit.h"
#include "io/columns/units.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using Fault = QuantityWords::Fault;
using Scale = Quantity::Scale;

// The words of the table of quantities in plain spelling, without blanks, hyphens and underscores.
const std::map<std::string, Kind, std::less<>>& phrases() {
  static const std::map<std::string, Kind, std::less<>> all = [] {
    std::map<std::string, Kind, std::less<>> map;
    const std::span<const QuantityKind> kinds = quantity_kinds();
    std::vector<std::string_view> words;
    for (std::size_t k = 0; k < kinds.size(); ++k)
      for (const std::string_view list : {kinds[k].words, kinds[k].spellings}) {
        split(list, ';', words);
        for (const std::string_view word : words) map.emplace(plain_spelling(word), Kind(k));
      }
    map.erase("");
    return map;
  }();
  return all;
}

// Interprets the words of a name and marks the tokens that it has used.
class WordReading {
 public:
  explicit WordReading(std::string_view plain) : text_(plain), tokens_(tokens_of(plain)) {}

  void read(QuantityWords& out) {
    out_ = &out;
    part_cosines();
    take_colours();
    take_multipliers();
    take_scales();
    take_phrases();
    take_cosines();
    take_pi();
    out.rest = rest();
    out.plain = text_;
    out.tokens = tokens_;
  }

  bool is_percent() const { return is_percent_; }
  bool is_multiplied() const { return is_multiplied_; }

 private:
  void contradict(const std::string& reason) {
    out_->fault = Fault::contradicts;
    if (out_->reason.empty()) out_->reason = reason;
  }

  bool is(std::size_t k, std::string_view text) const {
    return k < tokens_.size() && tokens_[k].text == text;
  }
  std::optional<double> number_at(std::size_t k) const {
    double number;
    if (k >= tokens_.size() || tokens_[k].type != Token::Type::number ||
        !parse_number(tokens_[k].text, number))
      return std::nullopt;
    return number;
  }

  // Splits "BRDFcos" into two words.
  void part_cosines() {
    for (std::size_t k = 0; k < tokens_.size(); ++k) {
      const std::size_t at = tokens_[k].text.find("cos");
      if (at == std::string::npos || at == 0 || !phrases().contains(tokens_[k].text.substr(0, at))) continue;
      Token rest = tokens_[k];
      rest.text.erase(0, at);
      rest.begin += at;
      tokens_[k].text.resize(at);
      tokens_[k].end = rest.begin;
      tokens_.insert(tokens_.begin() + std::ptrdiff_t(k) + 1, rest);
    }
  }

  // Takes L*, a*, b*, in which the star is part of the name, and (a.u.).
  void take_colours() {
    if (tokens_.size() > 1 && is(1, "*") && (tokens_.size() == 2 || is_silent(tokens_[2])) &&
        std::string_view("labch").find(tokens_[0].text) != std::string_view::npos)
      take_kind(0, 2, Kind::colour);
    for (std::size_t k = 0; k + 2 < tokens_.size(); ++k)
      if (is(k, "a") && is(k + 1, ".") && is(k + 2, "u")) take_kind(k, k + 3, Kind::relative);
  }

  // Takes a power of ten by which the quantity was multiplied: x1000, * 10^4, 1000*, 1e3 x.
  void take_multipliers() {
    for (std::size_t k = 0; k < tokens_.size(); ++k) {
      const bool is_sign = is(k, "x") || is(k, "*");
      if (is_sign && take_power(k + 1, k)) return;
      if (!number_at(k)) continue;
      const std::size_t after = k + (is(k + 1, "^") ? 3 : 1);
      const bool is_of_log = after + 1 < tokens_.size() && tokens_[after + 1].text.starts_with("log");
      if ((is(after, "x") || is(after, "*")) && !is_of_log && take_power(k, after)) return;
      split_factor(k);
    }
  }

  // Splits "BRDFx1000": the x belongs to the number if the word before it is known.
  void split_factor(std::size_t number) {
    if (number == 0 || tokens_[number - 1].type != Token::Type::word) return;
    Token& word = tokens_[number - 1];
    if (!word.text.ends_with('x') || !phrases().contains(word.text.substr(0, word.text.size() - 1))) return;
    if (!take_power(number, number)) return;
    word.text.pop_back();
    --word.end;
  }

  bool take_power(std::size_t k, std::size_t sign) {
    std::optional<double> number = number_at(k);
    if (!number) return false;
    std::size_t end = k + 1;
    if (*number == 10 && is(end, "^")) {
      const bool is_negative = is(end + 1, "-");
      const auto exponent = number_at(end + 1 + is_negative);
      if (!exponent) return false;
      number = std::pow(10.0, is_negative ? -*exponent : *exponent);
      end += 2 + is_negative;
    }
    const double ten = std::log10(*number);
    if (!(*number > 0) || *number == 1 || std::abs(ten - std::round(ten)) > 1e-12) return false;
    if (*number < 1) contradict("has a factor or a unit that is a power of ten below 1");
    use(k, end);
    use(sign, sign + 1);
    is_multiplied_ = true;
    out_->factor /= *number;
    return true;
  }

  void take_scales() {
    for (std::size_t k = 0; k < tokens_.size(); ++k) {
      Token& token = tokens_[k];
      if (token.is_used) continue;
      const std::string& word = token.text;
      if (word == "%" || word == "percent" || word == "pct" || word == "percentage") {
        set_percent(1e-2, k);
      } else if (word == "permille" || word == "permil" || word == "promille") {
        set_percent(1e-3, k);
      } else if (word == "per" && (is(k + 1, "mille") || is(k + 1, "mil") || is(k + 1, "thousand"))) {
        set_percent(1e-3, k);
        use(k + 1, k + 2);
      } else if (word == "ppm") {
        set_percent(1e-6, k);
      } else if (word == "ppb") {
        set_percent(1e-9, k);
      } else if (word == "milli") {
        out_->factor *= 1e-3;
        use(k, k + 1);
      } else if (word == "log" || word == "lg" || word == "ln" || word == "loge" || word == "logarithm") {
        take_logarithm(k);
      } else if (word == "db" || word == "decibel" || word == "decibels") {
        out_->scale = Scale::decibel;
        use(k, k + 1);
      } else if (word == "d" && is(k + 1, "b") && tokens_[k + 1].begin == token.end) {  // "dB_fr"
        out_->scale = Scale::decibel;
        use(k, k + 2);
      } else if (word == "m" && is_prefix(k)) {
        out_->factor *= 1e-3;
        use(k, k + 1);
      } else if (word == "n" && is_prefix(k)) {
        take_kind(k, k + 1, Kind::relative);
      }
    }
  }

  // Returns whether the token is a one-letter prefix of a quantity's word: mBRDF, nBRDF.
  bool is_prefix(std::size_t k) const {
    return k + 1 < tokens_.size() && tokens_[k].end == tokens_[k + 1].begin &&
           phrases().contains(tokens_[k + 1].text);
  }

  void set_percent(double factor, std::size_t k) {
    out_->factor *= factor;
    is_percent_ = true;
    use(k, k + 1);
  }

  void take_logarithm(std::size_t k) {
    const std::string& word = tokens_[k].text;
    const bool is_natural =
        word == "ln" || word == "loge" || is(k + 1, "e") || (k > 0 && is(k - 1, "natural"));
    std::size_t end = k + 1;
    if (k > 0 && is(k - 1, "-")) contradict("is a negative logarithm");
    const std::size_t before = k > 1 && is(k - 1, "*") ? k - 2 : k - 1;  // 10 log10, 10*log10
    const std::optional<double> times = k > 0 ? number_at(before) : std::nullopt;
    if (times && *times != 10) contradict("is a multiple of a logarithm");
    if (times) use(before, k);
    if (is(end, "e")) ++end;
    if (const auto base = number_at(end)) {
      if (*base != 10) contradict("is a logarithm with a base other than 10 and e");
      ++end;
    }
    if (times && is_natural) contradict("is a multiple of a logarithm");
    out_->scale = times ? Scale::decibel : is_natural ? Scale::ln : Scale::log10;
    use(k, end);
    for (const char* word_before : {"natural", "decimal", "common", "decadic"})
      if (k > 0 && is(k - 1, word_before)) use(k - 1, k);
  }

  // Takes the longest known phrases, from the left.
  void take_phrases() {
    constexpr std::size_t kLongest = 9;  // tokens
    for (std::size_t k = 0; k < tokens_.size(); ++k) {
      if (tokens_[k].is_used || is_silent(tokens_[k])) continue;
      std::string joined;
      std::optional<std::pair<std::size_t, Kind>> found;
      for (std::size_t end = k; end < std::min(tokens_.size(), k + kLongest) && !tokens_[end].is_used;
           ++end) {
        if (is_silent(tokens_[end])) continue;
        joined += tokens_[end].text;
        // Two single letters have many meanings, except f_r: r_f is not RF.
        const bool is_parted = joined.size() <= 2 && end > k && joined != "fr";
        const auto at = phrases().find(joined);
        if (at != phrases().end() && !is_parted) found = {end + 1, at->second};
      }
      if (!found && is_retroreflection(k)) found = {k + 2, Kind::retroreflection};
      if (!found) continue;
      out_->is_default = !out_->kind && (is(k, "fr") || (is(k, "f") && is(k + 1, "r")));
      take_kind(k, found->first, found->second);
      k = found->first - 1;
    }
  }

  // Returns whether the token begins R_A. Joined, R_A would be two letters with many meanings.
  bool is_retroreflection(std::size_t k) const {
    return is(k, "r") && is(k + 1, "a") && text_[tokens_[k].end] == '_';
  }

  void take_kind(std::size_t begin, std::size_t end, Kind kind) {
    const bool is_first = std::all_of(tokens_.begin(), tokens_.begin() + std::ptrdiff_t(begin),
                                      [](const Token& t) { return t.is_used || is_silent(t); });
    use(begin, end);
    const std::optional<Kind> before = out_->kind;
    if (!before) {
      out_->kind = kind;
      out_->is_first = is_first;
    } else if (*before != kind) {
      out_->kind = stronger(*before, kind);
    }
  }

  // Returns the more specific of two words: "relative BRDF", "BSDF, transmission", "cosine-corrected
  // scatter BRDF".
  std::optional<Kind> stronger(Kind a, Kind b) {
    for (const Kind decisive : {Kind::transmittance, Kind::relative, Kind::radiant_intensity})
      if (a == decisive || b == decisive) return decisive;
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
      if (other == Kind::reflectance || other == Kind::scatter) return one;
      if (one == Kind::f_r_cos_o && other == Kind::f_r) return one;
    }
    contradict("names two quantities");
    return a;
  }

  // Takes cosines by which f_r was multiplied.
  void take_cosines() {
    bool light = false, viewer = false;
    for (std::size_t k = 0; k < tokens_.size(); ++k) {
      std::string word = tokens_[k].text;
      if (tokens_[k].is_used || !word.starts_with("cos")) continue;
      if (k > 0 && is(k - 1, "/")) contradict("is divided by a cosine");
      const bool is_raised = is(k + 1, "^") || (is(k + 1, "*") && is(k + 2, "*"));
      const bool has_number = number_at(k + 1) && tokens_[k + 1].begin == tokens_[k].end;
      if (is_raised || has_number) contradict("is multiplied by a power of a cosine");
      word.erase(0, word.starts_with("cosine") ? 6 : 3);
      std::size_t end = k + 1;
      while (word.empty() || word == "theta") {
        while (end < tokens_.size() && (is(end, "(") || is(end, "["))) ++end;
        if (end == tokens_.size() || tokens_[end].type != Token::Type::word || tokens_[end].is_used) break;
        if (tokens_[end].text.starts_with("cos")) break;
        word += tokens_[end++].text;
      }
      if (word.starts_with("theta")) word.erase(0, 5);
      const bool is_light = word.starts_with("i") || word.starts_with("l");
      (is_light ? light : viewer) = true;
      use(k > 0 && is(k - 1, "*") ? k - 1 : k, end);
    }
    if (!light && !viewer) return;
    if (!out_->kind) {  // a column of cosines
      out_->fault = Fault::no_values;
      return;
    }
    if (*out_->kind != Kind::f_r) return contradict("is multiplied by a cosine");
    out_->kind = light && viewer ? Kind::f_r_cos_i_cos_o : light ? Kind::f_r_cos_i : Kind::f_r_cos_o;
  }

  // Takes a factor of pi, by which f_r becomes a reflectance factor: pi*BRDF, BRDF * pi, pi f_r.
  void take_pi() {
    for (std::size_t k = 0; k < tokens_.size(); ++k) {
      if (!is(k, "pi") || tokens_[k].is_used || !out_->kind) continue;
      const bool is_before = is(k + 1, "*") || (k == 0 && k + 1 < tokens_.size() && tokens_[k + 1].is_used);
      const bool is_after = k > 0 && is(k - 1, "*"), is_divisor = k > 0 && is(k - 1, "/");
      if (!is_before && !is_after && !is_divisor) continue;
      if (is_divisor || *out_->kind != Kind::f_r) return contradict("has a factor of pi");
      out_->kind = Kind::reflectance_factor;
      out_->is_default = false;
      use(is_after ? k - 1 : k, is(k + 1, "*") ? k + 2 : k + 1);
    }
  }

  void use(std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < std::min(end, tokens_.size()); ++k) tokens_[k].is_used = true;
  }

  // Returns the text without the used tokens, in order.
  std::string rest() const {
    std::string text;
    for (std::size_t k = 0; k < tokens_.size(); ++k) {
      const Token& token = tokens_[k];
      if (token.is_used || (token.type == Token::Type::sign && is_silent(token))) continue;
      if (token.type == Token::Type::sign && text.empty()) continue;
      const bool goes_on = k > 0 && !tokens_[k - 1].is_used && !text.empty();
      if (goes_on)
        text += text_.substr(tokens_[k - 1].end, token.begin - tokens_[k - 1].end);
      else if (!text.empty())
        text += '_';
      text += text_.substr(token.begin, token.end - token.begin);
    }
    while (!text.empty() && std::string_view(" _*/^=+").find(text.back()) != std::string_view::npos)
      text.pop_back();
    return is_filling(text) ? "" : text;
  }

  std::string_view text_;
  std::vector<Token> tokens_;
  QuantityWords* out_ = nullptr;
  bool is_percent_ = false, is_multiplied_ = false;
};

// Combines the unit with the words, or finds that the two contradict each other.
class Combination {
 public:
  Combination(QuantityWords& words, const NameUnit& parts)
      : out_(words), unit_(*parts.unit), text_(parts.unit_text) {}

  void make() {
    using K = Unit::Kind;
    if (unit_.is_decibel) return decibels();
    switch (unit_.kind()) {
      case K::number:
        out_.factor *= unit_.factor;
        break;
      case K::percent:
        percent();
        break;
      case K::per_steradian:
        per_steradian();
        break;
      case K::radiance:
        refused(Kind::radiance);
        break;
      case K::luminance:
        refused(Kind::luminance);
        break;
      case K::intensity:
        refused(Kind::radiant_intensity);
        break;
      case K::signal:
        refused(Kind::signal);
        break;
      default:
        no_values();
    }
  }

 private:
  bool is(Kind kind) const { return out_.kind == kind; }

  void contradict() {
    out_.fault = Fault::contradicts;
    out_.reason = "has the unit " + shown(text_) + ", which does not fit the quantity";
  }

  void decibels() {
    out_.scale = Scale::decibel;
    if (unit_.kind() == Unit::Kind::area)
      out_.kind = Kind::radar;
    else if (!out_.kind && unit_.kind() == Unit::Kind::per_steradian)
      out_.kind = Kind::f_r;
    else if (!out_.kind || is(Kind::reflectance))
      out_.kind = Kind::decibels;
  }

  void percent() {
    out_.factor *= unit_.factor;
    if (out_.kind && *out_.kind <= Kind::reduced_luminance && !is(Kind::reflectance_factor))
      return contradict();
    if (!out_.kind) out_.kind = Kind::percent;
  }

  void per_steradian() {
    out_.factor *= unit_.factor;
    if (unit_.is_percent && !is(Kind::f_r) && !is(Kind::f_r_cos_o)) {
      out_.kind = Kind::scatter;
    } else if (is(Kind::reflectance)) {
      out_.is_doubtful = lower_case(plain_symbols(out_.bare)) != "rho";
      out_.kind = Kind::f_r;
    } else if (is(Kind::reduced_luminance)) {
      out_.factor *= 1e4;  // the unit is that of the coefficient itself
    } else if (!out_.kind) {
      out_.kind = of_symbol();
    } else if (is(Kind::reflectance_factor) || is(Kind::radiance_factor) || is(Kind::radiance) ||
               is(Kind::luminance)) {
      contradict();
    }
  }

  // Returns the kind of a symbol with a unit per steradian. This is f_r, except for symbols that also have
  // many other meanings and are therefore accepted only with a unit of lux: the coefficients of
  // retroreflection R_A and R' (cd/lx/m2) and R_L (mcd/m2/lx), and Qd, which is hemispherical.
  Kind of_symbol() const {
    const std::string symbol = plain_spelling(out_.bare);
    const bool is_of_lux = text_.find("lx") != text_.npos || text_.find("lux") != text_.npos;
    if (is_of_lux && (symbol == "ra" || symbol == "r'")) return Kind::retroreflection;
    if (is_of_lux && symbol == "rl") return Kind::f_r_cos_i;
    if (is_of_lux && symbol == "qd") return Kind::hemispherical;
    return Kind::f_r;
  }

  void refused(Kind kind) {
    const bool has_own = out_.kind && *out_.kind != Kind::f_r && *out_.kind != Kind::f_r_cos_o &&
                         *out_.kind != Kind::scatter && *out_.kind != Kind::reflectance;
    if (is(Kind::f_r)) return contradict();
    if (!has_own) out_.kind = kind;
  }

  void no_values() {
    if (out_.kind && *out_.kind <= Kind::reduced_luminance) return contradict();
    if (!out_.kind) out_.fault = Fault::no_values;
  }

  QuantityWords& out_;
  const Unit& unit_;
  const std::string& text_;
};

}  // namespace

bool is_filling(std::string_view rest) {
  constexpr std::string_view kFillers =
      " value values data measured measurement measurements in of the a an spectral table as is are unit "
      "units result "
      "results and bidirectional directional hemispherical cie conical biconical absolute quantity column "
      "factor "
      "weighted times multiplied by corrected ";
  const std::vector<Token> tokens = tokens_of(rest);
  return std::ranges::all_of(tokens, [&](const Token& token) {
    return token.type == Token::Type::sign || kFillers.find(" " + token.text + " ") != kFillers.npos;
  });
}

QuantityWords read_quantity_words(std::string_view text) {
  const NameUnit parts = parted(text);
  QuantityWords out;
  out.bare = parts.bare;
  const std::string plain = plain_symbols(parts.bare);
  WordReading reading(plain);
  reading.read(out);
  if (!out.kind && !parts.unit) {
    if (reading.is_percent()) out.kind = Kind::percent;
    if (out.scale == Scale::decibel) out.kind = Kind::decibels;
  }
  out.is_default = out.is_default && !parts.unit;
  if (parts.unit && out.fault == Fault::none) Combination(out, parts).make();
  if (out.kind == Kind::reduced_luminance && reading.is_multiplied())
    out.factor *= 1e4;  // the factor is stated, not implied
  const auto contradict = [&](const char* reason) {
    if (out.fault == Fault::none) out.reason = reason;
    out.fault = Fault::contradicts;
  };
  if (reading.is_percent() && !(parts.unit && parts.unit->kind() == Unit::Kind::per_steradian) && out.kind &&
      *out.kind <= Kind::reduced_luminance && *out.kind != Kind::reflectance_factor)
    contradict("is in percent, which does not fit the quantity");
  if (!out.kind && out.fault == Fault::none && (out.factor != 1 || out.scale != Scale::linear))
    contradict("gives a scale, but no quantity");
  return out;
}

}  // namespace brdf::io
