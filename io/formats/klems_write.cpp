#include "io/formats/klems_write.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "io/colour/channel_colours.h"
#include "io/colour/in_colour.h"
#include "io/colour/spectrum.h"
#include "io/columns/wavelengths.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/provenance.h"
#include "io/files/text.h"
#include "io/formats/klems_bases.h"
#include "io/samples/degrees.h"

namespace brdf::io::klems {
namespace {

constexpr double kSameDirection = 1e-6;  // degrees
constexpr std::size_t kEmpty = std::numeric_limits<std::size_t>::max();

// The patches of a basis, found by the directions of their centres.
class Centres {
 public:
  explicit Centres(const Basis& basis) : patches_(patches_of(basis.rings)) {
    for (std::size_t k = 0; k < patches_.size(); ++k)
      if (k == 0 || patches_[k].theta != patches_[k - 1].theta) first_[patches_[k].theta] = k;
  }
  std::size_t size() const { return patches_.size(); }
  std::optional<std::size_t> find(double theta, double phi) const {
    const auto ring = first_.lower_bound(theta - kSameDirection);
    if (ring == first_.end() || ring->first > theta + kSameDirection) return std::nullopt;
    const double step = patches_[ring->second].width;
    if (ring->first == 0) return ring->second;  // the azimuth of the normal has no meaning
    const double turns = within_turn(phi) / step, near = std::round(turns);
    if (std::abs(turns - near) * step > kSameDirection) return std::nullopt;
    const auto patch = static_cast<std::size_t>(near);
    return ring->second + patch % static_cast<std::size_t>(std::lround(360 / step));
  }

 private:
  std::vector<Patch> patches_;
  std::map<double, std::size_t> first_;  // the first patch of the ring with this polar angle
};

// The row of each entry, [outgoing][incident].
struct Places {
  const Basis* basis;
  std::size_t size;
  std::vector<std::size_t> row;
};

std::optional<Places> places_in(const Basis& basis, const SampleTable& table, std::string& fault) {
  const Centres centres(basis);
  Places places{&basis, centres.size(), std::vector<std::size_t>(centres.size() * centres.size(), kEmpty)};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto incident = centres.find(table.theta_i[row], table.phi_i[row] + 180),
               outgoing = centres.find(table.theta_o[row], table.phi_o[row]);
    if (!incident || !outgoing) return std::nullopt;
    std::size_t& place = places.row[*outgoing * places.size + *incident];
    if (place != kEmpty) {
      fault = table.where(place) + " and " + table.where(row) +
              " belong to the same pair of patches (--repeats average combines them)";
      return std::nullopt;
    }
    place = row;
  }
  const auto missing = std::size_t(std::ranges::count(places.row, kEmpty));
  if (missing == 0) return places;
  fault = "values for " + std::to_string(missing) + " of the " + plural(places.row.size(), "pair") +
          " of patches of " + basis.name + " are missing";
  return std::nullopt;
}

Places places_of(const SampleTable& table) {
  std::string fault;
  for (const Basis& basis : known_bases())
    if (auto places = places_in(basis, table, fault)) return *places;
  throw InputError(table.name() + ": Klems matrices hold means over patches: " +
                   (fault.empty()
                        ? "the directions of the table are not the centres of the patches of a known basis"
                        : fault) +
                   "; fit a material and convert the material, which is integrated over each patch");
}

// A matrix of the file: a sum of channels.
struct Weighted {
  std::string wavelength, unit;
  std::vector<double> weights;  // of the channels
};

struct Spectra {
  std::vector<Weighted> matrices;
  std::vector<std::string> lost;
};

std::vector<double> only(std::size_t channel, std::size_t count) {
  std::vector<double> weights(count, 0.0);
  weights[channel] = 1;
  return weights;
}

std::vector<double> luminance_weights(const std::vector<double>& nm) {
  std::vector<std::size_t> order(nm.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::size_t k) { return nm[k]; });
  std::vector<double> sorted;
  for (const std::size_t k : order) sorted.push_back(nm[k]);
  const std::vector<Tristimulus> xyz = xyz_weights(sorted, kD65);
  std::vector<double> weights(nm.size());
  for (std::size_t k = 0; k < order.size(); ++k) weights[order[k]] = xyz[k][1];
  return weights;
}

// Returns a matrix for each band, and the luminance if the bands are a visible spectrum.
Spectra bands_of(const SampleTable& table, const std::vector<double>& nm) {
  Spectra spectra;
  for (std::size_t c = 0; c < nm.size(); ++c) {
    if (std::ranges::count(nm, nm[c]) > 1)
      throw InputError(table.name() + ": two channels have the wavelength " + to_text(nm[c]) + " nm");
    spectra.matrices.push_back({to_text(nm[c]), "Nanometer", only(c, nm.size())});
  }
  if (is_spectrum(table.channels))
    spectra.matrices.push_back({"Visible", "Integral", luminance_weights(nm)});
  else
    spectra.lost.push_back("a matrix for visible light, the only one that Radiance reads");
  return spectra;
}

Spectra spectra_of(const SampleTable& table) {
  const std::vector<std::string>& names = table.channels;
  std::vector<double> nm;
  for (const std::string& name : names)
    if (const auto wavelength = wavelength_of(name)) nm.push_back(*wavelength);
  if (nm.size() == names.size()) return bands_of(table, nm);
  const Weighted visible{"Visible", "Integral", only(0, names.size())};
  if (names.size() == 1) return {{visible}, {}};
  if (names == std::vector<std::string>{"X", "Y", "Z"})
    return {{{"Visible", "Integral", only(1, 3)}}, {"the channels X and Z"}};
  const auto colours = channel_colours(names);
  if (!colours || names.size() != 3 || colours->by != ChannelColours::By::name)
    throw InputError(
        table.name() + ": the channels " + joined(names) +
        " have no place in Klems matrices: one channel, r, g, b, X, Y, Z, or wavelengths such as "
        "550nm are written");
  constexpr double kLuminance[] = {0.2126390058715104, 0.7151686787677559, 0.0721923153607337};  // of sRGB
  Weighted luminance{"Visible", "Integral", std::vector<double>(3)};
  for (std::size_t k = 0; k < 3; ++k) luminance.weights[colours->of[k]] = kLuminance[k];
  return {{luminance}, {"the colour: the matrix is the luminance of r, g and b"}};
}

std::string escaped_xml(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      default:
        out += c;
    }
  return out;
}

std::string element(const std::string& name, std::string_view text) {
  return "<" + name + ">" + escaped_xml(text) + "</" + name + ">\n";
}

std::string basis_text(const Basis& basis) {
  std::string out = "<AngleBasis>\n" + element("AngleBasisName", basis.name);
  for (const Ring& ring : basis.rings) {
    const double centre = ring.lower == 0 ? 0 : (ring.lower + ring.upper) / 2;
    out += "<AngleBasisBlock>\n" + element("Theta", to_text(centre)) +
           element("nPhis", std::to_string(ring.patches)) + "<ThetaBounds>\n" +
           element("LowerTheta", to_text(ring.lower)) + element("UpperTheta", to_text(ring.upper)) +
           "</ThetaBounds>\n</AngleBasisBlock>\n";
  }
  return out + "</AngleBasis>\n";
}

// A line holds the values of an outgoing patch.
std::string numbers_of(const SampleTable& table, const Places& places, const std::vector<double>& weights) {
  std::string out;
  for (std::size_t k = 0; k < places.row.size(); ++k) {
    double sum = 0;
    for (std::size_t c = 0; c < weights.size(); ++c)
      if (weights[c] != 0) sum += weights[c] * table.values[c][places.row[k]];
    append_number(out, sum);
    out += k + 1 == places.row.size() ? "\n" : (k + 1) % places.size == 0 ? ",\n" : ", ";
  }
  return out;
}

std::string blocks_of(const SampleTable& table, const Places& places, const Weighted& matrix) {
  const std::string numbers = numbers_of(table, places, matrix.weights);
  std::string out = "<WavelengthData>\n<LayerNumber>System</LayerNumber>\n<Wavelength unit=\"" + matrix.unit +
                    "\">" + matrix.wavelength + "</Wavelength>\n";
  for (const char* const side : {"Reflection Front", "Reflection Back"})
    out += "<WavelengthDataBlock>\n" + element("WavelengthDataDirection", side) +
           element("ColumnAngleBasis", places.basis->name) + element("RowAngleBasis", places.basis->name) +
           element("ScatteringDataType", "BTDF") + "<ScatteringData>\n" + numbers +
           "</ScatteringData>\n</WavelengthDataBlock>\n";
  return out + "</WavelengthData>\n";
}

std::string text_of(const SampleTable& table, const Places& places, const Spectra& spectra) {
  const auto stated = [&](const char* key) { return table.find_metadata(key).value_or(""); };
  std::string name = stated("sample");
  if (name.empty()) name = stated("name");
  if (name.empty()) name = std::filesystem::path(table.name()).stem().string();
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<WindowElement xmlns=\"http://windows.lbl.gov\">\n"
      "<WindowElementType>System</WindowElementType>\n<FileType>BSDF</FileType>\n<Optical>\n<Layer>\n"
      "<Material>\n" +
      element("Name", printable(name, 200));
  if (const std::string maker = stated("manufacturer"); !maker.empty())
    out += element("Manufacturer", printable(maker, 200));
  out += element("Comments", "Written by brdf " + provenance().version +
                                 ". The back is the mirror image of the front. Transmission is not stated.") +
         "</Material>\n<DataDefinition>\n" + element("IncidentDataStructure", "Columns") +
         basis_text(*places.basis) + "</DataDefinition>\n";
  for (const Weighted& matrix : spectra.matrices) out += blocks_of(table, places, matrix);
  return out + "</Layer>\n</Optical>\n</WindowElement>\n";
}

}  // namespace

std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table) {
  const Spectra spectra = spectra_of(table);
  const Places places = places_of(table);
  write_file_atomically(path, text_of(table, places, spectra));
  std::vector<std::string> lost = spectra.lost;
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    if (table.has_sigma(c)) {
      lost.push_back("standard deviations");
      break;
    }
  const auto is_kept = [](const Comment& comment) {
    return comment.first == "sample" || comment.first == "name" || comment.first == "manufacturer";
  };
  if (!std::ranges::all_of(table.metadata, is_kept))
    lost.push_back("comments other than the name and the manufacturer of the sample");
  return lost;
}

}  // namespace brdf::io::klems
