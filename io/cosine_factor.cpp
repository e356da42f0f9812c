#include "io/cosine_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "io/numbers.h"

namespace brdf::io {
namespace {

// Rough diffuse forms fall with the cosines' power 0.6 at grazing light, f_r cos_i cos_o of a diffuse surface with 1.
constexpr double kFound = 0.5, kFoundAtGrazing = 0.75;
constexpr std::size_t kFewestPairs = 8, kFewestValues = 30, kJudgedRows = 50'000;

std::optional<double> exchanged_power(const std::vector<ReciprocalPair>& pairs) {
  std::vector<double> powers;
  for (const ReciprocalPair& p : pairs) {
    const double lever =
        std::log(std::cos(degrees(p.theta_a).radians()) / std::cos(degrees(p.theta_b).radians()));
    if (std::abs(lever) > 0.3 && std::isfinite(lever))
      powers.push_back(std::log(p.forward / p.backward) / lever);
  }
  if (powers.size() < kFewestPairs) return std::nullopt;
  return median(std::move(powers));
}

// Sums of a straight line through the logarithms of a value and of the cosines.
struct Line {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  void add(double at, double value) {
    n += 1;
    x += at;
    y += value;
    xx += at * at;
    xy += at * value;
  }
  double lever() const { return std::sqrt(std::max(xx / n - x * x / (n * n), 0.0)); }
  double slope() const { return (xy - x * y / n) / (xx - x * x / n); }
};

// Lines of values whose half vectors lie within two degrees of one another and are well off the normal, where no
// highlight stands; by channel and half vector. The median of their slopes, each counting with its values.
std::optional<double> grazing_power(const SampleTable& t) {
  constexpr double kCell = 2, kHighlight = 20, kSteepest = 85;  // degrees
  std::map<std::pair<std::size_t, int>, Line> lines;
  const std::size_t stride = (t.rows() + kJudgedRows - 1) / kJudgedRows;
  for (std::size_t k = 0; k < t.rows(); k += stride) {
    if (t.theta_i[k] > kSteepest || t.theta_o[k] > kSteepest) continue;
    const Vec3<double> wi = unit_vector(t.theta_i[k], t.phi_i[k]), wo = unit_vector(t.theta_o[k], t.phi_o[k]);
    const Vec3<double> sum = wi + wo;
    const double theta_h = radians(std::atan2(std::hypot(sum.x, sum.y), sum.z)).degrees();
    if (theta_h < kHighlight) continue;
    for (std::size_t c = 0; c < t.channels.size(); ++c)
      if (t.values[c][k] > 0)
        lines[{c, int(theta_h / kCell)}].add(std::log(wi.z * wo.z), std::log(t.values[c][k]));
  }
  std::vector<double> slopes;
  for (const auto& [place, line] : lines)
    if (line.n >= 5 && line.lever() > 0.2) slopes.insert(slopes.end(), std::size_t(line.n), line.slope());
  if (slopes.size() < kFewestValues) return std::nullopt;
  return median(std::move(slopes));
}

}  // namespace

CosineFactor cosine_factor(const SampleTable& table, const std::vector<ReciprocalPair>& pairs) {
  CosineFactor f;
  f.exchanged = exchanged_power(pairs);
  f.grazing = grazing_power(table);
  if (f.exchanged && std::abs(*f.exchanged) > kFound)
    f.found = *f.exchanged > 0 ? Cosine::cos_i : Cosine::cos_o;
  else if (f.exchanged && f.grazing && *f.grazing > kFoundAtGrazing)
    f.found = Cosine::both;
  constexpr std::array names{"", "cos_i", "cos_o", "cos_i cos_o"};
  if (f.found == Cosine::none)
    f.statement = "values are f_r: exchanging light and viewer leaves no cosine behind";
  else
    f.statement = std::string("values behave as f_r times ") + names[std::size_t(f.found)];
  if (f.found == Cosine::both)
    f.statement += ": towards grazing they fall as the cosines' power " + short_number(*f.grazing, 2) +
                   " (divide them by both)";
  else if (f.found != Cosine::none)
    f.statement += ": exchanging light and viewer leaves that cosine behind (declare `quantity`)";
  return f;
}

CosineFactor cosine_factor(const SampleTable& table) {
  return cosine_factor(table, interpolated_pairs(table));
}

}  // namespace brdf::io
