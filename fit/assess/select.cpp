#include "fit/assess/select.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/paired.h"

namespace brdf::fit {
namespace {

constexpr double kPerfect = 1e-9;  // median errors below this are rounding
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The value by which forms are ranked: by the rows left out, if all forms have that value, otherwise,
// after an interruption, by the fitted rows. A form without a solution ranks last, because nothing is
// known about it.
class Value {
 public:
  explicit Value(const FitResult& result)
      : rounding_(result.left_out_rounding),
        left_out_(std::ranges::all_of(result.ranking,
                                      [](const FormFit& f) { return !f.solved() || f.left_out; })) {}
  double operator()(const FormFit& f) const {
    if (!f.solved()) return kInfinity;
    const double value =
        left_out_ ? std::max(f.left_out->value, rounding_) : std::max(f.median_relative_error, kPerfect);
    return std::isfinite(value) ? value : kInfinity;
  }

 private:
  double rounding_;
  bool left_out_;
};

// Rounds to three significant digits; smaller differences are irrelevant for a surface.
double rounded(double value) {
  if (!(value > 0) || std::isinf(value)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return std::round(value / unit) * unit;
}

bool as_good(const FitResult& result, const Value& value, const FormFit& f, const FormFit& best) {
  if (std::isinf(value(f))) return false;
  if (rounded(value(f)) <= rounded(value(best))) return true;
  // A few incidences that differ much decide nothing, so it is not enough that the test finds no
  // difference.
  if (!f.left_out || !best.left_out || value(f) > kAsGood * value(best)) return false;
  return !paired_test(result.groups.groups, f.left_out->by_group, best.left_out->by_group).worse();
}

}  // namespace

namespace {

// A form with worse predictions than a misfit by the share of light becomes a misfit too.
void follow_misfits(std::vector<FormFit>& ranking) {
  const FormFit* off = nullptr;
  for (FormFit& f : ranking) {
    if (f.light_is_off && !off) off = &f;
    if (!off || !usable(f.verdict)) continue;
    f.verdict = Verdict::misfit;
    f.findings.insert(f.findings.begin(), "predicts worse than " + off->form + ", which is a misfit");
  }
}

}  // namespace

std::vector<std::size_t> rank(FitResult& result) {
  const Value value(result);
  const std::vector<FormFit>& fits = result.ranking;
  std::vector<std::size_t> order(fits.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) {
    const FormFit &a = fits[i], &b = fits[j];
    if (a.solved() != b.solved()) return a.solved();
    const double x = rounded(value(a)), y = rounded(value(b));
    if (x != y) return x < y;
    if (usable(a.verdict) != usable(b.verdict)) return usable(a.verdict);
    return a.parameters < b.parameters;
  });
  std::vector<FormFit> ranked;
  for (const std::size_t k : order) ranked.push_back(std::move(result.ranking[k]));
  result.ranking = std::move(ranked);
  follow_misfits(result.ranking);
  result.recommended = 0;
  for (std::size_t k = 1; k < result.ranking.size(); ++k) {
    const FormFit &f = result.ranking[k], &chosen = result.ranking[result.recommended];
    const bool simpler = f.parameters < chosen.parameters || !usable(chosen.verdict);
    if (usable(f.verdict) && simpler && as_good(result, value, f, result.ranking.front()))
      result.recommended = k;
  }
  // A material that conserves energy, if there is one, is preferred to one that does not, even if its
  // predictions are worse.
  if (result.ranking[result.recommended].verdict == Verdict::breaks_energy)
    for (std::size_t k = result.ranking.size(); k-- > 0;)
      if (usable(result.ranking[k].verdict)) result.recommended = k;
  return order;
}

}  // namespace brdf::fit
