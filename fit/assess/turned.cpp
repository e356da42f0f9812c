#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "fit/assess/assess.h"

namespace brdf::fit {
namespace {

// Configurations are compared in cells of this many degrees. The offset keeps round angles away from the
// edges.
constexpr double kPolarCell = 5, kAzimuthCell = 10, kOffset = 1.234;
constexpr double kUpright = 2;   // degrees: below this angle a direction has no azimuth
constexpr double kTurn = 10;     // degrees between two azimuths of the sample
constexpr double kTogether = 5;  // degrees within which light and half vector must turn by the same angle
constexpr std::size_t kMostTurns = 16;

double polar(double z) {
  return std::acos(std::clamp(z, -1.0, 1.0)) / kPi * 180;
}
double azimuth(double x, double y) {
  return std::atan2(y, x) / kPi * 180;
}
std::int64_t cell(double angle, double size) {
  return std::int64_t(std::floor((angle + kOffset) / size));
}

// The azimuths of a configuration: of the light (or of the viewer, if the light is at the normal), and of
// the half vector. Tables of isotropic materials keep the half vector fixed while the light goes around it.
struct Turn {
  double light, half;
  bool differs(const Turn& t) const {
    const double by = std::remainder(light - t.light, 180.0), half_by = std::remainder(half - t.half, 180.0);
    return std::abs(by) >= kTurn && std::abs(std::remainder(by - half_by, 180.0)) <= kTogether;
  }
};

}  // namespace

bool sample_was_turned(const FitData& data) {
  std::unordered_map<std::int64_t, std::vector<Turn>> seen;
  for (std::size_t k = 0; k < data.rows(); ++k) {
    const double theta_i = polar(data.wi_z[k]), theta_o = polar(data.wo_z[k]);
    if (theta_i < kUpright && theta_o < kUpright) continue;
    const double phi_i = azimuth(data.wi_x[k], data.wi_y[k]), phi_o = azimuth(data.wo_x[k], data.wo_y[k]);
    const bool upright = theta_i < kUpright || theta_o < kUpright;
    const Turn turn{theta_i < kUpright ? phi_o : phi_i,
                    azimuth(data.wi_x[k] + data.wo_x[k], data.wi_y[k] + data.wo_y[k])};
    const double between = upright ? 0 : std::fmod(phi_o - phi_i + 720, 360.0);
    const std::int64_t key =
        (cell(theta_i, kPolarCell) * 64 + cell(theta_o, kPolarCell)) * 64 + cell(between, kAzimuthCell);
    std::vector<Turn>& turns = seen[key];
    for (const Turn& other : turns)
      if (turn.differs(other)) return true;
    if (turns.size() < kMostTurns) turns.push_back(turn);
  }
  return false;
}

}  // namespace brdf::fit
