#include "io/samples/distinct_angles.h"

#include <cmath>
#include <limits>

namespace brdf::io {
namespace {

double set_point(double degrees) {
  constexpr double kPerDegree = 1e6, kMeant = 1e-7;
  const double few = std::round(degrees * kPerDegree) / kPerDegree;
  return std::abs(few - degrees) < kMeant ? few + 0.0 : degrees;  // + 0 turns -0 into 0
}

}  // namespace

void DistinctAngles::add(double angle, double tolerance) {
  if (find(angle, tolerance)) return;
  const double meant = set_point(angle);
  angles_.emplace(turn_ > 0 && meant >= turn_ ? meant - turn_ : meant, 0);
}

void DistinctAngles::number() {
  std::size_t k = 0;
  for (auto& [angle, index] : angles_) index = k++;
}

std::size_t DistinctAngles::index(double angle) const {
  return find(angle, std::numeric_limits<double>::infinity())->second;
}

std::vector<double> DistinctAngles::list() const {
  std::vector<double> out;
  for (const auto& [angle, index] : angles_) out.push_back(angle);
  return out;
}

const DistinctAngles::Entry* DistinctAngles::find(double angle, double tolerance) const {
  const Entry* nearest = nullptr;
  double distance = tolerance;
  const auto consider = [&](std::map<double, std::size_t>::const_iterator at, double wanted) {
    if (at == angles_.end() || std::abs(at->first - wanted) > distance) return;
    distance = std::abs(at->first - wanted);
    nearest = &*at;
  };
  for (const double wanted : {angle, angle - turn_, angle + turn_}) {
    const auto next = angles_.lower_bound(wanted);
    consider(next, wanted);
    if (next != angles_.begin()) consider(std::prev(next), wanted);
  }
  return nearest;
}

}  // namespace brdf::io
