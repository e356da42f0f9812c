#include <algorithm>
#include <cmath>
#include <optional>

#include "brdf/vec3.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/limits.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/text.h"
#include "io/formats/zemax.h"
#include "io/samples/degrees.h"
#include "io/samples/distinct_angles.h"
#include "io/samples/table_rules.h"

namespace brdf::io::zemax {
namespace {

constexpr double kSame = 1e-8;           // degrees between directions taken as equal
constexpr std::size_t kMostEmpty = 8;    // largest number of entries per row
constexpr std::size_t kLongestKey = 40;  // of a comment that is read back as key and value
constexpr std::size_t kBlocks = 0, kThetas = 1, kAzimuths = 2, kRadials = 3;

// The direction of a row about the mirror direction, in degrees.
struct Place {
  std::size_t row;
  double rotation, theta_i, azimuth, radial;
};

Place place_of(const SampleTable& table, std::size_t row, std::optional<double> only_phi_i) {
  const double rotation = only_phi_i ? 0 : 180 - table.phi_i[row], theta_i = table.theta_i[row];
  const double phi = table.phi_o[row] - (only_phi_i ? *only_phi_i - 180 : -rotation);
  const Vec3<double> w = unit_vector(table.theta_o[row], phi);
  const double s = sin_degrees(theta_i), c = cos_degrees(theta_i);
  const Polar at = polar_degrees({s * w.z - c * w.x, -w.y, s * w.x + c * w.z});
  return {row, rotation, theta_i, at.phi, at.theta};
}

// The azimuth of a direction becomes less accurate near the mirror direction.
double azimuth_tolerance(const Place& p) {
  return std::min(kSame / std::max(sin_degrees(p.radial), 1e-12), 180.0);
}

class Grid {
 public:
  explicit Grid(const SampleTable& table) : table_(table) {
    check();
    place_rows();
    find_angles();
    fill();
  }

  std::string text() const {
    std::string out;
    for (const auto& [key, value] : table_.metadata)
      if (is_kept(key, value)) out += "# " + key + ": " + value + "\n";
    out += "Source\tMeasured\nSymmetry\t" + symmetry() + "\nSpectralContent\t" +
           (table_.channels.size() == 1 ? "Monochrome" : "XYZ") + "\nScatterType\tBRDF\n";
    const char* const names[] = {"SampleRotation", "AngleOfIncidence", "ScatterAzimuth", "ScatterRadial"};
    for (std::size_t k = 0; k < 4; ++k)
      out +=
          std::string(names[k]) + "\t" + std::to_string(angles_[k].size()) + "\n" + line(angles_[k].list());
    for (std::size_t c = 0; c < table_.channels.size(); ++c)
      append_channel(c, table_.channels.size() == 1 ? "Monochrome" : "Tristimulus" + table_.channels[c], out);
    return out;
  }

  std::vector<std::string> lost(const SampleTable& back) const {
    std::vector<std::string> out;
    const auto count = [&](std::size_t n, const std::string& noun, const std::string& rest) {
      if (n > 0) out.push_back(plural(n, noun) + rest);
    };
    count(grazing_, "row", " at 90 degrees");
    count(zero_, "row", " with the value 0, which the format defines as 'not measured'");
    count(std::size_t(std::ranges::count_if(table_.metadata,
                                            [](const Comment& c) { return !is_kept(c.first, c.second); })),
          "comment", " that cannot be written as a short key with a value");
    if (table_.channels.size() == 1 && table_.channels[0] != "fr") out.push_back("the channel's name");
    for (std::size_t c = 0; c < table_.channels.size(); ++c)
      if (table_.has_sigma(c)) {
        out.push_back("standard deviations");
        break;
      }
    if (only_phi_i_ && *only_phi_i_ != 180)
      out.push_back("the azimuth of incidence, " + to_text(*only_phi_i_) +
                    " degrees: all azimuths are rotated so that it is 180 degrees");
    if (const std::size_t rows = rows_in_order().size(); rows != back.rows())
      count(rows - back.rows(), "row", " at the horizon");
    else if (const double moved = largest_movement(back); moved > 0)
      out.push_back("directions beyond " + short_number(moved, 2) + " degrees");
    return out;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(table_.name() + ": lens-design text " + what);
  }

  static bool is_kept(const std::string& key, const std::string& value) {
    return !key.empty() && !value.empty() && key.size() < kLongestKey && key != kQuantityKey &&
           key.find(": ") == key.npos;
  }

  void check() const {
    const std::vector<std::string>& names = table_.channels;
    if (names.size() != 1 && names != std::vector<std::string>{"X", "Y", "Z"})
      refuse("stores one channel, or X, Y and Z; the table has " + joined(names));
  }

  void place_rows() {
    only_phi_i_ = table_.rows() > 0 ? std::optional(table_.phi_i[0]) : std::nullopt;
    for (const double phi : table_.phi_i)
      if (phi != table_.phi_i[0]) only_phi_i_ = std::nullopt;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const bool is_grazing = table_.theta_i[row] >= 90 || table_.theta_o[row] >= 90;
      const bool is_zero =
          std::ranges::any_of(table_.values, [&](const std::vector<double>& v) { return v[row] == 0; });
      grazing_ += is_grazing;
      zero_ += is_zero && !is_grazing;
      if (!is_grazing && !is_zero) places_.push_back(place_of(table_, row, only_phi_i_));
    }
    if (places_.empty()) refuse("needs a value that is not 0, at less than 90 degrees");
  }

  // Collects the angles. Rows that determine the azimuth best come first.
  void find_angles() {
    std::ranges::stable_sort(places_, [](const Place& a, const Place& b) {
      return std::abs(a.radial - 90) < std::abs(b.radial - 90);
    });
    for (const Place& p : places_) {
      angles_[kBlocks].add(p.rotation, kSame);
      angles_[kThetas].add(p.theta_i, kSame);
      angles_[kAzimuths].add(p.azimuth, azimuth_tolerance(p));
      angles_[kRadials].add(p.radial, kSame);
    }
    for (DistinctAngles& angles : angles_) angles.number();
    const double entries = double(angles_[0].size()) * double(angles_[1].size()) * double(angles_[2].size()) *
                           double(angles_[3].size());
    if (entries > double(kMostEmpty * places_.size()) || entries > double(kMostRows))
      refuse("stores directions on a grid around the mirror direction: the " + plural(places_.size(), "row") +
             " require " + std::to_string(angles_[kThetas].size()) + " incidences, " +
             std::to_string(angles_[kAzimuths].size()) + " azimuths and " +
             std::to_string(angles_[kRadials].size()) + " radial angles, in all " + short_number(entries) +
             " entries");
    radials_ = angles_[kRadials].list();
    azimuths_ = angles_[kAzimuths].list();
    thetas_ = angles_[kThetas].list();
  }

  std::size_t entry(std::size_t block, std::size_t theta, std::size_t azimuth, std::size_t radial) const {
    return ((block * thetas_.size() + theta) * azimuths_.size() + azimuth) * radials_.size() + radial;
  }

  void fill() {
    row_of_.assign(angles_[kBlocks].size() * thetas_.size() * azimuths_.size() * radials_.size(),
                   std::nullopt);
    for (const Place& p : places_) {
      const std::size_t block = angles_[kBlocks].index(p.rotation), theta = angles_[kThetas].index(p.theta_i),
                        radial = angles_[kRadials].index(p.radial);
      const std::size_t azimuth = angles_[kAzimuths].index(p.azimuth);
      const bool is_mirror = radials_[radial] == 0;  // has an entry for every azimuth
      const std::size_t first = is_mirror ? 0 : azimuth, last = is_mirror ? azimuths_.size() : azimuth + 1;
      for (std::size_t a = first; a < last; ++a) {
        std::optional<std::size_t>& row = row_of_[entry(block, theta, a, radial)];
        if (row)
          refuse("stores each direction once: " + table_.where(*row) + " and " + table_.where(p.row) +
                 " have the same direction (--repeats average combines them)");
        row = p.row;
      }
    }
  }

  std::string symmetry() const {
    if (angles_[kBlocks].size() > 1) return "ASymmetrical4D";
    return azimuths_.front() >= 0 && azimuths_.back() <= 180 ? "PlaneSymmetrical" : "ASymmetrical";
  }

  static std::string line(const std::vector<double>& numbers) {
    std::string out;
    for (const double number : numbers) {
      append_number(out, number);
      out += '\t';
    }
    out.back() = '\n';
    return out;
  }

  void append_channel(std::size_t c, const std::string& name, std::string& out) const {
    out += "\n" + name + "\nDataBegin\n";
    for (std::size_t block = 0; block < angles_[kBlocks].size(); ++block)
      for (std::size_t theta = 0; theta < thetas_.size(); ++theta) {
        std::vector<std::vector<double>> values(azimuths_.size(), std::vector<double>(radials_.size(), 0));
        for (std::size_t a = 0; a < azimuths_.size(); ++a)
          for (std::size_t r = 0; r < radials_.size(); ++r)
            if (const auto row = row_of_[entry(block, theta, a, r)]) values[a][r] = table_.values[c][*row];
        out += "TIS\t" + short_number(scattered_share(thetas_[theta], values), 6) + "\n";
        for (const std::vector<double>& row : values) out += line(row);
      }
    out += "DataEnd\n";
  }

  // Returns the trapezoidal sum of the integral of f_r cos_o. The azimuths of a symmetrical plane count for
  // both halves.
  double scattered_share(double theta_i, const std::vector<std::vector<double>>& values) const {
    const double s = sin_degrees(theta_i), c = cos_degrees(theta_i);
    double sum = 0;
    for (std::size_t a = 0; a < azimuths_.size(); ++a)
      for (std::size_t r = 0; r < radials_.size(); ++r) {
        const double cos_o =
            cos_degrees(radials_[r]) * c + sin_degrees(radials_[r]) * cos_degrees(azimuths_[a]) * s;
        sum += values[a][r] * std::max(cos_o, 0.0) * sin_degrees(radials_[r]) * width(radials_, r) *
               azimuth_width(a);
      }
    return sum;
  }

  static double width(const std::vector<double>& angles, std::size_t k) {
    const double below = k > 0 ? angles[k] - angles[k - 1] : 0,
                 above = k + 1 < angles.size() ? angles[k + 1] - angles[k] : 0;
    return degrees((below + above) / 2).radians();
  }

  double azimuth_width(std::size_t a) const {
    if (azimuths_.size() == 1) return 2 * kPi;
    if (symmetry() == "PlaneSymmetrical") {
      const double before = a == 0 ? azimuths_.front() : 0,
                   behind = a + 1 == azimuths_.size() ? 180 - azimuths_.back() : 0;
      return 2 * (width(azimuths_, a) + degrees(before + behind).radians());
    }
    const double seam = 360 - azimuths_.back() + azimuths_.front();
    const bool is_end = a == 0 || a + 1 == azimuths_.size();
    return width(azimuths_, a) + (is_end ? degrees(seam / 2).radians() : 0);
  }

  // Returns each row once, in the order of the entries.
  std::vector<std::size_t> rows_in_order() const {
    std::vector<std::size_t> rows;
    std::vector<bool> is_seen(table_.rows());
    for (const std::optional<std::size_t>& row : row_of_)
      if (row && !is_seen[*row]) {
        is_seen[*row] = true;
        rows.push_back(*row);
      }
    return rows;
  }

  // Returns the largest angle, in degrees, between a row's direction and the direction that is read back.
  double largest_movement(const SampleTable& back) const {
    double largest = 0;
    std::size_t k = 0;
    for (const std::size_t row : rows_in_order()) {
      const double turned = table_.phi_o[row] - (only_phi_i_ ? *only_phi_i_ - 180 : 0);
      const Vec3<double> w = unit_vector(table_.theta_o[row], turned),
                         v = unit_vector(back.theta_o[k], back.phi_o[k]);
      const Vec3<double> d{w.x - v.x, w.y - v.y, w.z - v.z};
      largest = std::max(largest, radians(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z)).degrees());
      ++k;
    }
    constexpr double kRounding = 1e-13;
    return largest > kRounding ? largest : 0;
  }

  const SampleTable& table_;
  std::optional<double> only_phi_i_;
  std::vector<Place> places_;
  std::size_t grazing_ = 0, zero_ = 0;
  DistinctAngles angles_[4] = {DistinctAngles(), DistinctAngles(), DistinctAngles(360), DistinctAngles()};
  std::vector<double> thetas_, azimuths_, radials_;
  std::vector<std::optional<std::size_t>> row_of_;  // [entry]
};

}  // namespace

std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table) {
  check_table(table);
  const Grid grid(table);
  const Content text{path.string(), grid.text()};
  const std::vector<std::string> lost = grid.lost(read(text));
  write_file_atomically(path, text.bytes);
  return lost;
}

}  // namespace brdf::io::zemax
