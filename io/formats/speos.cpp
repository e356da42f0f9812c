// Speos' text formats: `.brdf` ("Complete Scattering") with blocks for each incidence and wavelength, and
// `.anisotropicbsdf` with blocks for each sample turn and incidence, and one spectrum.
#include "io/formats/speos.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/columns/stated_quantity.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/samples/degrees.h"
#include "io/samples/foreign_rows.h"
#include "io/samples/highlight.h"

namespace brdf::io::speos {
namespace {

constexpr std::size_t kMostLights = 10000;
constexpr std::size_t kMostValues = 50'000'000;  // of a file

constexpr std::string_view kBrdf = "brdf surface file", kAnisotropic = "anisotropic bsdf surface file";

std::string first_line(const Content& text) {
  return lower_case(text.bytes.substr(0, std::min<std::size_t>(text.bytes.find('\n'), 200)));
}

// The blocks of one incidence for all channels, with the factors that make them f_r.
struct Incidence {
  double theta = 0, turn = 0;        // degrees
  std::vector<const Block*> blocks;  // [channel]
  std::vector<double> factors;       // [channel]; 0: no level is known
};

class Reader {
 public:
  explicit Reader(const Content& text) : cursor_(text) {
    table_.source = text.name;
    table_.format = "speos";
  }

  SampleTable read() {
    const bool is_anisotropic = lower_case(cursor_.line()).find("anisotropic") != std::string::npos;
    cursor_.line();  // 0: text
    if (const std::string_view comment = cursor_.line(); !comment.empty())
      table_.add_comment("comment", comment);
    const std::size_t characters = cursor_.count("the length of the description", 0, kLongestLine);
    cursor_.end_line();
    skip_description(characters, is_anisotropic);
    if (is_anisotropic)
      read_anisotropic();
    else
      read_complete();
    return finished();
  }

 private:
  // Returns whether the numbers behind the description follow: the flags, behind the anisotropy vector if
  // there is one, and a count. The cursor does not move.
  bool flags_follow(bool is_anisotropic) {
    const std::size_t start = cursor_.place();
    bool is_good = true;
    double value;
    for (int k = 0; k < (is_anisotropic ? 3 : 0); ++k)
      is_good = is_good && parse_number(cursor_.word(), value);
    for (int k = 0; k < 3; ++k) {
      const std::string_view flag = cursor_.word();
      is_good = is_good && (flag == "0" || flag == "1");
    }
    is_good = is_good && parse_number(cursor_.word(), value) && value >= 1 && value == std::floor(value);
    cursor_.back(start);
    return is_good;
  }

  // Skips the description. If its length is not the one that the file states, for example because an editor
  // removed blanks, the description ends where the flags follow at the beginning of a line.
  void skip_description(std::size_t characters, bool is_anisotropic) {
    const std::size_t start = cursor_.place();
    if (cursor_.skip_description(characters) && flags_follow(is_anisotropic)) return;
    constexpr int kMostLines = 1000;
    cursor_.back(start);
    for (int line = 0; line < kMostLines && !flags_follow(is_anisotropic); ++line) cursor_.line();
    if (!flags_follow(is_anisotropic))
      cursor_.fail("the flags of reflection, transmission and values do not follow the description of " +
                   plural(characters, "character"));
    table_.warnings.push_back("the description does not have the " + std::to_string(characters) +
                              " characters that the file states");
  }

  void read_sides() {
    has_reflection_ = cursor_.count("the flag of reflection", 0, 1) == 1;
    has_transmission_ = cursor_.count("the flag of transmission", 0, 1) == 1;
    if (!has_reflection_)
      throw InputError(table_.source +
                       ": holds transmission only, which is not read: export the reflection of the surface");
    is_intensity_ = cursor_.count("the flag of the values (1: BSDF, 0: intensity)", 0, 1) == 0;
  }

  std::vector<double> incidences(std::size_t count) {
    std::vector<double> thetas = cursor_.numbers("an angle of incidence", count);
    for (const double theta : thetas)
      if (!(std::abs(theta) <= 90))
        cursor_.fail("angle of incidence " + to_text(theta) + " must be between -90 and 90 degrees");
    return thetas;
  }

  Block block() {
    Block next = read_block(cursor_);
    values_ += next.values.size();
    if (values_ > kMostValues) cursor_.fail("more than " + std::to_string(kMostValues) + " values");
    return next;
  }

  // Returns the factor that gives the block this reflectance, or 0 if no factor does.
  double factor_of(const Block& block, double percent) {
    const double reflectance = block.reflectance(is_intensity_);
    const double factor = percent / 100 / reflectance;
    if (reflectance > 0 && percent > 0 && std::isfinite(factor)) return factor;
    ++without_level_;
    return 0;
  }

  void read_complete() {
    read_sides();
    const std::size_t lights = cursor_.count("the number of incidences", 1, kMostLights);
    const std::size_t bands = cursor_.count("the number of wavelengths", 1, kMostChannels);
    const std::vector<double> thetas = incidences(lights);
    std::vector<std::string> names;
    for (const double nm : cursor_.numbers("a wavelength", bands)) {
      if (!(nm >= 100 && nm <= 1e5)) cursor_.fail(to_text(nm) + " is not a wavelength in nm");
      names.push_back(to_text(nm) + "nm");
    }
    table_.set_channels(std::move(names));
    for (const double theta : thetas) {
      std::vector<Block> blocks;
      Incidence incidence{theta, 0, {}, {}};
      for (std::size_t band = 0; band < bands; ++band) {
        const double percent = cursor_.number("a percentage");
        blocks.push_back(block());
        incidence.factors.push_back(factor_of(blocks.back(), percent));
      }
      for (const Block& each : blocks) incidence.blocks.push_back(&each);
      add(incidence);
    }
    finish_text(lights * bands);
  }

  // Reads the angles of incidence for each sample turn.
  std::vector<Incidence> read_turns() {
    const std::vector<double> turns =
        cursor_.numbers("a sample turn", cursor_.count("the number of sample turns", 1, kMostLights));
    std::vector<Incidence> all;
    for (const double turn : turns) {
      if (!(std::abs(turn) <= 360)) cursor_.fail("sample turn " + to_text(turn) + " is not an angle");
      for (const double theta : incidences(cursor_.count("the number of incidences", 1, kMostLights)))
        all.push_back({theta, turn, {}, {}});
      if (all.size() > kMostLights) cursor_.fail("more than " + std::to_string(kMostLights) + " incidences");
    }
    return all;
  }

  struct Spectrum {
    double theta = 0, turn = 0;
    std::vector<double> nm, percent;
  };

  Spectrum read_spectrum() {
    Spectrum spectrum;
    spectrum.theta = cursor_.number("the spectrum's angle of incidence");
    spectrum.turn = cursor_.number("the spectrum's sample turn");
    cursor_.end_line();
    skip_comment();
    const std::size_t bands = cursor_.count("the number of wavelengths of the spectrum", 1, kMostChannels);
    for (std::size_t band = 0; band < bands; ++band) {
      spectrum.nm.push_back(cursor_.number("a wavelength"));
      if (!(spectrum.nm.back() >= 100 && spectrum.nm.back() <= 1e5))
        cursor_.fail(to_text(spectrum.nm.back()) + " is not a wavelength in nm");
      spectrum.percent.push_back(cursor_.number("a percentage"));
    }
    return spectrum;
  }

  // Skips the comment of the spectrum. The comment is missing if the line is one number and the next line
  // has two.
  void skip_comment() {
    const std::size_t start = cursor_.place();
    const std::string_view comment = cursor_.line();
    const std::size_t next = cursor_.place();
    std::vector<std::string_view> words;
    split_blanks(cursor_.line(), words);
    double number;
    cursor_.back(parse_number(comment, number) && words.size() == 2 ? start : next);
  }

  void read_anisotropic() {
    cursor_.numbers("the anisotropy vector", 3);
    read_sides();
    std::vector<Incidence> all = read_turns();
    const std::size_t transmitted = has_transmission_ ? read_turns().size() : 0;
    const Spectrum spectrum = read_spectrum();
    if (has_transmission_) read_spectrum();
    std::vector<Block> blocks;
    for (std::size_t k = 0; k < all.size(); ++k) blocks.push_back(block());
    finish_text(transmitted);
    const double reflectance = reflectance_at(all, blocks, spectrum);
    const bool is_even = std::all_of(spectrum.percent.begin(), spectrum.percent.end(),
                                     [&](double percent) { return percent == spectrum.percent[0]; });
    std::vector<std::string> names;
    std::vector<double> factors;
    for (std::size_t band = 0; band < (is_even ? 1 : spectrum.nm.size()); ++band) {
      names.push_back(is_even ? "fr" : to_text(spectrum.nm[band]) + "nm");
      factors.push_back(spectrum.percent[band] / 100 / reflectance);
      if (!(factors.back() > 0) || !std::isfinite(factors.back()))
        throw InputError(table_.source + ": the level of the values is not defined: the percentage at " +
                         to_text(spectrum.nm[band]) + " nm is " + to_text(spectrum.percent[band]) +
                         ", and the integral of the block is " + short_number(reflectance));
    }
    table_.set_channels(std::move(names));
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k].blocks.assign(factors.size(), &blocks[k]);
      all[k].factors = factors;
      add(all[k]);
    }
  }

  // Returns the integral of the blocks at the spectrum's incidence, linear between two blocks and constant
  // outside, for the spectrum's sample turn or else the first turn.
  double reflectance_at(const std::vector<Incidence>& all, const std::vector<Block>& blocks,
                        const Spectrum& spectrum) {
    const bool has_turn = std::any_of(all.begin(), all.end(),
                                      [&](const Incidence& each) { return each.turn == spectrum.turn; });
    const double turn = has_turn ? spectrum.turn : all.front().turn;
    if (!has_turn)
      table_.assume("the spectrum's sample turn of " + to_text(spectrum.turn) +
                    " degrees is not measured: its percentages are applied to turn " + to_text(turn));
    std::optional<std::size_t> below, above;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k].turn != turn) continue;
      if (all[k].theta <= spectrum.theta && (!below || all[k].theta > all[*below].theta)) below = k;
      if (all[k].theta >= spectrum.theta && (!above || all[k].theta < all[*above].theta)) above = k;
    }
    const std::size_t low = below ? *below : *above, high = above ? *above : *below;
    if (!below || !above)
      table_.assume("the spectrum's angle of incidence, " + to_text(spectrum.theta) +
                    " degrees, is outside the measured ones: its percentages are applied to " +
                    to_text(all[low].theta) + " degrees");
    const double a = blocks[low].reflectance(is_intensity_);
    if (all[low].theta == all[high].theta) return a;
    const double share = (spectrum.theta - all[low].theta) / (all[high].theta - all[low].theta);
    return a + share * (blocks[high].reflectance(is_intensity_) - a);
  }

  // Adds the directions that the blocks of all channels have.
  void add(const Incidence& incidence) {
    if (std::find(incidence.factors.begin(), incidence.factors.end(), 0.0) != incidence.factors.end()) return;
    for (const double factor : incidence.factors) factors_.push_back(factor);
    const Block& first = *incidence.blocks[0];
    std::vector<double> row(incidence.blocks.size());
    for (std::size_t t = 0; t < first.theta.size(); ++t)
      for (std::size_t p = 0; p < first.phi.size(); ++p) {
        const double theta = first.theta[t], phi = first.phi[p];
        // Azimuth 360 and all azimuths along the normal repeat a direction; programs may fill them in
        // differently.
        if (p > 0 && (theta == 0 || phi - first.phi.front() >= 360 - 1e-9)) {
          ++repeated_;
          continue;
        }
        if (!take(incidence, theta, phi, row)) continue;
        if (!rows_.add(incidence.theta, 180 - incidence.turn, theta, phi - incidence.turn)) continue;
        for (std::size_t c = 0; c < row.size(); ++c) table_.values[c].push_back(row[c]);
      }
  }

  // Computes the values of all channels for a direction. Returns false, and counts, if one is missing or 0.
  bool take(const Incidence& incidence, double theta, double phi, std::vector<double>& row) {
    const double cosine = is_intensity_ ? cos_degrees(theta) : 1;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const Block& block = *incidence.blocks[c];
      const auto t = std::lower_bound(block.theta.begin(), block.theta.end(), theta) - block.theta.begin();
      const auto p = std::lower_bound(block.phi.begin(), block.phi.end(), phi) - block.phi.begin();
      const auto at_t = static_cast<std::size_t>(t), at_p = static_cast<std::size_t>(p);
      if (at_t == block.theta.size() || at_p == block.phi.size() || block.theta[at_t] != theta ||
          block.phi[at_p] != phi) {
        rows_.leave_out("not in the grid of every wavelength");
        return false;
      }
      const double value = block.at(at_t, at_p);
      if (value == 0 && std::abs(theta) < 90) {
        rows_.leave_out("exactly 0, which stands for directions that were not measured");
        return false;
      }
      row[c] = value * incidence.factors[c] / (cosine > 0 ? cosine : 1);
      if (!std::isfinite(row[c])) throw InputError(table_.source + ": a value exceeds the range of numbers");
    }
    return true;
  }

  // Checks that nothing but the blocks of transmission follows.
  void finish_text(std::size_t transmitted) {
    if (has_transmission_) {
      table_.warnings.push_back(plural(transmitted, "block") + " of transmission left out");
      return;
    }
    const std::string_view rest = cursor_.word();
    if (!rest.empty() && lower_case(rest) != "end")  // "End of file"
      cursor_.fail(shown(rest) + " follows the last block");
  }

  SampleTable finished() {
    if (without_level_ > 0)
      table_.warnings.push_back(
          plural(without_level_, "block") +
          " without a level left out, with the other wavelengths of that incidence: the percentage or the "
          "integral is not above 0");
    if (factors_.empty()) throw InputError(table_.source + ": no block has a percentage and values above 0");
    const auto [least, most] = std::minmax_element(factors_.begin(), factors_.end());
    const std::string by =
        *least == *most ? short_number(*least) : short_number(*least) + " to " + short_number(*most);
    table_.assume("read as proportional to " + std::string(is_intensity_ ? "f_r cos_o" : "f_r") +
                  ": the percentages of reflected light set the scale, the factors are " + by);
    constexpr double kEqual = 1.1;
    if (*most > kEqual * *least)
      table_.assume(
          "the factors of the blocks differ by more than 10 %: the levels of different incidences and "
          "wavelengths depend on the percentages alone, for example with a peak narrower than the grid");
    table_.warnings.push_back("mirror direction at azimuth 0 of the file, incident light at phi_i = 180");
    rows_.finish();
    if (repeated_ > 0)
      table_.warnings.push_back(
          plural(repeated_, "value") +
          " of repeated directions left out (azimuth 360 degrees, any azimuth along the "
          "normal)");
    check_highlight(table_);
    return std::move(table_);
  }

  Cursor cursor_;
  SampleTable table_;
  ForeignRows rows_{table_};
  std::vector<double> factors_;
  std::size_t values_ = 0, without_level_ = 0, repeated_ = 0;
  bool has_reflection_ = false, has_transmission_ = false, is_intensity_ = false;
};

}  // namespace

bool recognises(const Content& text) {
  const std::string line = first_line(text);
  return line.starts_with("optis") && (line.find(kBrdf) != line.npos || line.find(kAnisotropic) != line.npos);
}

SampleTable read(const Content& text, const Supplied& supplied) {
  require_f_r(text.name, supplied);
  return Reader(text).read();
}

}  // namespace brdf::io::speos
