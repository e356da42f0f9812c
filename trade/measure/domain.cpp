#include "trade/measure/domain.h"

#include <cmath>

#include "brdf/directions.h"
#include "brdf/low_discrepancy.h"
#include "io/files/numbers.h"

namespace brdf::trade {
namespace {

double along(const Axis& axis, double u) {
  if (axis.log) return axis.min * std::pow(axis.max / axis.min, u);
  return axis.min + (axis.max - axis.min) * u;
}

void add_point(const Domain& domain, std::vector<double> at, Points& points) {
  const std::vector<double> row = domain.row(at);
  if (row.empty()) return;
  append(points.columns, row);
  points.at.push_back(std::move(at));
}

std::string named(const Axis& axis, double x) {
  return axis.name + " " + io::short_number(x);
}

}  // namespace

std::string describe(const Domain& domain) {
  std::vector<std::string> varied, fixed;
  for (const Axis& axis : domain.axes)
    if (axis.min == axis.max)
      fixed.push_back(named(axis, axis.min));
    else
      varied.push_back(named(axis, axis.min) + ".." + io::short_number(axis.max) +
                       (axis.log ? " (log)" : ""));
  std::vector<std::string> parts;
  for (const std::string& part : {io::joined(varied), io::joined(fixed), domain.note})
    if (!part.empty()) parts.push_back(part);
  return io::joined(parts, "; ");
}

std::string describe(const Domain& domain, const std::vector<double>& at) {
  std::vector<std::string> values;
  for (std::size_t k = 0; k < at.size(); ++k) values.push_back(named(domain.axes[k], at[k]));
  return io::joined(values);
}

Points sample(const Domain& domain, std::size_t count) {
  const std::size_t d = domain.axes.size();
  const std::vector<double> steps = additive_recurrence_steps(d);
  Points points;
  std::vector<double> at(d);
  for (std::size_t n = 0; n < count; ++n) {
    for (std::size_t k = 0; k < d; ++k)
      at[k] = along(domain.axes[k], additive_recurrence(0.5, steps[k], n + 1));
    add_point(domain, at, points);
  }
  for (std::size_t corner = 0; corner < (std::size_t(1) << d); ++corner) {
    for (std::size_t k = 0; k < d; ++k) at[k] = (corner >> k) & 1 ? domain.axes[k].max : domain.axes[k].min;
    add_point(domain, at, points);
  }
  return points;
}

double as_float(double x) {
  // volatile: g++ 12 at -O2 removes a pair of conversions to float and back, and with it the rounding.
  volatile float rounded = float(x);
  return double(rounded);
}

Domain stored_in_float(Domain domain) {
  domain.row = [exact = domain.row](std::span<const double> at) {
    std::vector<double> row = exact(at);
    for (double& x : row) x = as_float(x);
    return row;
  };
  return domain;
}

Domain direction_domain(double least_theta, double most_theta, std::vector<Axis> parameters) {
  std::vector<Axis> axes{
      {"theta_i", least_theta, most_theta}, {"theta_o", least_theta, most_theta}, {"phi", 0, 180}};
  axes.insert(axes.end(), parameters.begin(), parameters.end());
  return make_domain(std::move(axes), [](std::span<const double> at) {
    const DirectionRow<double> row{direction(degrees(at[0]), {}), direction(degrees(at[1]), degrees(at[2])),
                                   at.size() > 3 ? at[3] : 0, at.size() > 4 ? at[4] : 0};
    return row.wi.z > 0 && row.wo.z > 0 ? std::optional(row) : std::nullopt;
  });
}

Domain lobe_domain(Axis width, double widths, double most_theta_d) {
  return make_domain(
      {{"slope of h/alpha", 0, widths}, {"theta_d", 0, most_theta_d}, {"phi_d", 0, 180}, std::move(width)},
      [](std::span<const double> at) {
        const Vec3<double> h = direction(radians(std::atan(at[0] * at[3])), {});
        const Vec3<double> d = direction(degrees(at[1]), degrees(at[2]));
        // d turned such that +z becomes h (about the y axis).
        const Vec3<double> wi{d.x * h.z + d.z * h.x, d.y, d.z * h.z - d.x * h.x};
        const Vec3<double> wo = h * (2 * dot(wi, h)) - wi;
        const bool above = wi.z > 0.01 && wo.z > 0.01;
        return above ? std::optional(DirectionRow<double>{wi, wo, at[3]}) : std::nullopt;
      },
      "both cosines above 0.01");
}

}  // namespace brdf::trade
