#include "synth/grid.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/text.h"
#include "io/formats/merl.h"
#include "io/formats/read.h"
#include "io/samples/degrees.h"

namespace brdf::synth {
namespace {

constexpr double kInPlaneLimit = 85;  // the arm of an instrument rarely gets closer to the horizon
constexpr double kHemisphereLimit = 80;

// Refuses too large a grid before memory is allocated.
void check_rows(double rows) {
  if (rows > static_cast<double>(io::kMostRows))
    throw InputError("the grid has " + io::to_text(rows) + " directions, more than " +
                     std::to_string(io::kMostRows) +
                     " (use a larger --step, or fewer --theta-i or --azimuths)");
}

void add_in_plane(io::SampleTable& grid, const GridOptions& options) {
  const double step = options.step > 0 ? options.step : 1;
  const std::vector<double> own = {0, 15, 30, 45, 60, 75};
  const int last = static_cast<int>(kInPlaneLimit / step);
  const std::vector<double>& incidences = options.theta_i.empty() ? own : options.theta_i;
  check_rows(double(grid.rows()) + double(incidences.size()) * (2.0 * last + 1));
  for (const double theta_i : incidences)
    for (int k = -last; k <= last; ++k)
      grid.add_directions(theta_i, 180, std::abs(k * step), k < 0 ? 180 : 0);
}

void add_hemisphere(io::SampleTable& grid, const GridOptions& options) {
  const double step = options.step > 0 ? options.step : 5;
  const std::vector<double> own = {0, 20, 40, 60, 75};
  const int rings = static_cast<int>(kHemisphereLimit / step);
  const int sectors = std::max(4, static_cast<int>(180 / step));  // twice as wide in azimuth
  const std::vector<double>& incidences = options.theta_i.empty() ? own : options.theta_i;
  check_rows(double(grid.rows()) + double(incidences.size()) * (1 + double(rings) * sectors));
  for (const double theta_i : incidences) {
    grid.add_directions(theta_i, 180, 0, 0);
    for (int ring = 1; ring <= rings; ++ring)
      for (int sector = 0; sector < sectors; ++sector)
        grid.add_directions(theta_i, 180, ring * step, sector * 360.0 / sectors);
  }
}

void add_file(io::SampleTable& grid, const std::string& path) {
  const io::SampleTable file = io::read_directions(path);
  check_rows(double(grid.rows()) + double(file.rows()));
  for (std::size_t k = 0; k < file.rows(); ++k)
    grid.add_directions(file.theta_i[k], file.phi_i[k], file.theta_o[k], file.phi_o[k]);
}

double in_turn(double degrees) {
  const double rest = std::fmod(degrees, 360.0);
  return rest < 0 ? rest + 360.0 : rest;
}

// In the frame of a sample that is rotated by +a, directions rotate by -a.
io::SampleTable turned(const io::SampleTable& grid, const std::vector<double>& azimuths) {
  check_rows(double(grid.rows()) * double(azimuths.size()));
  io::SampleTable all;
  all.reserve(grid.rows() * azimuths.size());
  for (const double azimuth : azimuths)
    for (std::size_t k = 0; k < grid.rows(); ++k) {
      if (azimuth == 0)
        all.add_directions(grid.theta_i[k], grid.phi_i[k], grid.theta_o[k], grid.phi_o[k]);
      else
        all.add_directions(grid.theta_i[k], in_turn(grid.phi_i[k] - azimuth), grid.theta_o[k],
                           in_turn(grid.phi_o[k] - azimuth));
    }
  return all;
}

io::SampleTable outside_blind_zone(const io::SampleTable& grid, double blind_zone) {
  const DirectionArrays<double> d = io::unit_directions(grid);
  const double cos_limit = io::cos_degrees(blind_zone) + 1e-12;  // a step of the grid may fall on the limit
  io::SampleTable seen;
  for (std::size_t k = 0; k < grid.rows(); ++k) {
    const double cosine = dot(d.view().wi(k), d.view().wo(k));
    if (cosine <= cos_limit)
      seen.add_directions(grid.theta_i[k], grid.phi_i[k], grid.theta_o[k], grid.phi_o[k]);
  }
  return seen;
}

void check(const GridOptions& options) {
  const auto refuse = [](const std::string& option, double value, const char* rule) {
    throw InputError(option + " " + io::to_text(value) + ": " + rule);
  };
  for (const double theta : options.theta_i)
    if (!(theta >= 0 && theta < 90)) refuse("--theta-i", theta, "must be at least 0 and below 90 degrees");
  if (options.step != 0 && !(options.step >= 0.01 && options.step <= 45))
    refuse("--step", options.step, "must be between 0.01 and 45 degrees");
  if (!(options.blind_zone >= 0 && options.blind_zone < 180))
    refuse("--blind-zone", options.blind_zone, "must be at least 0 and below 180 degrees");
  for (const double azimuth : options.azimuths)
    if (!(std::abs(azimuth) <= 360)) refuse("--azimuths", azimuth, "must be between -360 and 360 degrees");
}

}  // namespace

io::SampleTable make_grid(const GridOptions& options) {
  check(options);
  io::SampleTable grid;
  for (const std::string& part : options.parts) {
    if (part == "in_plane")
      add_in_plane(grid, options);
    else if (part == "hemisphere")
      add_hemisphere(grid, options);
    else if (part == "merl")
      io::merl::add_cell_directions(grid);
    else
      add_file(grid, part);
  }
  if (options.azimuths != std::vector<double>{0}) grid = turned(grid, options.azimuths);
  if (options.blind_zone > 0) grid = outside_blind_zone(grid, options.blind_zone);
  if (grid.rows() == 0) throw InputError("the grid has no directions");
  return grid;
}

}  // namespace brdf::synth
