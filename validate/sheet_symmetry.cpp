#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "validate/sheet_checks.h"

namespace brdf::validate {
namespace {

constexpr double kRadians = kPi / 180;

}  // namespace

Finding exact_reciprocity(const io::SampleTable& t) {
  const auto pairs = exact_pairs(t);
  if (pairs.empty()) return not_applicable(t, "reciprocity", "no reciprocal pairs in this table");
  std::vector<double> differences;
  for (const ReciprocalPair& p : pairs) differences.push_back(relative_difference(p));
  Finding f = start(t, "reciprocity");
  f.value = median(differences);
  f.bound = 0.2;
  f.verdict = f.value > f.bound ? Verdict::fail : Verdict::pass;
  f.statement = plural(pairs.size(), "reciprocal pair") + ", median difference " + percent(f.value);
  return f;
}

Finding noise_floor(const io::SampleTable& t, const std::vector<ReciprocalPair>& pairs) {
  if (pairs.size() < 8)
    return not_applicable(t, "noise_floor", "too few pairs of directions to interpolate between");
  std::vector<double> differences;
  for (const ReciprocalPair& p : pairs) differences.push_back(relative_difference(p));
  Finding f = start(t, "noise_floor");
  f.value = median(differences);
  f.bound = 0.2;
  f.verdict = f.value > f.bound ? Verdict::fail : Verdict::pass;
  f.statement = "median difference " + percent(f.value) + " of " +
                plural(pairs.size(), "interpolated reciprocal pair") + ", below " +
                percent(quantile(differences, 0.9)) + " for nine of ten: no model can be judged more finely";
  return f;
}

// If the values were f_r times cos_i, then f(a,b)/f(b,a) = cos_a/cos_b.
Finding cosine_factor(const io::SampleTable& t, const std::vector<ReciprocalPair>& pairs) {
  std::vector<double> slopes;
  for (const ReciprocalPair& p : pairs) {
    const double lever = std::log(std::cos(p.theta_a * kRadians) / std::cos(p.theta_b * kRadians));
    if (std::abs(lever) > 0.3 && std::isfinite(lever))
      slopes.push_back(std::log(p.forward / p.backward) / lever);
  }
  if (slopes.size() < 8)
    return not_applicable(t, "cosine_factor", "too few reciprocal pairs of different angles");
  Finding f = start(t, "cosine_factor");
  f.value = median(slopes);
  f.bound = 0.5;
  f.verdict = std::abs(f.value) > f.bound ? Verdict::fail : Verdict::pass;
  f.statement = f.verdict == Verdict::pass
                    ? "values are f_r: exchanging light and viewer leaves no cosine behind"
                    : std::string("values behave as f_r times ") + (f.value > 0 ? "cos_i" : "cos_o") +
                          ": exchanging light and viewer leaves that cosine behind (declare `quantity`)";
  return f;
}

Finding isotropy(const io::SampleTable& t) {
  const std::set<double> turns(t.phi_i.begin(), t.phi_i.end());
  if (turns.size() < 2)
    return not_applicable(t, "isotropy", "the sample was not turned: all light has one azimuth");
  std::map<std::tuple<long, long, long>, std::vector<std::size_t>> same;
  const auto key = [](double degrees) { return std::lround(degrees * 1e3); };
  for (std::size_t k = 0; k < t.rows(); ++k)
    same[{key(t.theta_i[k]), key(t.theta_o[k]), key(std::remainder(t.phi_o[k] - t.phi_i[k], 360.0))}]
        .push_back(k);
  std::vector<double> differences;
  for (const auto& [place, rows] : same)
    for (std::size_t j = 1; j < rows.size(); ++j)
      for (const auto& v : t.values)
        if (v[rows[j]] > 0 && v[rows[0]] > 0)
          differences.push_back(2 * std::abs(v[rows[j]] - v[rows[0]]) / (v[rows[j]] + v[rows[0]]));
  if (differences.size() < 4)
    return not_applicable(t, "isotropy", "no direction was measured at two turns of the sample");
  Finding f = start(t, "isotropy");
  f.value = median(differences);
  // A lobe that turns with the sample is met by few of the directions: noise alone reaches 3.5 medians there.
  const double far = quantile(differences, 0.98);
  f.bound = 0.05 + 5.5 * f.value;
  f.statement = far > f.bound ? "anisotropic: a turn of the sample changes values by " + percent(f.value) +
                                    " in the median and by " + percent(far) + " in one of fifty directions"
                              : "isotropic within " + percent(f.value) + " in the median";
  return f;
}

}  // namespace brdf::validate
