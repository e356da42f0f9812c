// Checks the symmetries of the values: exchange of light and viewer, and rotation of the sample.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "io/files/numbers.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

constexpr double kUnknownScatter = 0.1;

std::string factor(double logarithm) {
  return io::short_number(std::exp(logarithm), 3);
}

// Returns "the mirrored rows scatter by 3.8 % (212 pairs)".
std::string in_words(const Agreement& a) {
  return "noise of the " + std::string(a.rows) + " rows: " + io::percent_to_tenths(a.value) + " (" +
         plural(a.count, "pair") + ")";
}

}  // namespace

double Turns::noise_of_median() const {
  return 0.954 * scatter.value_or(kUnknownScatter);  // the median absolute difference of two normal variables
}

double Turns::noise_of_far() const {
  return 3.29 * scatter.value_or(kUnknownScatter);
}

bool Turns::is_anisotropic() const {
  constexpr double kBeyondNoise = 2, kSmooth = 0.05;  // the contribution of an instrument's repeatability
  return differences >= kFewest && (median > kBeyondNoise * noise_of_median() + kSmooth ||
                                    far > kBeyondNoise * noise_of_far() + kSmooth);
}

Isotropy Turns::isotropy() const {
  if (is_anisotropic()) return Isotropy::refuted;
  return differences >= kEnough && scatter ? Isotropy::seen : Isotropy::unknown;
}

Turns turns_of(const View& view, std::optional<double> scatter) {
  const io::SampleTable& t = view.table();
  Turns out;
  if (view.scans().empty()) return out;
  std::set<double> turns;
  for (const Scan& scan : view.scans()) turns.insert(scan.phi_i);
  out.turns = turns.size();
  std::map<std::tuple<long, long, long>, std::vector<Row>> same;
  const auto key = [](double angle) { return std::lround(angle * 1e3); };
  for (const Scan& scan : view.scans())
    for (const Row k : scan.rows)
      if (scan.theta_i > 0)
        same[{key(t.theta_i[k]), key(t.theta_o[k]), key(view.turn(k))}].push_back(k);
      else if (t.theta_o[k] > 0)  // light along the normal: each azimuth of the viewer is a rotation
        same[{0, key(t.theta_o[k]), 0}].push_back(k);
  std::vector<double> differences;
  for (const auto& [place, rows] : same)
    for (std::size_t j = 1; j < rows.size(); ++j) {
      const bool is_turned = t.phi_i[rows[j]] != t.phi_i[rows[0]] || view.turn(rows[j]) != view.turn(rows[0]);
      for (const auto& v : t.values)
        if (is_turned && v[rows[j]] > 0 && v[rows[0]] > 0)
          differences.push_back(std::abs(std::log(v[rows[j]] / v[rows[0]])));
    }
  out.differences = differences.size();
  if (out.differences < Turns::kFewest) return out;
  out.median = io::median(differences);
  out.far = io::quantile(std::move(differences), 0.98);
  out.scatter = scatter;
  return out;
}

Finding isotropy(const Evidence& e) {
  const io::SampleTable& t = e.view.table();
  const Turns& turns = e.turns;
  if (turns.differences < Turns::kFewest && turns.turns < 2)
    return not_applicable(t.source, "isotropy",
                          "the sample was not rotated: all incident directions have the same azimuth");
  if (turns.differences < Turns::kFewest)
    return not_applicable(t.source, "isotropy",
                          "no pair of directions was measured at two rotations of the sample");
  Finding f = start(t, "isotropy");
  f.value = turns.median;
  f.bound = 2 * turns.noise_of_median();
  const std::string seen = "rotating the sample changes values by a factor of " + factor(turns.median) +
                           " in the median and of " + factor(turns.far) + " in one of fifty comparisons (" +
                           std::to_string(turns.differences) + " in all)";
  if (turns.is_anisotropic()) {
    f.outcome = Outcome::undecided;
    f.statement = "the sample is anisotropic: " + seen + "; fit with --anisotropic";
  } else if (turns.differences < Turns::kEnough || !turns.scatter) {
    f.outcome = Outcome::undecided;
    f.statement =
        seen + (turns.scatter ? ": too few comparisons to distinguish isotropy from a small anisotropy"
                              : ": this may be noise, because the measurement noise is not known");
  } else {
    f.statement = "isotropic within the noise of " + io::percent_to_tenths(*turns.scatter) + ": " + seen;
  }
  return f;
}

Finding reciprocity(const Evidence& e) {
  constexpr double kBound = 0.2;
  const io::SampleTable& t = e.view.table();
  if (e.pairs.empty()) return not_applicable(t.source, "reciprocity", "no reciprocal pairs in this table");
  std::vector<double> differences;
  const auto exact = std::size_t(std::ranges::count_if(e.pairs, [](const Pair& p) { return p.exact(); }));
  for (const Pair& p : e.pairs)
    if (exact < kFewestPairs || p.exact()) differences.push_back(std::abs(p.log_ratio));
  Finding f = start(t, "reciprocity");
  const std::size_t count = differences.size();
  f.value = std::expm1(io::median(std::move(differences)));
  f.bound = kBound;
  f.statement = plural(count, exact < kFewestPairs ? "interpolated reciprocal pair" : "reciprocal pair") +
                ", median difference " + io::percent_to_tenths(f.value);
  if (count < kFewestPairs) {
    f.outcome = Outcome::undecided;
    f.statement += ": too few to judge";
  } else if (f.value > f.bound) {
    f.outcome = Outcome::fail;
  }
  return f;
}

Finding noise_floor(const Evidence& e) {
  const io::SampleTable& t = e.view.table();
  const Scatter& s = e.scatter;
  std::string beside;
  for (const Agreement& a : s.agreements) beside += "; " + in_words(a);
  if (!s.value())
    return not_applicable(
        t.source, "noise_floor",
        "rows are too few, too far apart or too smooth to separate noise from the shape of the lobe" +
            beside);
  Finding f = start(t, "noise_floor");
  const std::optional<double> least = s.least();
  f.value = *s.value();
  f.bound = 0.2;
  f.outcome = f.value > f.bound ? Outcome::fail : Outcome::pass;
  const Agreement* const decisive = s.decisive();
  f.statement =
      "measurement noise: " + io::percent_to_tenths(f.value) +
      "; smaller differences are not told from noise (" +
      (s.neighbours.value ? "scatter about a smooth surface: " + io::percent_to_tenths(*s.neighbours.value)
                          : std::string("scatter about a smooth surface: not known")) +
      beside + ")";
  constexpr double kTooSmooth = 4;
  const bool needs_isotropy = !least || *least < f.value;
  const bool too_smooth =
      decisive && s.neighbours.value && decisive->value > kTooSmooth * *s.neighbours.value;
  if (too_smooth && f.outcome == Outcome::pass) f.outcome = Outcome::undecided;
  if (too_smooth)
    f.statement +=
        "; neighbours agree better than this noise permits: the errors vary slowly, or the values were "
        "smoothed";
  if (needs_isotropy)
    f.statement += std::string(too_smooth ? ", or" : "; this is no noise if") +
                   " the sample is not isotropic, which no rotation tests";
  for (std::size_t c = 0; c < t.channels.size(); ++c)
    f.channels.emplace_back(t.channels[c], s.neighbours.channels[c].value_or(NAN));
  return f;
}

}  // namespace brdf::sheet
