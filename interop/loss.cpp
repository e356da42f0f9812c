#include "interop/loss.h"

#include <algorithm>
#include <cmath>

#include "brdf/integrals.h"
#include "interop/pairs.h"
#include "io/numbers.h"

namespace brdf::interop {
namespace {

// Both materials at the pairs, channel by channel: [channel][row].
std::vector<std::vector<double>> values_of(const Material& material, const Directions<double>& d) {
  std::vector<std::vector<double>> out(material.channels.size(), std::vector<double>(d.count));
  std::vector<double> f(material.channels.size());
  for (std::size_t k = 0; k < d.count; ++k) {
    brdf::eval(material, d.wi(k), d.wo(k), f);
    for (std::size_t c = 0; c < f.size(); ++c) out[c][k] = f[c];
  }
  return out;
}

void compare_albedos(const Material& a, const Material& b, Loss& loss) {
  for (const double theta : {0.0, 30.0, 60.0, 75.0}) {
    const auto first = directional_albedo(a, degrees(theta), {}, {.tolerance = 1e-5});
    const auto second = directional_albedo(b, degrees(theta), {}, {.tolerance = 1e-5});
    for (std::size_t c = 0; c < first.size(); ++c) {
      const double difference = std::abs(first[c].value - second[c].value);
      if (difference <= loss.albedo) continue;
      loss.albedo = difference;
      loss.albedo_theta = theta;
    }
  }
}

}  // namespace

Loss loss_of(const Wanted& wanted, const Material& carried) {
  const io::SampleTable pairs = pairs_about(wanted, Pairs::judged);
  const DirectionArrays<double> arrays = io::unit_directions(pairs);
  const Directions<double> d = arrays.view();
  const auto given = values_of(wanted.material, d), got = values_of(carried, d);
  Loss loss;
  std::vector<double> differences;
  double sum = 0;
  for (std::size_t c = 0; c < given.size(); ++c)
    for (std::size_t k = 0; k < d.count; ++k) {
      const double f = given[c][k], g = got[c][k], cos_i = d.wi_z[k];
      const double residual = std::log1p(g * cos_i) - std::log1p(f * cos_i);
      sum += residual * residual;
      differences.push_back(std::abs(g - f) / (f + kDark));
      if (differences.back() <= loss.largest) continue;
      loss.largest = differences.back();
      loss.theta_i = pairs.theta_i[k];
      loss.theta_o = pairs.theta_o[k];
      loss.phi = std::remainder(pairs.phi_o[k] - pairs.phi_i[k], 360);
    }
  loss.rms = std::sqrt(sum / double(differences.size()));
  loss.median = io::median(differences);
  compare_albedos(wanted.material, carried, loss);
  return loss;
}

bool is_nearer(const Loss& one, const Loss& other) {
  constexpr double kSeen = 0.02;
  return one.rms < other.rms && one.median <= std::max(2 * other.median, kSeen);
}

std::string in_words(const Loss& loss) {
  const auto number = [](double x) { return io::short_number(x, 3); };
  return "largest " + io::percent(loss.largest) + " (theta_i " + number(loss.theta_i) + ", theta_o " +
         number(loss.theta_o) + ", phi " + number(std::abs(loss.phi)) + "), median " +
         io::percent(loss.median) + ", albedo within " + number(loss.albedo) + " (at " +
         number(loss.albedo_theta) + "), rms " + number(loss.rms);
}

}  // namespace brdf::interop
