#include "trade/measure/domain.h"

#include <cmath>

#include "brdf/material.h"
#include "io/text.h"

namespace brdf::trade {
namespace {

constexpr std::string_view kUnused = "-";  // an axis that a domain's maker needs and its user does not
constexpr double kDegree = kPi / 180;

// The root of x^(d+1) = x + 1.
double golden_ratio(std::size_t dimensions) {
  double x = 2;
  for (int k = 0; k < 60; ++k) x = std::pow(1 + x, 1 / double(dimensions + 1));
  return x;
}

double along(const Axis& axis, double u) {
  if (axis.log) return axis.min * std::pow(axis.max / axis.min, u);
  return axis.min + (axis.max - axis.min) * u;
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

void add_point(const Domain& domain, std::vector<double> at, Points& points) {
  Row<double> row{};
  if (domain.inputs) {
    if (!domain.inputs(at, row)) return;
  } else {
    for (std::size_t k = 0; k < at.size(); ++k) row[k] = at[k];
  }
  for (std::size_t k = 0; k < kInputs; ++k) points.columns[k].push_back(row[k]);
  points.at.push_back(std::move(at));
}

}  // namespace

std::string describe(const Domain& domain) {
  std::string text;
  std::string fixed;
  for (const Axis& axis : domain.axes) {
    if (axis.name == kUnused) continue;
    if (axis.min == axis.max)
      fixed += (fixed.empty() ? "" : ", ") + axis.name + " " + number(axis.min);
    else
      text += (text.empty() ? "" : ", ") + axis.name + " " + number(axis.min) + ".." + number(axis.max) +
              (axis.log ? " (log)" : "");
  }
  for (const std::string& more : {fixed, domain.note})
    if (!more.empty()) text += (text.empty() ? "" : "; ") + more;
  return text;
}

std::string describe(const Domain& domain, const std::vector<double>& at) {
  std::string text;
  for (std::size_t k = 0; k < at.size(); ++k)
    if (domain.axes[k].name != kUnused)
      text += (text.empty() ? "" : ", ") + domain.axes[k].name + " " + number(at[k]);
  return text;
}

Points sample(const Domain& domain, std::size_t count) {
  const std::size_t d = domain.axes.size();
  const double g = golden_ratio(d);
  std::vector<double> step(d);
  for (std::size_t k = 0; k < d; ++k) step[k] = std::fmod(1 / std::pow(g, double(k + 1)), 1.0);
  Points points;
  for (std::size_t n = 0; n < count; ++n) {
    std::vector<double> at(d);
    for (std::size_t k = 0; k < d; ++k)
      at[k] = along(domain.axes[k], std::fmod(0.5 + step[k] * double(n + 1), 1.0));
    add_point(domain, std::move(at), points);
  }
  for (std::size_t corner = 0; corner < (std::size_t(1) << d); ++corner) {
    std::vector<double> at(d);
    for (std::size_t k = 0; k < d; ++k) at[k] = (corner >> k) & 1 ? domain.axes[k].max : domain.axes[k].min;
    add_point(domain, std::move(at), points);
  }
  return points;
}

double as_float(double x) {
  volatile float rounded =
      float(x);  // g++ 12 at -O2 drops the rounding of a pair that goes to float and back
  return double(rounded);
}

bool direction_row(double theta_i, double theta_o, double phi, double p, double q, Row<double>& row) {
  const Vec3<double> wi = direction(degrees(theta_i), {}), wo = direction(degrees(theta_o), degrees(phi));
  row = {wi.x, wi.y, wi.z, wo.x, wo.y, wo.z, p, q};
  return wi.z > 0 && wo.z > 0;
}

Domain lobe_domain(Axis alpha, Axis parameter, double widths, double most_theta_d) {
  return {
      {{"slope of h/alpha", 0, widths}, {"theta_d", 0, most_theta_d}, {"phi_d", 0, 180}, alpha, parameter},
      [](std::span<const double> at, Row<double>& row) {
        const double theta_h = std::atan(at[0] * at[3]), theta_d = at[1] * kDegree;
        const Vec3<double> h = direction(radians(theta_h), {});
        const Vec3<double> d = direction(radians(theta_d), degrees(at[2]));
        // d turned so that +z becomes h (about the y axis).
        const Vec3<double> wi{d.x * h.z + d.z * h.x, d.y, d.z * h.z - d.x * h.x};
        const double along_h = 2 * dot(wi, h);
        const Vec3<double> wo = h * along_h - wi;
        row = {wi.x, wi.y, wi.z, wo.x, wo.y, wo.z, at[3], at[4]};
        return wi.z > 0.01 && wo.z > 0.01;
      },
      "both cosines above 0.01"};
}

Domain direction_domain(Axis p, Axis q, double most_theta) {
  return {
      {{"theta_i", 0, most_theta}, {"theta_o", 0, most_theta}, {"phi", 0, 180}, std::move(p), std::move(q)},
      [](std::span<const double> at, Row<double>& row) {
        return direction_row(at[0], at[1], at[2], at[3], at[4], row);
      },
      ""};
}

Domain pairs_domain(double least_theta, double most_theta) {
  Domain d = direction_domain({"-", 0, 0}, {"-", 0, 0}, most_theta);
  d.axes.resize(3);
  d.axes[0].min = d.axes[1].min = least_theta;
  d.inputs = [](std::span<const double> at, Row<double>& row) {
    return direction_row(at[0], at[1], at[2], 0, 0, row);
  };
  return d;
}

}  // namespace brdf::trade
