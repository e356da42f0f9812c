#include <algorithm>
#include <cmath>
#include <optional>

#include "brdf/angle.h"
#include "io/columns/polarisation_names.h"
#include "io/columns/wavelengths.h"
#include "io/csv/long_format.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/provenance.h"
#include "io/files/text.h"
#include "io/formats/bird.h"
#include "io/formats/json_metadata.h"
#include "io/samples/aperture.h"
#include "io/samples/degrees.h"

namespace brdf::io::bird {
namespace {

constexpr const char* kNotStated = "not stated";

std::vector<Band> bands_of(const SampleTable& table) {
  std::vector<Band> bands;
  for (const std::string& channel : table.channels) {
    const Band band{wavelength_of(channel).value_or(0), polarised_name(channel).of};
    const bool is_bare = band.nm == 0 && !band.polarisation;
    if ((is_bare && table.channels.size() > 1) || (!bands.empty() && (band.nm == 0) != (bands[0].nm == 0)))
      throw InputError(table.name() + ": channel " + shown(channel) +
                       " has no wavelength: files of BiRD need channels such as 550nm or s_550nm");
    if (std::ranges::find(bands, band) != bands.end())
      throw InputError(table.name() + ": channel " + shown(channel) +
                       " has the wavelength and the polarisation of another channel");
    bands.push_back(band);
  }
  return bands;
}

// The letter of the light's or of the viewer's polarisation.
std::string letter(const std::optional<Polarisation>& state, bool is_viewer) {
  if (!state) return "u";
  const std::string name(name_of(*state));
  if (!is_viewer) return name.substr(0, 1);
  return name.size() == 2 ? name.substr(1) : "u";
}

struct Entries {
  std::vector<double> theta_i, phi_i, theta_r, phi_r, nm, values, sigma;
  std::vector<std::string> light, viewer;
  std::size_t negative = 0, grazing = 0;
};

bool have_sigma(const SampleTable& table) {
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    if (!table.has_sigma(c)) return false;
  return true;
}

Entries entries_of(const SampleTable& table, const std::vector<Band>& bands) {
  Entries e;
  const bool with_sigma = have_sigma(table);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (table.theta_i[k] >= 90 || table.theta_o[k] >= 90) {
      ++e.grazing;
      continue;
    }
    for (std::size_t c = 0; c < bands.size(); ++c) {
      if (table.values[c][k] < 0) {
        ++e.negative;
        continue;
      }
      e.theta_i.push_back(table.theta_i[k]);
      e.phi_i.push_back(within_turn(table.phi_i[k]));
      e.theta_r.push_back(table.theta_o[k]);
      e.phi_r.push_back(within_turn(table.phi_o[k]));
      e.nm.push_back(bands[c].nm);
      e.values.push_back(table.values[c][k]);
      if (with_sigma) e.sigma.push_back(table.sigma[c][k]);
      e.light.push_back(letter(bands[c].polarisation, false));
      e.viewer.push_back(letter(bands[c].polarisation, true));
    }
  }
  if (e.values.empty()) throw InputError(table.name() + ": has no value that a file of BiRD can hold");
  return e;
}

template <class T>
Json variable(const char* key, const char* unit, const std::vector<T>& values) {
  return {{key, unit}, {"values", values}};
}

Json data_of(const Entries& e) {
  Json data;
  if (e.nm[0] != 0) data["wavelength_i"] = variable("unit", "nm", e.nm);
  const auto is_polarised = [](const std::string& state) { return state != "u"; };
  if (std::ranges::any_of(e.light, is_polarised))
    data["polarization_i"] = variable("notation", "sp", e.light);
  if (std::ranges::any_of(e.viewer, is_polarised))
    data["polarization_r"] = variable("notation", "sp", e.viewer);
  data["theta_i"] = variable("unit", "deg", e.theta_i);
  data["phi_i"] = variable("unit", "deg", e.phi_i);
  data["theta_r"] = variable("unit", "deg", e.theta_r);
  data["phi_r"] = variable("unit", "deg", e.phi_r);
  data["BRDF"] = variable("unit", "1/sr", e.values);
  if (!e.sigma.empty()) data["uBRDF"] = variable("unit", "1/sr", e.sigma);
  return data;
}

// The comments that have a place of their own in the file.
constexpr const char *kSample = "sample", *kInstrument = "instrument", *kDate = "date", *kLicence = "license",
                     *kAuthor = "author";

// The schema requires the solid angle of the detector, so that an instrument without one has no place.
Json instrumentation_of(const SampleTable& table) {
  const auto aperture = stated_aperture(table);
  if (!aperture) return "NA";
  const double solid_angle = 2 * kPi * (1 - std::cos(degrees(*aperture / 2).radians()));
  return {
      {"name", table.find_metadata(kInstrument).value_or(kNotStated)},
      {"illumination_system", {{"name", kNotStated}, {"source", Json::object()}, {"beam", Json::object()}}},
      {"detection_system",
       {{"name", kNotStated},
        {"sensors", Json::array()},
        {"solid_angle", {{"value", solid_angle}, {"unit", "sr"}}}}}};
}

Json metadata_of(const SampleTable& table, const std::string& content) {
  const auto text = [&](const char* key) { return table.find_metadata(key).value_or(kNotStated); };
  const bool is_computed = table.find_metadata("truth").has_value() || table.format == "material";
  Json metadata{{"schema",
                 "https://raw.githubusercontent.com/BiRD-project/BiRD_view/master/BRDF_JSON_schema/"
                 "brdf_json_schema_v1.0.json"},
                {"id", "urn:uuid:" + identifier_of(content)},
                {"type", "BRDF"},
                {"timestamp", text(kDate)},
                {"provenance",
                 {{"organization", kNotStated},
                  {"location",
                   {{"country", kNotStated},
                    {"city", kNotStated},
                    {"street", kNotStated},
                    {"building_nr", kNotStated},
                    {"postal_code", kNotStated}}},
                  {"email", kNotStated},
                  {"contact_person", text(kAuthor)}}}};
  if (const auto licence = table.find_metadata(kLicence))
    metadata["license"] = {{"type", *licence}, {"rights_holder", kNotStated}};
  metadata["method"] = is_computed ? "simulation" : "measurement";
  metadata["instrumentation"] = instrumentation_of(table);
  metadata["software"] = {{"name", "brdf"}, {"version", provenance().version}};
  metadata["sample"] = {{"name", text(kSample)},
                        {"type", kNotStated},
                        {"shape", kNotStated},
                        {"dimensions", Json::object()},
                        {"zero_azimuth_location", kNotStated}};
  metadata["environment"] = "NA";
  const bool has_instrument = metadata["instrumentation"].is_object();
  Json others;
  for (const auto& [key, value] : table.metadata) {
    const bool has_place = key == kSample || (key == kInstrument && has_instrument) || key == kDate ||
                           key == kLicence || key == kAuthor || key == kApertureKey;
    if (!has_place)
      others[key.empty() || others.contains(key) ? "comment " + std::to_string(others.size() + 1) : key] =
          value;
  }
  if (!others.is_null()) metadata["adhoc_section"] = std::move(others);
  return metadata;
}

std::vector<std::string> losses_of(const SampleTable& table, const Entries& e) {
  std::vector<std::string> lost;
  bool has_sigma = false;
  for (std::size_t c = 0; c < table.channels.size(); ++c) has_sigma = has_sigma || table.has_sigma(c);
  if (has_sigma && e.sigma.empty()) lost.push_back("standard deviations, which not all channels have");
  if (e.negative > 0) lost.push_back(plural(e.negative, "negative value"));
  if (e.grazing > 0) lost.push_back(plural(e.grazing, "row") + " at 90 degrees");
  return lost;
}

}  // namespace

std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table) {
  const Entries entries = entries_of(table, bands_of(table));
  Json json{{"metadata", nullptr}, {"data", data_of(entries)}};
  json["metadata"] = metadata_of(table, to_line(json["data"]));
  write_json_table(path, json, table);
  return losses_of(table, entries);
}

}  // namespace brdf::io::bird
