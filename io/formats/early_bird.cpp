// BRDF files of the BiRD project before version 1.0: JSON with lists of directions and one row of values for
// each wavelength.
#include <algorithm>
#include <cmath>
#include <optional>

#include "io/columns/foreign_json.h"
#include "io/columns/stated_quantity.h"
#include "io/columns/units.h"
#include "io/columns/wavelengths.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/formats/bands.h"
#include "io/formats/json_metadata.h"
#include "io/samples/aperture.h"
#include "io/samples/foreign_rows.h"
#include "io/samples/highlight.h"
#include "io/samples/to_f_r.h"

namespace brdf::io::early_bird {
namespace {

using Values = std::vector<double>;

class Reader {
 public:
  Reader(const Json& json, std::string file, const Supplied& supplied)
      : root_(json, std::move(file)), data_(root_.at("data")), stated_(stated_by_option(supplied.quantity)) {
    refuse_mirror_side(root_.file(), supplied);
    table_.source = root_.file();
    table_.format = "early_bird";
    table_.set_channels({"fr"});
  }

  SampleTable read() {
    if (root_.has("head")) read_head(root_.at("head").value());
    const Values theta_i = angles("theta_i"), phi_i = angles("phi_i");
    const Values theta_v = angles("theta_v"), phi_v = angles("phi_v");
    const std::vector<std::optional<Polarisation>> states = polarisations();
    const Values nm = wavelengths();
    const JsonPlace rows = data_.at("data");
    if (rows.size() != nm.size())
      throw InputError(root_.file() + ": $.data.data has " + plural(rows.size(), "row") +
                       ", but $.data.wavelengths has " + plural(nm.size(), "member"));
    for (std::size_t w = 0; w < nm.size(); ++w) {
      const JsonPlace row = rows.at(w);
      require_length(row);
      for (std::size_t k = 0; k < directions_; ++k) {
        const Json& value = row.value()[k];
        if (value.is_null()) {
          rows_.leave_out("a member is null");
          continue;
        }
        const double number = row.at(k).number();
        if (!rows_.add(theta_i[k], phi_i[k], theta_v[k], phi_v[k])) continue;
        table_.values[0].push_back(number);
        bands_.push_back({nm[w], states.empty() ? std::nullopt : states[k]});
      }
    }
    rows_.finish();
    convert();
    table_.warnings.push_back("angles in degrees, mirror direction at phi_v = phi_i + 180");
    SampleTable wide = all_bands(std::move(table_), std::move(bands_));
    check_highlight(wide);
    return wide;
  }

 private:
  void read_head(const Json& head) {
    add_metadata(table_, head);
    if (!head.is_object()) return;
    const auto text_of = [&](std::string_view key) {
      const auto found = head.find(key);
      return found != head.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    read_quantity(text_of("quantity"), text_of("unit"));
    const std::string solid_angle = text_of("collection_sa");
    double number;
    if (solid_angle.empty()) return;
    if (parse_number(trimmed(solid_angle), number) && std::isfinite(number))
      state_solid_angle(table_, number);
    else
      table_.warnings.push_back("the solid angle " + shown(solid_angle) +
                                " (head.collection_sa) is not a number and is kept as text");
  }

  void read_quantity(const std::string& words, const std::string& unit) {
    if (words.empty()) return;
    StatedQuantities all(stated_);
    all.add_comment(words, 1, root_.file() + ": $.head.quantity");
    stated_ = all.result();
    const std::optional<Unit> of = unit.empty() ? std::nullopt : unit_named(plain_symbols(unit));
    if (unit.empty()) return;
    const bool is_per_sr = of && of->kind() == Unit::Kind::per_steradian;
    const bool is_ratio = of && (of->kind() == Unit::Kind::number || of->kind() == Unit::Kind::percent);
    const bool is_f_r = stated_->quantity.is_f_r();
    if ((is_f_r && !is_per_sr) || (!is_f_r && !is_per_sr && !is_ratio))
      throw InputError(root_.file() + ": $.head.unit: " + shown(unit) + " contradicts the quantity " +
                       shown(words));
    unit_factor_ = is_per_sr || (of && of->is_percent) ? of->factor : 1;
  }

  void require_length(const JsonPlace& list) {
    if (first_.empty()) {
      first_ = list.path();
      directions_ = list.size();
    }
    if (list.size() != directions_)
      throw InputError(root_.file() + ": " + list.path() + " has " + plural(list.size(), "member") +
                       ", but " + first_ + " has " + std::to_string(directions_) +
                       ": the values cannot be assigned to directions");
  }

  Values angles(const std::string& name) {
    const JsonPlace list = data_.at(name);
    require_length(list);
    Values values;
    constexpr double kLargest = 360;
    for (std::size_t k = 0; k < directions_; ++k) values.push_back(list.at(k).number(-kLargest, kLargest));
    return values;
  }

  Values wavelengths() {
    const JsonPlace list = data_.at("wavelengths");
    if (list.size() > kMostChannels)
      throw InputError(root_.file() + ": $.data.wavelengths has more than " + std::to_string(kMostChannels) +
                       " members");
    Values nm;
    double largest = 0;
    for (std::size_t k = 0; k < list.size(); ++k) {
      nm.push_back(list.at(k).number(0, 1e6));
      largest = std::max(largest, nm.back());
    }
    if (largest > 0 && are_micrometres(largest)) {
      table_.assume("wavelengths are in micrometres, because all are below 100");
      for (double& each : nm) each = without_noise(each * 1000);
    }
    if (nm.size() == 1 && nm[0] == 0)
      table_.warnings.push_back("the wavelength 0 means that the values are weighted over a spectrum");
    return nm;
  }

  // Accepts a list of words or one text with a letter for each direction.
  std::vector<std::optional<Polarisation>> polarisations() {
    std::vector<std::optional<Polarisation>> states;
    if (!data_.has("pol")) return states;
    const JsonPlace pol = data_.at("pol");
    if (pol.value().is_string()) {
      const std::string letters = pol.text();
      if (lower_case(letters) == "no data" || letters.empty()) return states;
      if (letters.size() != directions_)
        throw InputError(root_.file() + ": $.data.pol has " + plural(letters.size(), "letter") + ", but " +
                         first_ + " has " + plural(directions_, "member"));
      for (const char letter : letters) states.push_back(state(pol, std::string(1, letter)));
      return states;
    }
    require_length(pol);
    for (std::size_t k = 0; k < directions_; ++k) states.push_back(state(pol.at(k), pol.at(k).text()));
    return states;
  }

  static std::optional<Polarisation> state(const JsonPlace& place, const std::string& text) {
    const std::string word = lower_case(trimmed(text));
    if (word.empty() || word == "no data" || word == "u" || word == "unpolarized" || word == "unpolarised")
      return std::nullopt;
    const std::optional<Polarisation> known = polarisation_named(word);
    if (!known) place.fail("is not read as a polarisation (known: s, p, u, no data)");
    return known;
  }

  void convert() {
    if (unit_factor_ != 1)
      for (double& value : table_.values[0]) value *= unit_factor_;
    if (!stated_) {
      table_.assume("the file states no quantity: the values are read as f_r in 1/sr (if not: --quantity)");
      return;
    }
    make_f_r(table_, {stated_->quantity});
    const Quantity& quantity = stated_->quantity;
    if (quantity.is_f_r())
      table_.warnings.push_back("read as f_r in 1/sr");
    else
      table_.assume("the values are " + quantity.meaning() + ": " + quantity.operation());
  }

  JsonPlace root_, data_;
  std::optional<StatedQuantity> stated_;
  SampleTable table_;
  ForeignRows rows_{table_};
  std::vector<Band> bands_;
  std::string first_;  // path of the first list
  std::size_t directions_ = 0;
  double unit_factor_ = 1;
};

}  // namespace

bool recognises(const Content& text) {
  return is_json(text) && json_table(text) == JsonTable::early_bird;
}

SampleTable read(const Content& text, const Supplied& supplied) {
  return Reader(read_json(text), text.name, supplied).read();
}

}  // namespace brdf::io::early_bird
