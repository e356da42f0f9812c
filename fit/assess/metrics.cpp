#include <algorithm>
#include <cmath>
#include <map>

#include "fit/assess/assess.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

constexpr double kFloor = kLogRelativeFloor;

struct Mean {
  double sum = 0;
  std::size_t count = 0;
  void add(double x) {
    sum += x;
    ++count;
  }
  double value() const { return count ? sum / double(count) : 0; }
};

}  // namespace

Metrics measure(const FitData& data, const std::vector<std::vector<double>>& model) {
  Mean log, l2, cube, relative;
  for (std::size_t c = 0; c < model.size(); ++c)
    for (std::size_t k = 0; k < data.rows(); ++k) {
      const double f = model[c][k], g = data.values[c][k], ci = data.wi_z[k], co = data.wo_z[k];
      const double d = (f - g) * ci;
      l2.add(d * d);
      cube.add(std::cbrt(d * d));
      if (g * ci > -1) {
        const double r = std::log1p(d / (1 + g * ci));
        log.add(r * r);
      }
      if (g * ci * co > -kFloor) {
        const double r = std::log((f * ci * co + kFloor) / (g * ci * co + kFloor));
        relative.add(r * r);
      }
    }
  return {std::sqrt(log.value()), std::sqrt(l2.value()), std::sqrt(relative.value()), cube.value()};
}

namespace {

// Returns the logarithm of measured over modelled in the direction nearest to the light, within 10 degrees
// of it: the median over the incidences at 15 degrees or more from the normal (so that the mirror direction
// is elsewhere). Returns std::nullopt for fewer than three such incidences.
std::optional<double> retro_excess(const FitData& data, const std::vector<std::vector<double>>& model) {
  const double upright = std::cos((15_deg).radians()), within = std::cos((10_deg).radians());
  struct Nearest {
    double cosine;
    std::size_t row;
  };
  std::map<std::uint32_t, Nearest> nearest;
  for (std::size_t k = 0; k < data.rows(); ++k) {
    if (data.wi_z[k] > upright) continue;
    const double cosine =
        data.wi_x[k] * data.wo_x[k] + data.wi_y[k] * data.wo_y[k] + data.wi_z[k] * data.wo_z[k];
    if (!(cosine > within)) continue;
    Nearest& best = nearest.try_emplace(data.incidence[k], Nearest{cosine, k}).first->second;
    if (cosine > best.cosine) best = {cosine, k};
  }
  std::vector<double> excess;
  for (const auto& [incidence, best] : nearest)
    for (std::size_t c = 0; c < model.size(); ++c)
      if (data.values[c][best.row] > 0)
        excess.push_back(std::log(data.values[c][best.row] / std::max(model[c][best.row], 1e-300)));
  if (excess.size() < 3 * model.size()) return std::nullopt;
  return io::median(std::move(excess));
}

// Returns whether no value deviates by `factor` and fewer than half deviate by `far`, with a margin for
// rounding. This test saves divisions if the model fits.
bool all_near(const FitData& data, const std::vector<std::vector<double>>& model, double factor, double far) {
  constexpr double margin = 1 - 1e-9;
  std::size_t off = 0, far_off = 0, count = 0;
  for (std::size_t c = 0; c < model.size(); ++c) {
    const double *const f = model[c].data(), *const g = data.values[c].data();
    for (std::size_t k = 0; k < data.rows(); ++k) {
      const bool counts = g[k] > 0;
      count += counts;
      off += counts & ((f[k] > margin * factor * g[k]) | (g[k] > margin * factor * f[k]));
      far_off += counts & ((f[k] > margin * far * g[k]) | (g[k] > margin * far * f[k]));
    }
  }
  return off == 0 && 2 * far_off < count;
}

// Returns the ratio of measured to fitted values if it is nearly the same for all of them: their scale is
// beyond the range of the weights, and their shape is not in question.
std::optional<double> common_ratio(const FitData& data, const std::vector<std::vector<double>>& model) {
  constexpr double kSame = 0.182, kShare = 0.9;  // ln 1.2
  std::vector<double> ratios;
  for (std::size_t c = 0; c < model.size(); ++c)
    for (std::size_t k = 0; k < data.rows(); ++k)
      if (data.values[c][k] > 0 && model[c][k] > 0)
        ratios.push_back(std::log(data.values[c][k] / model[c][k]));
  if (ratios.empty()) return std::nullopt;
  const double middle = io::median(ratios);
  const auto near = std::ranges::count_if(ratios, [&](double x) { return std::abs(x - middle) < kSame; });
  return double(near) >= kShare * double(ratios.size()) ? std::optional(std::exp(middle)) : std::nullopt;
}

}  // namespace

Misfit judge_misfit(const FitData& data, const std::vector<std::vector<double>>& model,
                    std::optional<double> noise) {
  // A value is off if it deviates by more than a factor of two (and five times the noise). Values are
  // weighted by the reflected light: the whole lobe of a retro-reflector is off, the tails of a good fit
  // are not.
  constexpr double kShare = 0.25, kMiddle = 0.182, kRetro = 0.405;  // ln 1.2, ln 1.5
  const double five_times = 5 * noise.value_or(0), factor = std::exp(std::max(std::log(2.0), five_times)),
               most = std::max(kMiddle, five_times), far = std::exp(most);
  const std::string cannot =
      (noise ? " (the measurement noise is " + io::percent_to_tenths(*noise) + ")" : "") +
      ": the surface has a property that this form cannot reproduce";
  const std::optional<double> excess = retro_excess(data, model);
  const auto retro_reflects = [&]() -> Misfit {
    if (!excess || !(*excess > std::max(kRetro, five_times))) return {};
    return {true, "retroreflection: near the direction of incidence measured values are " +
                      io::to_text(std::round(10 * std::exp(*excess)) / 10) + " times the fitted ones" +
                      cannot + "; `--form auto` tries a lobe about the light"};
  };
  if (all_near(data, model, factor, far)) return retro_reflects();
  if (const auto ratio = common_ratio(data, model); ratio && std::abs(std::log(*ratio)) > std::log(factor))
    return {true,
            "the measured values are about " + io::short_number(*ratio, 3) +
                " times the fitted ones in all directions: their scale is beyond the range of the weights; "
                "--free-scale fits the shape alone",
            true};
  double off = 0, all = 0;
  std::size_t far_off = 0, count = 0;
  // Calls visit(larger, ratio) for each pair of modelled and measured light.
  const auto for_each_value = [&](auto&& visit) {
    for (std::size_t c = 0; c < model.size(); ++c)
      for (std::size_t k = 0; k < data.rows(); ++k) {
        const double f = std::max(model[c][k], 1e-300) * data.wi_z[k], g = data.values[c][k] * data.wi_z[k];
        if (g > 0) visit(std::max(f, g), std::max(f, g) / std::min(f, g));
      }
  };
  for_each_value([&](double light, double ratio) {
    all += light;
    off += ratio > factor ? light : 0;
    far_off += ratio > far;
    ++count;
  });
  if (count == 0) return {};
  const double share = off / all;
  if (Misfit retro_reflection = retro_reflects(); retro_reflection.misfit) return retro_reflection;
  if (share > kShare)
    return {
        true,
        io::percent_to_tenths(share) + " of the reflected light is off by more than a factor of two" + cannot,
        true};
  if (2 * far_off < count) return {};
  std::vector<double> ratios;
  for_each_value([&](double, double ratio) { ratios.push_back(ratio); });
  return {true, "measured and fitted values typically differ by a factor of " +
                    io::short_number(io::median(std::move(ratios)), 3) + cannot};
}

}  // namespace brdf::fit
