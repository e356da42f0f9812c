// The sensitivities of the rows to the sources of a budget.
#include <algorithm>
#include <cmath>

#include "fit/assess/budget.h"

namespace brdf::fit {
namespace {

using Values = std::vector<std::vector<double>>;  // [channel][row]

constexpr double kAngleStep = 1e-4;  // radians
// Share of a standard uncertainty from which the curvature of f is reported.
constexpr double kVisibleCurvature = 0.1;

enum class Turned { light, viewer };

// Directions that are turned along the meridian of each row, away from the normal.
struct TurnedRows {
  FitData data;
  std::vector<double> step;  // radians; smaller near the horizon
};

TurnedRows turned(const FitData& data, Turned which, double step) {
  TurnedRows out{data, std::vector<double>(data.rows())};
  const bool light = which == Turned::light;
  std::vector<double>&x = light ? out.data.wi_x : out.data.wo_x, &y = light ? out.data.wi_y : out.data.wo_y,
  &z = light ? out.data.wi_z : out.data.wo_z;
  const std::vector<double>& azimuth = light ? data.phi_i : data.phi_o;
  constexpr double kHorizon = kPi / 2 - 1e-9;
  for (std::size_t k = 0; k < data.rows(); ++k) {
    const double theta = std::atan2(std::hypot(x[k], y[k]), z[k]);
    const double there = std::min(theta + step, std::max(kHorizon, theta));
    out.step[k] = there - theta;
    x[k] = std::sin(there) * std::cos(azimuth[k]);
    y[k] = std::sin(there) * std::sin(azimuth[k]);
    z[k] = std::cos(there);
  }
  return out;
}

// The logarithmic derivative of the model's values by a polar angle, and their second derivative over f.
struct AngleSlopes {
  Values first, second;
};

AngleSlopes angle_slopes(const SampleStream& stream, std::span<const double> p, const Values& values,
                         Turned which) {
  const TurnedRows out = turned(stream.data(), which, kAngleStep),
                   in = turned(stream.data(), which, -kAngleStep);
  const auto at = [&](const FitData& data) {
    return SampleStream(data, stream.model(), stream.residual(), stream.aperture()).values(p);
  };
  const Values above = at(out.data), below = at(in.data);
  AngleSlopes slopes{values, values};
  for (std::size_t c = 0; c < values.size(); ++c)
    for (std::size_t k = 0; k < values[c].size(); ++k) {
      const double f = values[c][k], up = out.step[k], down = -in.step[k];
      const bool known = f > 0 && up + down > 0;
      slopes.first[c][k] = known ? (above[c][k] - below[c][k]) / ((up + down) * f) : 0;
      slopes.second[c][k] =
          known && up > 0 ? 2 * ((above[c][k] - f) / up - (f - below[c][k]) / down) / ((up + down) * f) : 0;
    }
  return slopes;
}

double radians_of(const io::BudgetSource& source) {
  return degrees(source.standard_uncertainty).radians();
}

// Counts the values for which the second order of the angles' errors is visible in the combined uncertainty.
std::size_t count_curved(const RowBudget& rows, const AngleSlopes& light, const AngleSlopes& viewer) {
  std::size_t count = 0;
  for (std::size_t c = 0; c < rows.values.size(); ++c)
    for (std::size_t k = 0; k < rows.values[c].size(); ++k) {
      double variance = 0;
      for (const io::BudgetSource& source : rows.budget->sources) {
        if (source.unit != io::BudgetUnit::degree) continue;
        const AngleSlopes& by = source.effect == io::BudgetEffect::theta_i ? light : viewer;
        // The variance of e^2 is twice the square of the variance of a normal e.
        variance += square(by.second[c][k] * square(radians_of(source))) / 2;
      }
      const double first = rows.combined(c, k);
      count += std::sqrt(variance + first * first) > (1 + kVisibleCurvature) * first;
    }
  return count;
}

}  // namespace

double RowBudget::error(const io::BudgetSource& source, std::size_t c, std::size_t k) const {
  const double f = values[c][k], u = source.standard_uncertainty;
  switch (source.effect) {
    case io::BudgetEffect::scale:
      return u;
    case io::BudgetEffect::theta_i:
      return theta_i[c][k] * radians_of(source);
    case io::BudgetEffect::theta_o:
      return theta_o[c][k] * radians_of(source);
    case io::BudgetEffect::linearity:
      return signal[c][k] > 0 ? u * std::log(signal[c][k] / largest[c]) : 0;
    case io::BudgetEffect::stray_light:
      return f > 0 ? u / f : 0;
  }
  return 0;
}

double RowBudget::combined(std::size_t channel, std::size_t k) const {
  double variance = 0;
  for (const io::BudgetSource& source : budget->sources) variance += square(error(source, channel, k));
  return std::sqrt(variance);
}

RowBudget row_budget(const SampleStream& stream, std::span<const double> p) {
  const FitData& data = stream.data();
  RowBudget out{data.budget, data.row, {}, {}, {}, stream.values(p), 0, {}, 0};
  for (const std::uint32_t light : data.incidence) out.lights = std::max<std::size_t>(out.lights, light + 1);
  const AngleSlopes light = angle_slopes(stream, p, out.values, Turned::light),
                    viewer = angle_slopes(stream, p, out.values, Turned::viewer);
  out.theta_i = light.first;
  out.theta_o = viewer.first;
  out.signal = out.values;
  for (std::size_t c = 0; c < out.values.size(); ++c) {
    for (std::size_t k = 0; k < data.rows(); ++k) {
      const double tan_i = std::hypot(data.wi_x[k], data.wi_y[k]) / data.wi_z[k],
                   tan_o = std::hypot(data.wo_x[k], data.wo_y[k]) / data.wo_z[k];
      if (data.budget->divides_by_cos_i) out.theta_i[c][k] -= tan_i;
      if (data.budget->divides_by_cos_o) out.theta_o[c][k] -= tan_o;
      out.signal[c][k] *= data.wo_z[k];
    }
    out.largest.push_back(std::ranges::max(out.signal[c]));
  }
  out.beyond_first_order = count_curved(out, light, viewer);
  return out;
}

}  // namespace brdf::fit
