#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "brdf/angle.h"
#include "io/columns/wavelengths.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/formats/json_metadata.h"
#include "io/formats/openmaterial.h"
#include "io/samples/aperture.h"

namespace brdf::io::openmaterial {
namespace {

using Row = std::array<double, 5>;  // wavelength in m, theta_i, theta_o, phi_o in radians, value

constexpr double kLargestPolar = 1.570796;                       // radians; of the schema
constexpr double kShortestWave = 1e-9, kLongestWave = 17.16e-3;  // m; of the schema

std::vector<double> metres_of(const SampleTable& table) {
  std::vector<double> metres;
  for (const std::string& channel : table.channels) {
    const std::optional<double> nm = wavelength_of(channel);
    if (!nm)
      throw InputError(table.name() + ": channel " + shown(channel) +
                       " has no wavelength: OpenMATERIAL needs channels such as 550nm");
    double value;  // 550nm becomes 5.5e-07, the nearest number, which a division does not always give
    parse_number(to_text(*nm) + "e-9", value);
    metres.push_back(value > 0 ? value : *nm / 1e9);
    if (!(metres.back() >= kShortestWave && metres.back() <= kLongestWave))
      throw InputError(table.name() + ": channel " + shown(channel) +
                       ": OpenMATERIAL holds wavelengths from 1 nm to 17.16 mm");
    if (std::count(metres.begin(), metres.end(), metres.back()) > 1)
      throw InputError(table.name() + ": two channels have the wavelength " + to_text(*nm) + " nm");
  }
  return metres;
}

// Returns the azimuth of the viewer from the light's, in [0, 2 pi) and below the schema's 6.283185.
double azimuth_between(const SampleTable& table, std::size_t row) {
  constexpr double kLargest = 6.283185;
  double turn = std::fmod(table.phi_o[row] - table.phi_i[row], 360.0);
  if (turn < 0) turn += 360;
  const double phi = degrees(turn).radians();
  return phi < kLargest ? phi + 0.0 : 0;
}

struct Rows {
  std::vector<Row> all;
  std::size_t negative = 0, grazing = 0;
};

Rows rows_of(const SampleTable& table) {
  const std::vector<double> metres = metres_of(table);
  Rows rows;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double theta_i = degrees(table.theta_i[k]).radians(), theta_o = degrees(table.theta_o[k]).radians();
    if (std::max(theta_i, theta_o) > kLargestPolar) {
      ++rows.grazing;
      continue;
    }
    for (std::size_t c = 0; c < metres.size(); ++c) {
      const double value = table.values[c][k];
      rows.negative += value < 0;
      if (value >= 0) rows.all.push_back({metres[c], theta_i, theta_o, azimuth_between(table, k), value});
    }
  }
  std::sort(rows.all.begin(), rows.all.end());
  if (rows.all.empty()) throw InputError(table.name() + ": has no value that OpenMATERIAL can hold");
  return rows;
}

std::string stem_of(const SampleTable& table) {
  return std::filesystem::path(table.name()).stem().string();
}

Json metadata_of(const SampleTable& table, const std::string& content) {
  const auto text = [&](const char* key, const std::string& other) {
    return table.find_metadata(key).value_or(other);
  };
  Json metadata;
  metadata["name"] = text("sample", text("name", stem_of(table)));
  metadata["uuid"] = identifier_of(content);
  metadata["materialVersion"] = "1.0.0";
  metadata["openMaterial3dVersion"] = "1.1.0";
  metadata["copyrights"] = Json::array({text("copyright", "not stated")});
  metadata["license"] = text("license", "not stated");
  metadata["authors"] = Json::array({text("author", "not stated")});
  metadata["sources"] = text("source", "written by brdf from " + stem_of(table));
  return metadata;
}

std::vector<std::string> losses_of(const SampleTable& table, const Rows& rows) {
  std::vector<std::string> lost;
  if (std::any_of(table.phi_i.begin(), table.phi_i.end(), [](double phi) { return phi != 0; }))
    lost.push_back("azimuths other than the difference of both directions");
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    if (table.has_sigma(c)) {
      lost.push_back("standard deviations");
      break;
    }
  if (rows.negative > 0) lost.push_back(plural(rows.negative, "negative value"));
  if (rows.grazing > 0) lost.push_back(plural(rows.grazing, "row") + " at 90 degrees");
  if (!table.metadata.empty()) lost.push_back("comments other than sample, license, author and source");
  return lost;
}

}  // namespace

std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table) {
  const Rows rows = rows_of(table);
  Json list = Json::array();
  std::set<double> wavelengths;
  for (const Row& row : rows.all) {
    list.push_back(row);
    wavelengths.insert(row[0]);
  }
  Json brdf;
  brdf["wavelengths"] = wavelengths;
  if (const auto aperture = stated_aperture(table)) {
    const double solid_angle = 2 * kPi * (1 - std::cos(degrees(*aperture / 2).radians()));
    for (const double wavelength : wavelengths)
      brdf["receiverSolidAngles"].push_back({{"wavelength", wavelength}, {"solidAngle", solid_angle}});
  }
  brdf["lookupTable"] = std::move(list);
  Json json;
  json["metadata"] = metadata_of(table, to_line(brdf));
  json["brdf"] = std::move(brdf);
  write_json_table(path, json, table);
  return losses_of(table, rows);
}

}  // namespace brdf::io::openmaterial
