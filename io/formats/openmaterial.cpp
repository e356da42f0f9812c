// Look-up tables of ASAM OpenMATERIAL 3D: JSON with rows of wavelength in m, theta_i, theta_o and phi_o in
// radians, and f_r.
#include <array>
#include <cmath>
#include <optional>

#include "io/columns/foreign_json.h"
#include "io/columns/stated_quantity.h"
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

namespace brdf::io::openmaterial {
namespace {

constexpr std::size_t kColumns = 5;
constexpr const char* kNames[kColumns] = {"wavelength", "theta_i", "theta_o", "phi_o", "value"};

class Reader {
 public:
  Reader(const Json& json, std::string file) : root_(json, std::move(file)) {
    table_.source = root_.file();
    table_.format = "openmaterial";
    table_.set_channels({"fr"});
  }

  SampleTable read() {
    if (root_.has("metadata")) add_metadata(table_, root_.at("metadata").value());
    const JsonPlace brdf = root_.at("brdf");
    if (brdf.has("receiverSolidAngles")) read_solid_angles(brdf.at("receiverSolidAngles"));
    const JsonPlace rows = brdf.at("lookupTable");
    for (std::size_t k = 0; k < rows.size(); ++k) read_row(rows, k);
    rows_.finish();
    table_.warnings.push_back(
        "read as f_r in 1/sr, wavelengths in m, angles in radians, mirror direction at phi_o = 180 degrees");
    SampleTable wide = all_bands(std::move(table_), std::move(bands_));
    check_highlight(wide);
    return wide;
  }

 private:
  void read_solid_angles(const JsonPlace& list) {
    std::optional<double> common;
    bool differ = false;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const double solid_angle = list.at(k).at("solidAngle").number();
      differ = differ || (common && *common != solid_angle);
      common = solid_angle;
    }
    if (differ)
      table_.warnings.push_back(
          "the detector's solid angle depends on the wavelength: no aperture is taken from the file");
    else if (common)
      state_solid_angle(table_, *common);
  }

  // A null in any place means that the row has no value.
  void read_row(const JsonPlace& rows, std::size_t k) {
    const Json& row = rows.value()[k];
    if (!row.is_array() || row.size() != kColumns)
      rows.at(k).fail("must be a row of 5: wavelength, theta_i, theta_o, phi_o, value");
    std::array<double, kColumns> numbers;
    for (std::size_t c = 0; c < kColumns; ++c) {
      if (row[c].is_null()) return rows_.leave_out("a member is null");
      if (!row[c].is_number())
        rows.at(k).at(c).fail("(" + std::string(kNames[c]) + ") must be a number or null");
      numbers[c] = row[c].get<double>();
    }
    check_units(rows, k, numbers);
    if (!rows_.add(degrees_of_printed_radians(numbers[1]), 0, degrees_of_printed_radians(numbers[2]),
                   degrees_of_printed_radians(numbers[3])))
      return;
    table_.values[0].push_back(numbers[4]);
    bands_.push_back({wavelength_in_nm(numbers[0]), std::nullopt});
  }

  static void check_units(const JsonPlace& rows, std::size_t k, const std::array<double, kColumns>& numbers) {
    constexpr double kShortest = 1e-9, kLongest = 0.02, kPolar = 3.1416, kTurn = 6.2832;
    if (!(numbers[0] >= kShortest && numbers[0] <= kLongest))
      rows.at(k).at(0).fail("is not a wavelength in m (1e-9 to 0.02)");
    for (const std::size_t c : {1, 2})
      if (!(std::abs(numbers[c]) <= kPolar))
        rows.at(k).at(c).fail("(" + std::string(kNames[c]) + ") is not an angle in radians");
    if (!(std::abs(numbers[3]) <= kTurn)) rows.at(k).at(3).fail("(phi_o) is not an angle in radians");
  }

  JsonPlace root_;
  SampleTable table_;
  ForeignRows rows_{table_, ForeignRows::GrazingViewer::kept};  // the format allows pi/2
  std::vector<Band> bands_;
};

}  // namespace

bool recognises(const Content& text) {
  return is_json(text) && json_table(text) == JsonTable::openmaterial;
}

SampleTable read(const Content& text, const Supplied& supplied) {
  require_f_r(text.name, supplied);
  return Reader(read_json(text), text.name).read();
}

}  // namespace brdf::io::openmaterial
