#include "validate/search/pair_search.h"

#include <algorithm>
#include <cmath>

#include "io/files/text.h"
#include "io/samples/degrees.h"
#include "io/samples/samples.h"
#include "validate/search/degrees.h"

namespace brdf::validate {
namespace {

// Corners of the parameter cube (the first 32) and a cover of its interior.
std::vector<std::vector<double>> parameter_points(std::size_t dimensions, std::size_t cover,
                                                  std::uint64_t seed) {
  std::vector<std::vector<double>> points = cube_corners(dimensions, 5);
  if (dimensions > 0)
    for (std::size_t k = 0; k < cover; ++k) points.push_back(cover_point(k, dimensions, seed));
  return points;
}

}  // namespace

Vec3<double> at_cosine(double z, double phi) {
  const double s = std::sqrt(std::max((1 - z) * (1 + z), 0.0));
  return {s * std::cos(phi), s * std::sin(phi), z};
}

Pair pair_at(double a, double b, double turn_o, double turn_i) {
  const auto place = [](double t, double phi, double& theta) {
    const double z = std::pow(10.0, -6 * t), s = std::sqrt((1 - z) * (1 + z));
    theta = in_degrees(std::atan2(s, z));
    return at_cosine(z, phi);
  };
  Pair pair;
  const double phi_i = kPi * turn_i, phi_o = phi_i + kPi * turn_o;
  pair.wi = place(a, phi_i, pair.theta_i);
  pair.wo = place(b, phi_o, pair.theta_o);
  pair.phi_i = in_degrees(phi_i);
  pair.phi_o = in_degrees(phi_o);
  return pair;
}

Pair pair_at_angles(double theta_i, double phi_i, double theta_o, double phi_o) {
  return {io::unit_vector(theta_i, phi_i), io::unit_vector(theta_o, phi_o), theta_i, phi_i, theta_o, phi_o};
}

std::size_t pair_dimensions(const Subject& subject) {
  return subject.dimensions() + (subject.anisotropic() ? 4 : 3);
}

Pair pair_of(const Subject& subject, std::span<const double> point) {
  const std::size_t p = subject.dimensions();
  const OutsideFacts* facts = subject.outside_facts();
  const double turn = facts && facts->all_round ? 2 : 1;
  const Pair pair =
      pair_at(point[p], point[p + 1], turn * point[p + 2], subject.anisotropic() ? turn * point[p + 3] : 0);
  return facts ? pair_at_angles(pair.theta_i, pair.phi_i, pair.theta_o, pair.phi_o) : pair;
}

double difference(double a, double b, double least) {
  const double scale = std::max(std::abs(a), std::abs(b));
  return scale < kTiny ? 0 : std::abs(a - b) / std::max(scale, least);
}

std::size_t parameter_cover(const CheckOptions& options) {
  return options.effort == Effort::full ? 48 : 12;
}

Best worst_pair(const Subject& subject, const PairMeasure& measure, const CheckOptions& options) {
  return worst_pair(subject, measure, options,
                    parameter_points(subject.dimensions(), parameter_cover(options), options.seed));
}

Best worst_pair(const Subject& subject, const PairMeasure& measure, const CheckOptions& options,
                const std::vector<std::vector<double>>& parameters) {
  const bool full = options.effort == Effort::full;
  std::vector<std::vector<double>> grid;
  const std::vector<double> cosines{0, 0.05, 0.15, 0.3, 0.5, 0.75, 1};
  for (const auto& at : parameters)
    for (const double a : cosines)
      for (const double b : cosines)
        for (const double turn : {0.0, 0.2, 0.5, 0.8, 1.0}) {
          std::vector<double> point = at;
          point.insert(point.end(), {a, b, turn});
          if (subject.anisotropic()) point.push_back(0.15);
          grid.push_back(std::move(point));
        }
  SearchOptions search;
  search.cover = full ? 20000 : 3000;
  search.starts = full ? 24 : 8;
  search.steps = full ? 120 : 60;
  search.seed = options.seed;
  search.budget = options.budget;
  const Objective objective = [&](std::span<const double> point) {
    return measure(subject.at(point), pair_of(subject, point));
  };
  return maximise(objective, pair_dimensions(subject), search, grid);
}

Witness pair_witness(const Subject& subject, const Material& at, const Pair& pair, bool both_orders,
                     const Pair* other) {
  Witness w;
  w.parameters = subject.parameters(at);
  w.angles = {
      {"theta_i", pair.theta_i}, {"phi_i", pair.phi_i}, {"theta_o", pair.theta_o}, {"phi_o", pair.phi_o}};
  const auto row = [](std::initializer_list<double> angles) {
    std::string text;
    for (const double angle : angles) text += (text.empty() ? "" : ",") + io::to_text(angle);
    return text + "\\n";
  };
  std::string rows = row({pair.theta_i, pair.phi_i, pair.theta_o, pair.phi_o});
  if (both_orders) rows += row({pair.theta_o, pair.phi_o, pair.theta_i, pair.phi_i});
  if (other) rows += row({other->theta_i, other->phi_i, other->theta_o, other->phi_o});
  if (const std::string eval = subject.command("eval", at, "pair.csv"); !eval.empty())
    w.command = "printf 'theta_i,phi_i,theta_o,phi_o\\n" + rows + "' > pair.csv && " + eval;
  return w;
}

}  // namespace brdf::validate
