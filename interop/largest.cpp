#include <algorithm>
#include <array>
#include <cmath>

#include "interop/loss.h"
#include "interop/pairs.h"
#include "io/samples/degrees.h"
#include "validate/search/search.h"

namespace brdf::interop {
namespace {

// Evaluates both materials at a pair of directions.
class Difference {
 public:
  Difference(const Material& wanted, const Material& carried)
      : wanted_(wanted), carried_(carried), f_(wanted.channels.size()), g_(wanted.channels.size()) {}

  Largest at(double theta_i, double phi_i, double theta_o, double phi_o) {
    const Vec3<double> wi = io::unit_vector(theta_i, phi_i), wo = io::unit_vector(theta_o, phi_o);
    eval(wanted_, wi, wo, f_);
    eval(carried_, wi, wo, g_);
    Largest out{-1, theta_i, phi_i, theta_o, phi_o};
    for (std::size_t c = 0; c < f_.size(); ++c) {
      const double difference = relative_difference(f_[c], g_[c]);
      if (!(difference > out.difference)) continue;
      out.difference = difference;
      out.wanted = f_[c], out.carried = g_[c];
      out.channel = wanted_.channels[c];
    }
    return out;
  }

 private:
  const Material &wanted_, &carried_;
  std::vector<double> f_, g_;
};

// A point of the unit cube in which the climbs move: both polar angles, the azimuth between the directions,
// and for materials that may change as the sample is turned also the azimuth of incidence.
struct Cube {
  bool turned;

  std::size_t dimensions() const { return turned ? 4 : 3; }
  std::vector<double> point(double theta_i, double phi_i, double theta_o, double phi_o) const {
    const auto part = [](double degrees) { return degrees / 360 - std::floor(degrees / 360); };
    std::vector<double> at{theta_i / kMostTheta, theta_o / kMostTheta, part(phi_o - phi_i)};
    if (turned) at.push_back(part(phi_i));
    return at;
  }
};

}  // namespace

double Largest::phi() const {
  return std::abs(std::remainder(phi_o - phi_i, 360));
}

Largest Comparison::largest_of(const Material& carried) const {
  constexpr std::size_t kClimbs = 12, kKept = 400;
  Difference difference(wanted_, carried);
  const Cube cube{may_turn(wanted_)};
  const Directions<double> net = net_.view();
  const std::vector<std::vector<double>> values = values_at(carried, net);
  // validate::maximise() itself selects starting points that are apart from each other.
  std::vector<std::pair<double, std::size_t>> worst(net.count);
  for (std::size_t k = 0; k < net.count; ++k) {
    worst[k] = {0, k};
    for (std::size_t c = 0; c < values.size(); ++c)
      worst[k].first = std::max(worst[k].first, relative_difference(at_net_[c][k], values[c][k]));
  }
  const std::size_t kept = std::min(kKept, worst.size());
  std::ranges::partial_sort(worst, worst.begin() + long(kept), std::greater<>());
  Largest best;
  best.difference = -1;
  std::vector<std::vector<double>> starts;
  for (std::size_t k = 0; k < kept; ++k) {
    const io::Polar light = io::polar_degrees(net.wi(worst[k].second)),
                    viewer = io::polar_degrees(net.wo(worst[k].second));
    starts.push_back(cube.point(std::min(light.theta, kMostTheta), light.phi,
                                std::min(viewer.theta, kMostTheta), viewer.phi));
  }
  const auto objective = [&](std::span<const double> x) {
    const double phi_i = x.size() > 3 ? 360 * x[3] : 0;
    const Largest here = difference.at(kMostTheta * x[0], phi_i, kMostTheta * x[1], phi_i + 360 * x[2]);
    if (here.difference > best.difference) best = here;
    return here.difference;
  };
  validate::SearchOptions options;
  options.cover = 0;
  options.starts = options.polish = kClimbs;
  options.finest = 1e-6;
  validate::maximise(objective, cube.dimensions(), options, starts);
  return best;
}

Largest Comparison::largest_beyond(const Material& carried) const {
  constexpr std::array kSteep{81., 83., 85., 87., 88., 89., 89.5, 89.9, 89.99};  // degrees
  constexpr std::array kOthers{0., 30., 60., 80.};
  Difference difference(wanted_, carried);
  Largest best;
  best.difference = -1;
  const auto look = [&](double theta_i, double theta_o) {
    for (double phi_i = 0; phi_i <= (may_turn(wanted_) ? 90 : 0); phi_i += 22.5)
      for (double phi = 0; phi < 360; phi += 22.5) {
        const Largest here = difference.at(theta_i, phi_i, theta_o, phi_i + phi);
        if (here.difference > best.difference) best = here;
      }
  };
  for (const double steep : kSteep) {
    for (const double other : kOthers) look(steep, other), look(other, steep);
    for (const double other : kSteep) look(steep, other);
  }
  return best;
}

}  // namespace brdf::interop
