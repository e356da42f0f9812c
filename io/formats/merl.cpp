#include "io/formats/merl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include "brdf/vec3.h"
#include "io/colour/channel_colours.h"
#include "io/colour/in_colour.h"
#include "io/columns/stated_quantity.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/text.h"
#include "io/samples/degrees.h"

namespace brdf::io::merl {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

struct SineCosine {
  double sine, cosine;
};

template <std::size_t n, class Angle>
std::array<SineCosine, n> table_of(Angle degrees) {
  std::array<SineCosine, n> table;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = degrees(static_cast<double>(k) + 0.5);
    table[k] = {sin_degrees(angle), cos_degrees(angle)};
  }
  return table;
}

using Header = std::array<std::int32_t, 3>;

Header header_of(const Content& content) {
  Header header{};
  std::memcpy(header.data(), content.bytes.data(), sizeof header);
  return header;
}

std::size_t clamped(double index, int count) {
  return static_cast<std::size_t>(std::clamp(static_cast<int>(index), 0, count - 1));
}

}  // namespace

CellDirections cell_directions(std::size_t cell) {
  static const auto half = table_of<kThetaHalf>([](double i) { return 90.0 * (i / 90.0) * (i / 90.0); });
  static const auto difference = table_of<kThetaDifference>([](double j) { return j; });
  static const auto azimuth = table_of<kPhiDifference>([](double k) { return k; });
  const SineCosine& h = half[cell / (kPhiDifference * kThetaDifference)];
  const SineCosine& d = difference[cell / kPhiDifference % kThetaDifference];
  const SineCosine& p = azimuth[cell % kPhiDifference];
  // Rotate the direction of incidence from the frame of the half vector to that of the surface. The viewing
  // direction is its mirror image about the half vector.
  const double x = d.sine * p.cosine, y = d.sine * p.sine, z = d.cosine;
  const Polar light = polar_degrees({h.cosine * x + h.sine * z, y, h.cosine * z - h.sine * x});
  const Polar viewer = polar_degrees({h.sine * z - h.cosine * x, -y, h.cosine * z + h.sine * x});
  return {light.theta, light.phi, viewer.theta, viewer.phi};
}

std::size_t find_cell(double theta_i, double phi_i, double theta_o, double phi_o) {
  const Vec3<double> wi = unit_vector(theta_i, phi_i), wo = unit_vector(theta_o, phi_o);
  const Vec3<double> sum = wi + wo;
  const double length = std::sqrt(dot(sum, sum));
  if (!(length > 0)) return kCells - 1;
  const Vec3<double> h{sum.x / length, sum.y / length, sum.z / length};
  const double sine = std::sqrt(h.x * h.x + h.y * h.y);
  const double c = sine > 0 ? h.x / sine : 1.0, s = sine > 0 ? h.y / sine : 0.0;
  // Rotate into the frame of the half vector: first the azimuth of the half vector to 0, then its polar
  // angle.
  const double x = wi.x * c + wi.y * s, y = wi.y * c - wi.x * s;
  const double dx = h.z * x - sine * wi.z, dz = sine * x + h.z * wi.z;
  const double theta_h = std::atan2(sine, h.z) / kDegree;
  const double theta_d = std::atan2(std::sqrt(dx * dx + y * y), dz) / kDegree;
  double phi_d = std::atan2(y, dx) / kDegree;
  if (phi_d < 0) phi_d += 180.0;
  const std::size_t i = clamped(90.0 * std::sqrt(theta_h / 90.0), kThetaHalf);
  const std::size_t j = clamped(theta_d, kThetaDifference);
  const std::size_t k = clamped(phi_d, kPhiDifference);
  return (i * kThetaDifference + j) * kPhiDifference + k;
}

void add_cell_directions(SampleTable& table) {
  table.reserve(table.rows() + kCells);
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const CellDirections c = cell_directions(cell);
    if (c.theta_i > 90 || c.theta_o > 90) continue;
    table.add_directions(c.theta_i, c.phi_i, c.theta_o, c.phi_o);
  }
}

SampleTable read(const Content& content, const Supplied& supplied) {
  require_f_r(content.name, supplied);
  const auto [theta_half, theta_difference, phi_difference] = header_of(content);
  const auto refuse = [&](const std::string& what) {
    throw InputError(content.name + ": the MERL file " + what);
  };
  if (theta_half != kThetaHalf || theta_difference != kThetaDifference || phi_difference != kPhiDifference)
    refuse("has " + std::to_string(theta_half) + " x " + std::to_string(theta_difference) + " x " +
           std::to_string(phi_difference) + " cells, not 90 x 90 x 180");
  constexpr std::size_t kPlane = kCells * sizeof(double), kSize = sizeof(Header) + 3 * kPlane;
  if (content.bytes.size() != kSize)
    refuse("has " + std::to_string(content.bytes.size()) + " bytes, but 90 x 90 x 180 x 3 cells require " +
           std::to_string(kSize));
  SampleTable table;
  table.source = content.name;
  table.format = "merl";
  table.channels = {"r", "g", "b"};
  table.sigma.resize(3);
  for (std::size_t c = 0; c < 3; ++c)
    std::memcpy(table.values.emplace_back(kCells).data(), content.bytes.data() + sizeof(Header) + c * kPlane,
                kPlane);
  table.reserve(kCells);
  std::size_t kept = 0;
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const auto is_valid = [&](const std::vector<double>& plane) {
      return plane[cell] >= 0 && std::isfinite(plane[cell]);
    };
    if (!std::ranges::all_of(table.values, is_valid)) continue;
    const CellDirections d = cell_directions(cell);
    if (d.theta_i > 90 || d.theta_o > 90) continue;
    table.add_directions(d.theta_i, d.phi_i, d.theta_o, d.phi_o);
    for (std::size_t c = 0; c < 3; ++c) table.values[c][kept] = table.values[c][cell] * kScale[c];
    ++kept;
  }
  for (auto& plane : table.values) plane.resize(kept);
  table.skipped = kCells - kept;
  if (kept == 0) throw InputError(table.source + ": the MERL file holds no valid cell");
  table.warnings.push_back(std::to_string(table.skipped) + " of " + std::to_string(kCells) +
                           " cells have no value (negative, or below the horizon)");
  return table;
}

bool recognises(const Content& content) {
  if (content.bytes.size() < sizeof(Header)) return false;
  const Header header = header_of(content);
  return std::ranges::all_of(header, [](std::int32_t n) { return n > 0 && n < (1 << 16); });
}

std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& given) {
  const SampleTable table = in_colour(given);
  const std::size_t channels = table.channels.size();
  const std::optional<ChannelColours> colours = channel_colours(table.channels);
  if (!colours)
    throw InputError(table.name() + ": a MERL file stores red, green and blue, and the table has " +
                     plural(channels, "channel") + " without a colour");
  std::vector<std::uint32_t> count(kCells);
  std::vector<std::vector<double>> sum(channels, std::vector<double>(kCells));
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const std::size_t cell = find_cell(table.theta_i[k], table.phi_i[k], table.theta_o[k], table.phi_o[k]);
    ++count[cell];
    for (std::size_t c = 0; c < channels; ++c) sum[c][cell] += table.values[c][k];
  }
  std::size_t negative = 0;
  write_file_atomically(path, [&](std::ostream& out) {
    const std::int32_t dimensions[3] = {kThetaHalf, kThetaDifference, kPhiDifference};
    out.write(reinterpret_cast<const char*>(dimensions), sizeof dimensions);
    std::vector<double> plane(kCells);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::vector<double>& values = sum[colours->of[c]];
      for (std::size_t cell = 0; cell < kCells; ++cell) {
        plane[cell] = -1.0;  // no value
        if (count[cell] == 0) continue;
        const double mean = values[cell] / count[cell];
        negative += mean < 0;
        plane[cell] = std::max(mean, 0.0) / kScale[c];
        if (!std::isfinite(plane[cell]))
          throw InputError(table.name() + ": values about " + to_text(mean) +
                           " are outside the range of a MERL file");
      }
      out.write(reinterpret_cast<const char*>(plane.data()),
                static_cast<std::streamsize>(kCells * sizeof(double)));
    }
  });
  const auto filled = static_cast<std::size_t>(std::ranges::count_if(count, [](auto n) { return n > 0; }));
  std::vector<std::string> lost = {
      "the absolute azimuth: MERL files are isotropic and reciprocal",
      "directions: each value is stored at the centre of its cell (1 degree, finer in theta_half)"};
  if (filled < table.rows())
    lost.push_back(plural(table.rows() - filled, "row") + " averaged with other rows of the same cell");
  lost.push_back(std::to_string(kCells - filled) + " of " + std::to_string(kCells) + " cells have no value");
  if (negative > 0) lost.push_back(std::to_string(negative) + " negative means set to 0");
  if (channels == 1) lost.push_back("one channel written as three equal ones");
  if (!colours->note.empty()) lost.push_back("the channels' names: " + colours->note);
  if (is_spectrum(given.channels)) lost.push_back("the spectrum: " + channel_colours(given.channels)->note);
  if (!table.metadata.empty()) lost.push_back("the header's comments");
  for (std::size_t c = 0; c < channels; ++c)
    if (table.has_sigma(c)) {
      lost.push_back("the standard deviations");
      break;
    }
  return lost;
}

}  // namespace brdf::io::merl
