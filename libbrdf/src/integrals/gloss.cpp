// Readings of glossmeters: the mean over the source of the light that a receptor gets, by Gauss rules whose
// nodes gather at the specular direction.
#include "brdf/gloss.h"

#include <algorithm>
#include <cmath>

#include "brdf/fresnel.h"
#include "brdf/quadrature.h"
#include "libbrdf/src/integrals/convergence.h"
#include "libbrdf/src/integrals/functions.h"
#include "libbrdf/src/integrals/integrand.h"

namespace brdf {
namespace integrals {
namespace {

// Points per dimension of the receptor. The source has half as many.
constexpr std::array kGlossOrders{8, 12, 16, 24, 32, 48, 64, 96};

double half_extent(Angle width) {
  return integrals::tan(width.radians() / 2);
}

// The plane of a stop: its axis, and the unit vectors in the plane of incidence and across it.
struct StopFrame {
  Vec3<double> axis, in_plane, across;

  StopFrame(double theta, double phi)
      : axis{integrals::sin(theta) * integrals::cos(phi), integrals::sin(theta) * integrals::sin(phi),
             integrals::cos(theta)},
        in_plane{integrals::cos(theta) * integrals::cos(phi), integrals::cos(theta) * integrals::sin(phi),
                 -integrals::sin(theta)},
        across{-integrals::sin(phi), integrals::cos(phi), 0} {}

  // Returns the direction of the point (x, y), and its solid angle per area in `density`.
  Vec3<double> at(double x, double y, double& density) const {
    const double scale = 1 / std::sqrt(1 + x * x + y * y);
    density = scale * scale * scale;
    return (axis + in_plane * x + across * y) * scale;
  }
};

// Nodes on [-extent, extent] that gather at `centre` on the length `scale`.
std::vector<quadrature::UnitNode> gathered(int n, double extent, double centre, double scale) {
  const GaussRule& rule = gauss_legendre(n);
  const double low = integrals::asinh((-extent - centre) / scale),
               high = integrals::asinh((extent - centre) / scale);
  std::vector<quadrature::UnitNode> nodes;
  for (std::size_t k = 0; k < rule.node.size(); ++k) {
    const double t = low + (high - low) * rule.node[k];
    nodes.push_back(
        {centre + scale * integrals::sinh(t), rule.weight[k] * (high - low) * scale * integrals::cosh(t)});
  }
  return nodes;
}

// Nodes on [-extent, extent]. If the source is not smaller than the receptor, an edge of the received image
// lies on an edge of the source: the nodes then gather at both ends on the length `scale`.
std::vector<quadrature::UnitNode> source_nodes(int n, double extent, bool edges, double scale) {
  if (!edges) return gathered(n, extent, 0, 1);
  std::vector<quadrature::UnitNode> nodes;
  for (const auto& [v, weight] : gathered(n, extent / 2, -extent / 2, scale)) {
    nodes.push_back({v - extent / 2, weight});
    nodes.push_back({extent / 2 - v, weight});
  }
  return nodes;
}

// Calls visit(direction, weight) for the directions of the source. The weights add up to 1.
template <class Visit>
void over_source(const GlossGeometry& geometry, double phi, int n, double width, Visit&& visit) {
  const StopFrame frame(geometry.incidence.radians(), phi);
  const auto along = [&](Angle source, Angle receptor) {
    return source_nodes(n, half_extent(source), source >= receptor, width);
  };
  const auto x = along(geometry.source.in_plane, geometry.receptor.in_plane),
             y = along(geometry.source.across, geometry.receptor.across);
  std::vector<std::pair<Vec3<double>, double>> nodes;
  double total = 0;
  for (const auto& [in_plane, x_weight] : x)
    for (const auto& [across, y_weight] : y) {
      double density;
      const Vec3<double> w = frame.at(in_plane, across, density);
      nodes.push_back({w, x_weight * y_weight * density});
      total += nodes.back().second;
    }
  for (const auto& [w, weight] : nodes) visit(w, weight / total);
}

// Returns the received share of the power, for every column.
Sums received(const Integrand& integrand, const GlossGeometry& geometry, double phi, int n) {
  const StopFrame stop(geometry.incidence.radians() + geometry.offset.radians(), phi + kPi);
  // A half vector that tilts by a slope turns the outgoing direction by twice as much in the plane of
  // incidence, and across it by less towards grazing.
  const double width = 2 * std::min(integrand.features().width_x, integrand.features().width_y);
  Sums sums{std::vector<double>(integrand.columns(), 0.0), 0};
  over_source(geometry, phi, n / 2, width, [&](const Vec3<double>& wi, double share) {
    const Vec3<double> mirrored{-wi.x, -wi.y, wi.z};
    const double depth = dot(mirrored, stop.axis);
    const auto x = gathered(n, half_extent(geometry.receptor.in_plane), dot(mirrored, stop.in_plane) / depth,
                            width),
               y = gathered(n, half_extent(geometry.receptor.across), dot(mirrored, stop.across) / depth,
                            width * wi.z);
    NodeSum sum(integrand, wi);
    for (const auto& [along, x_weight] : x)
      for (const auto& [across, y_weight] : y) {
        double density;
        const Vec3<double> wo = stop.at(along, across, density);
        if (wo.z > 0) sum.add(wo.x, wo.y, wo.z, x_weight * y_weight * density);
      }
    for (std::size_t c = 0; c < sums.columns.size(); ++c) sums.columns[c] += share * sum.sums()[c];
    sums.evaluations += sum.evaluations();
  });
  return sums;
}

// Returns the received shares of the channels of one term that have the same shape.
std::vector<GlossReading> read_gloss(const Integrand& integrand, const GlossGeometry& geometry, double phi,
                                     const GlossOptions& options) {
  std::vector<GlossReading> readings(integrand.outputs());
  std::vector<History> history(integrand.outputs());
  const Features& features = integrand.features();
  const bool found = std::min(features.width_x, features.width_y) > kLeastWidth;
  long evaluations = 0;
  for (const int n : kGlossOrders) {
    const Sums sums = received(integrand, geometry, phi, n);
    evaluations += sums.evaluations;
    const std::vector<double> values = integrand.weigh(sums.columns);
    const double rounding = rounding_of(integrand, {kPi / 2 - geometry.incidence.radians(), phi}, 1);
    bool all = true;
    for (std::size_t k = 0; k < readings.size(); ++k) {
      history[k].add(values[k]);
      const double floor = rounding * std::abs(values[k]);
      const double error = truncation_error(history[k], Fall::slow, floor) + floor;
      const bool met =
          values[k] == 0 || error <= std::max(options.tolerance * std::abs(values[k]), options.floor);
      readings[k] = {values[k], error, evaluations, found && n > kGlossOrders[1] && met};
      all = all && readings[k].converged;
    }
    if (all || evaluations + 5 * sums.evaluations > options.max_evaluations) break;
  }
  return readings;
}

constexpr int kGlassOrder = 32;

double glass_share(const GlossGeometry& geometry, double index, int n = kGlassOrder) {
  double sum = 0;
  over_source(geometry, 0, n, 1,
              [&](const Vec3<double>& w, double share) { sum += share * fresnel_dielectric(index, w.z); });
  return sum;
}

}  // namespace
}  // namespace integrals

GlossReading gloss_of_glass(const GlossGeometry& geometry, double index) {
  constexpr double kRounding = 1e-13;  // relative, of sums of 1024 positive terms
  const auto reading = [&](int n) {
    return 100 * integrals::glass_share(geometry, index, n) /
           integrals::glass_share(geometry, kGlossGlass, n);
  };
  const double value = reading(integrals::kGlassOrder), coarse = reading(integrals::kGlassOrder / 2);
  return {value, 2 * std::abs(value - coarse) + kRounding * value, 0, true};
}

std::vector<GlossReading> gloss(const Material& material, const GlossGeometry& geometry, Angle phi,
                                const GlossOptions& options) {
  const double unit = 100 / integrals::glass_share(geometry, kGlossGlass);
  GlossOptions of_share = options;
  of_share.floor /= unit;
  std::vector<GlossReading> readings(material.channels.size(), {0, 0, 0, true});
  for (const Term& term : material.terms)
    for (const auto& group : integrals::groups_of_one_shape(term)) {
      const integrals::Integrand integrand(term, group, Fixed::light);
      const auto found =
          integrals::read_gloss(integrand, geometry, (phi - term.tangent_phi).radians(), of_share);
      for (std::size_t k = 0; k < group.size(); ++k) {
        GlossReading& reading = readings[group[k]];
        reading.value += unit * found[k].value;
        reading.error_bound += unit * found[k].error_bound;
        reading.evaluations += found[k].evaluations;
        reading.converged = reading.converged && found[k].converged;
      }
    }
  return readings;
}

}  // namespace brdf
