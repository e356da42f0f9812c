// Universal BRDF files of the BiRD project: JSON with parallel arrays, one entry for each wavelength and
// polarisation of each pair of directions.
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
#include "io/samples/set_points.h"

namespace brdf::io::bird {
namespace {

using Values = std::vector<double>;  // NaN for null

// The polarisation of one side: unpolarised, s or p.
enum class State { unpolarised, s, p };

std::optional<std::string> text_at(const Json& object, std::string_view key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (found == object.end() || !found->is_string()) return std::nullopt;
  return found->get<std::string>();
}

// Returns the member of a member of ..., or null.
const Json* member(const Json& root, std::initializer_list<std::string_view> path) {
  const Json* value = &root;
  for (const std::string_view key : path) {
    if (!value->is_object()) return nullptr;
    const auto found = value->find(key);
    if (found == value->end()) return nullptr;
    value = &*found;
  }
  return value;
}

class Reader {
 public:
  Reader(const Json& json, std::string file) : root_(json, std::move(file)), data_(root_.at("data")) {
    table_.source = root_.file();
    table_.format = "bird";
    table_.set_channels({"fr"});
  }

  SampleTable read() {
    read_metadata();
    const Values theta_i = angles("theta_i"), phi_i = angles("phi_i");
    const Values theta_o = angles("theta_r"), phi_o = angles("phi_r");
    const Values value = values_of("BRDF", Unit::Kind::per_steradian);
    const Values nm = wavelengths();
    const std::vector<State> light = states("polarization_i"), viewer = states("polarization_r");
    const Values sigma = uncertainties(value);
    for (std::size_t k = 0; k < value.size(); ++k) {
      const double all = theta_i[k] + phi_i[k] + theta_o[k] + phi_o[k] + value[k] + (nm.empty() ? 0 : nm[k]);
      if (std::isnan(all)) {
        rows_.leave_out("a member is null");
        continue;
      }
      if (!rows_.add(theta_i[k], phi_i[k], theta_o[k], phi_o[k])) continue;
      table_.values[0].push_back(value[k]);
      if (!sigma.empty()) table_.sigma[0].push_back(sigma[k]);
      bands_.push_back({nm.empty() ? 0 : nm[k], polarisation(light, viewer, k)});
    }
    rows_.finish();
    table_.warnings.push_back("read as f_r in 1/sr, mirror direction at phi_r = phi_i + 180 degrees");
    SampleTable wide = all_bands(std::move(table_), std::move(bands_));
    check_highlight(wide);
    return wide;
  }

 private:
  void read_metadata() {
    const Json* const metadata = member(root_.value(), {"metadata"});
    if (!metadata) return;
    const std::string type = text_at(*metadata, "type").value_or("BRDF");
    if (lower_case(type) != "brdf")
      throw InputError(root_.file() + ": $.metadata.type: " + shown(type) +
                       " is not read: export the BRDF, with both polar angles below 90 degrees");
    add_metadata(table_, *metadata);
    if (const Json* const others = member(*metadata, {"adhoc_section"})) add_metadata(table_, *others);
    if (const Json* const sample = member(*metadata, {"sample", "name"}); sample && sample->is_string())
      table_.add_comment("sample", sample->get<std::string>());
    read_solid_angle(*metadata);
  }

  void read_solid_angle(const Json& metadata) {
    const Json* const stated = member(metadata, {"instrumentation", "detection_system", "solid_angle"});
    if (!stated) return;
    const Json* const value = member(*stated, {"value"});
    const std::string unit = text_at(*stated, "unit").value_or("");
    double scale = 0;
    if (unit == "sr") scale = 1;
    if (unit == "msr") scale = 0.001;
    if (value && value->is_number() && scale > 0)
      state_solid_angle(table_, value->get<double>() * scale);
    else
      table_.warnings.push_back(
          "the solid angle of the detector is not a number with the unit sr and is not used");
  }

  // Requires the length of the other arrays.
  void require_length(const JsonPlace& place, std::size_t size) {
    if (longest_name_.empty()) {
      longest_name_ = place.path();
      length_ = size;
    }
    if (size != length_)
      throw InputError(root_.file() + ": " + place.path() + " has " + plural(size, "member") + ", but " +
                       longest_name_ + " has " + std::to_string(length_));
  }

  Values numbers(const JsonPlace& list) {
    require_length(list, list.size());
    if (length_ > kMostRows)
      throw InputError(root_.file() + ": has more than " + std::to_string(kMostRows) + " entries");
    Values out(length_);
    for (std::size_t k = 0; k < length_; ++k) {
      const Json& value = list.value()[k];
      out[k] = value.is_null() ? std::nan("") : value.is_number() ? value.get<double>() : list.at(k).number();
    }
    return out;
  }

  // Returns the unit of a variable. Throws InputError unless it is of this kind.
  Unit unit_of(const JsonPlace& variable, Unit::Kind kind) const {
    const JsonPlace place = variable.at("unit");
    const std::optional<Unit> unit = unit_named(plain_symbols(place.text()));
    if (!unit || unit->kind() != kind || unit->is_decibel)
      place.fail(kind == Unit::Kind::angle    ? "must be rad, deg or °"
                 : kind == Unit::Kind::length ? "must be a unit of wavelengths: nm, μm"
                                              : "must be 1/sr");
    return *unit;
  }

  Values values_of(const std::string& name, Unit::Kind kind) {
    const JsonPlace variable = data_.at(name);
    const Unit unit = unit_of(variable, kind);
    Values values = numbers(variable.at("values"));
    for (double& value : values) value *= unit.factor;
    return values;
  }

  Values angles(const std::string& name) {
    const JsonPlace variable = data_.at(name);
    const Unit unit = unit_of(variable, Unit::Kind::angle);
    Values values = numbers(variable.at("values"));
    constexpr double kLargest = 360;
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] =
          unit.factor == 1 ? degrees_of_printed_radians(values[k]) : values[k] * unit_factor_in_degrees(unit);
      if (std::abs(values[k]) > kLargest) variable.at("values").at(k).fail("is not an angle");
    }
    return values;
  }

  // Returns exactly 1 for degrees.
  static double unit_factor_in_degrees(const Unit& unit) {
    const double factor = radians(unit.factor).degrees();
    return std::abs(factor - 1) < 1e-12 ? 1 : factor;
  }

  // Returns the wavelengths in nm; empty if the file states no such values.
  Values wavelengths() {
    Values found;
    for (const char* name : {"wavelength_i", "wavelength_r"}) {
      if (!data_.has(name)) continue;
      const JsonPlace variable = data_.at(name);
      const Unit unit = unit_of(variable, Unit::Kind::length);
      Values nm = numbers(variable.at("values"));
      for (std::size_t k = 0; k < nm.size(); ++k) {
        if (!std::isnan(nm[k]) && !(nm[k] > 0)) variable.at("values").at(k).fail("is not a wavelength");
        nm[k] = to_nm(nm[k], unit);
        if (!found.empty() && found[k] != nm[k] && !std::isnan(found[k] + nm[k]))
          variable.at("values").at(k).fail(
              "differs from wavelength_i: fluorescence is not a reflectance and is not read");
      }
      found = std::move(nm);
    }
    return found;
  }

  // Returns the standard deviations in 1/sr; empty if the file states no such values.
  Values uncertainties(const Values& value) {
    Values sigma;
    if (data_.has("uBRDF")) {
      const JsonPlace variable = data_.at("uBRDF");
      sigma = numbers(variable.at("values"));
      scale_uncertainties(variable, value, sigma);
    } else if (data_.at("BRDF").has("uncertainty")) {
      const JsonPlace constant = data_.at("BRDF").at("uncertainty");
      sigma.assign(value.size(), constant.at("value").number());
      scale_uncertainties(constant, value, sigma);
    }
    if (sigma.empty()) return sigma;
    for (const double s : sigma) {
      if (s > 0) continue;
      table_.warnings.push_back("the uncertainties are not used, because some are not above 0");
      return {};
    }
    table_.assume("the uncertainties are taken as standard deviations (coverage factor 1)");
    return sigma;
  }

  static void scale_uncertainties(const JsonPlace& variable, const Values& value, Values& sigma) {
    const JsonPlace place = variable.at("unit");
    const std::optional<Unit> unit = unit_named(plain_symbols(place.text()));
    if (!unit || (unit->kind() != Unit::Kind::percent && unit->kind() != Unit::Kind::per_steradian))
      place.fail("must be 1/sr or %");
    const bool is_relative = unit->kind() == Unit::Kind::percent;
    for (std::size_t k = 0; k < sigma.size(); ++k)
      sigma[k] *= unit->factor * (is_relative ? std::abs(value[k]) : 1);
  }

  std::vector<State> states(const std::string& name) {
    std::vector<State> found;
    if (!data_.has(name)) return found;
    const JsonPlace list = data_.at(name).at("values");
    require_length(list, list.size());
    for (std::size_t k = 0; k < list.size(); ++k) found.push_back(state(list, k));
    return found;
  }

  static State state(const JsonPlace& list, std::size_t k) {
    const Json& value = list.value()[k];
    if (value.is_string()) {
      const std::string word = lower_case(value.get<std::string>());
      if (word == "s") return State::s;
      if (word == "p") return State::p;
      if (word == "u") return State::unpolarised;
    } else if (value.is_array() && value.size() == 4) {
      double stokes[4];
      for (std::size_t c = 0; c < 4; ++c) stokes[c] = list.at(k).at(c).number();
      const double q = stokes[1] / stokes[0];
      constexpr double kNear = 1e-6;
      const bool is_linear = stokes[0] > 0 && std::abs(stokes[2]) < kNear && std::abs(stokes[3]) < kNear;
      if (is_linear && std::abs(q - 1) < kNear) return State::s;
      if (is_linear && std::abs(q + 1) < kNear) return State::p;
      if (is_linear && std::abs(q) < kNear) return State::unpolarised;
    }
    list.at(k).fail("is not read as a polarisation (known: s, p, u, and the Stokes vectors of these)");
  }

  std::optional<Polarisation> polarisation(const std::vector<State>& light, const std::vector<State>& viewer,
                                           std::size_t k) const {
    const State in = light.empty() ? State::unpolarised : light[k];
    const State out = viewer.empty() ? State::unpolarised : viewer[k];
    if (in == State::unpolarised && out == State::unpolarised) return std::nullopt;
    if (in == State::unpolarised)
      data_.at("polarization_r")
          .at("values")
          .at(k)
          .fail(
              "with unpolarised incident light is not read: half the sum over s and p of the incident light "
              "is needed");
    if (out == State::unpolarised) return in == State::s ? Polarisation::s : Polarisation::p;
    if (in == State::s) return out == State::s ? Polarisation::ss : Polarisation::sp;
    return out == State::s ? Polarisation::ps : Polarisation::pp;
  }

  JsonPlace root_, data_;
  SampleTable table_;
  ForeignRows rows_{table_};
  std::vector<Band> bands_;
  std::string longest_name_;  // path of the first array
  std::size_t length_ = 0;
};

}  // namespace

bool recognises(const Content& text) {
  return is_json(text) && json_table(text) == JsonTable::bird;
}

SampleTable read(const Content& text, const Supplied& supplied) {
  require_f_r(text.name, supplied);
  return Reader(read_json(text), text.name).read();
}

}  // namespace brdf::io::bird
