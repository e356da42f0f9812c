#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "io/noise.h"
#include "io/numbers.h"
#include "validate/sheet_checks.h"

namespace brdf::validate {

namespace {

std::vector<double> differences_of(const std::vector<io::ReciprocalPair>& pairs) {
  std::vector<double> differences;
  for (const io::ReciprocalPair& p : pairs) differences.push_back(relative_difference(p));
  return differences;
}

}  // namespace

Finding exact_reciprocity(const io::SampleTable& t) {
  const auto pairs = io::exact_pairs(t);
  if (pairs.empty()) return not_applicable(t.source, "reciprocity", "no reciprocal pairs in this table");
  Finding f = start(t, "reciprocity");
  f.value = io::median(differences_of(pairs));
  f.bound = 0.2;
  f.outcome = f.value > f.bound ? Outcome::fail : Outcome::pass;
  f.statement =
      plural(pairs.size(), "reciprocal pair") + ", median difference " + io::percent_to_tenths(f.value);
  return f;
}

std::optional<double> exchanged_difference(const std::vector<io::ReciprocalPair>& pairs) {
  constexpr std::size_t kFewest = 8;
  if (pairs.size() < kFewest) return std::nullopt;
  return io::median(differences_of(pairs));
}

// The pairs say what an instrument adds that is no noise, but also what is lost by interpolating.
Finding noise_floor(const io::SampleTable& t, const std::vector<io::ReciprocalPair>& pairs) {
  std::string exchanged;
  if (const auto difference = exchanged_difference(pairs))
    exchanged = "; light and viewer exchanged by interpolation differ by " +
                io::percent_to_tenths(*difference) + " in the median of " + plural(pairs.size(), "pair");
  const io::Noise noise = io::relative_noise(t);
  if (!noise.value)
    return not_applicable(
        t.source, "noise_floor",
        "rows are too few, too far apart or too smooth to tell noise from the sample's shape" + exchanged);
  Finding f = start(t, "noise_floor");
  f.value = *noise.value;
  f.bound = 0.2;
  f.outcome = f.value > f.bound ? Outcome::fail : Outcome::pass;
  f.statement = "values scatter by " + io::percent_to_tenths(f.value) +
                " about what their neighbours say: no model can be judged more finely" + exchanged;
  for (std::size_t c = 0; c < t.channels.size(); ++c)
    f.channels.emplace_back(t.channels[c], noise.channels[c].value_or(NAN));
  return f;
}

Finding cosine_factor(const io::SampleTable& t, const io::CosineFactor& cosine) {
  const bool both = cosine.found == io::Cosine::both;
  if (!cosine.exchanged && !(cosine.grazing && *cosine.grazing > 0.75))
    return not_applicable(t.source, "cosine_factor", "too few reciprocal pairs of different angles");
  Finding f = start(t, "cosine_factor");
  f.value = both || !cosine.exchanged ? *cosine.grazing : *cosine.exchanged;
  f.bound = 0.5;
  f.outcome = cosine.found != io::Cosine::none ? Outcome::fail
              : cosine.exchanged               ? Outcome::pass
                                               : Outcome::undecided;
  f.statement = f.outcome == Outcome::undecided
                    ? "values fall towards grazing as the cosines' power " + io::short_number(f.value, 2) +
                          ", as f_r times a cosine does; no reciprocal pairs tell whether it is one"
                    : cosine.statement;
  return f;
}

Finding isotropy(const io::SampleTable& t) {
  const std::set<double> turns(t.phi_i.begin(), t.phi_i.end());
  if (turns.size() < 2)
    return not_applicable(t.source, "isotropy", "the sample was not turned: all light has one azimuth");
  std::map<std::tuple<long, long, long>, std::vector<std::size_t>> same;
  const auto key = [](double angle) { return std::lround(angle * 1e3); };
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
    return not_applicable(t.source, "isotropy", "no direction was measured at two turns of the sample");
  Finding f = start(t, "isotropy");
  f.value = io::median(differences);
  // A lobe that turns with the sample is met by few of the directions: noise alone reaches 3.5 medians there.
  const double far = io::quantile(differences, 0.98);
  f.bound = 0.05 + 5.5 * f.value;
  f.statement = far > f.bound ? "anisotropic: a turn of the sample changes values by " +
                                    io::percent_to_tenths(f.value) + " in the median and by " +
                                    io::percent_to_tenths(far) + " in one of fifty directions"
                              : "isotropic within " + io::percent_to_tenths(f.value) + " in the median";
  return f;
}

}  // namespace brdf::validate
