// Judges the causes of the differences of reciprocal pairs: a cosine left in the values, the gain of one
// light, a drift through the file, a dark level.
#include <algorithm>
#include <cmath>
#include <map>

#include "brdf/angle.h"
#include "io/files/numbers.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

constexpr double kSeen = 3;  // the least size that is visible, in standard errors

// The statements of a check about its cause. `worth_seeing`: the size that matters.
struct Sentences {
  double worth_seeing;
  std::string fault;    // the cause explains the differences
  std::string clean;    // the cause would have been seen
  std::string unclear;  // the pairs indicate the cause but disagree
  std::string unseen;   // precedes the least size that would have been seen
};

const Explanation* tried(const Evidence& e, Cause cause) {
  const auto found =
      std::ranges::find_if(e.causes.tried, [&](const Explanation& x) { return x.cause == cause; });
  return found == e.causes.tried.end() ? nullptr : &*found;
}

Finding judge(const Evidence& e, const char* check, const Explanation& x, const Sentences& say) {
  Finding f = start(e.view.table(), check);
  f.value = x.size;
  f.bound = say.worth_seeing;
  const double least_seen = kSeen * x.standard_error;
  if (e.causes.found && e.causes.found->cause == x.cause) {
    f.outcome = e.causes.is_certain ? Outcome::fail : Outcome::undecided;
    f.is_suspicion = !e.causes.is_certain;
    f.statement = say.fault;
  } else if (e.causes.found) {
    f = not_applicable(f.subject, f.check,
                       "another fault explains the differences between reciprocal pairs better");
  } else if (std::abs(x.size) > std::max(least_seen, 0.4 * say.worth_seeing)) {
    f.outcome = Outcome::undecided;
    f.statement = say.unclear;
  } else if (least_seen > say.worth_seeing) {
    f.outcome = Outcome::undecided;
    f.statement = say.unseen + io::percent(std::expm1(least_seen), 2);
  } else {
    f.statement = say.clean;
  }
  return f;
}

Finding too_few_pairs(const Evidence& e, const char* check) {
  return not_applicable(e.view.table().source, check, "too few reciprocal pairs with different angles");
}

// Returns the quartiles for people: "-1 to -0.91 in the middle half of 698 pairs".
std::string quartiles(const Explanation& x) {
  return "quartiles " + io::short_number(x.low, 2) + " and " + io::short_number(x.high, 2) + ", " +
         plural(x.pairs, "pair");
}

std::string by_pairs(const Explanation& x) {
  return " (" + plural(x.pairs, "reciprocal pair") + ")";
}

std::string percent_of(double logarithm) {
  return io::percent(std::abs(std::expm1(logarithm)), 2);
}

// The sums for a straight line through the logarithms of the values over those of the cosines.
struct SlopeSums {
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

struct GrazingPower {
  double power, low, high;  // median and quartiles
};

// Estimates the power of the cosines with which values change towards grazing incidence at a constant angle
// of the half vector, outside of the highlight. Reciprocity gives no information on a factor cos_i cos_o.
// The power is at most 0 for lobes of microfacets and for diffuse surfaces. Values with half vectors within
// two degrees of one another form a line; each line counts with the number of its values. Returns
// std::nullopt for fewer than 30 values.
std::optional<GrazingPower> grazing_power(const View& view) {
  constexpr double kCell = 2, kHighlight = 20, kSteepest = 85;  // degrees
  constexpr std::size_t kFewestValues = 30, kJudgedRows = 50'000;
  const io::SampleTable& t = view.table();
  std::map<int, SlopeSums> lines;
  const std::size_t stride = (t.rows() + kJudgedRows - 1) / kJudgedRows;
  for (std::size_t k = 0; k < t.rows(); k += stride) {
    if (t.theta_i[k] > kSteepest || t.theta_o[k] > kSteepest || std::isnan(view.level(k))) continue;
    const Vec3<double> wi = direction(degrees(t.theta_i[k]), degrees(0)),
                       wo = direction(degrees(t.theta_o[k]), degrees(view.turn(k))), sum = wi + wo;
    const double theta_h = radians(std::atan2(std::hypot(sum.x, sum.y), sum.z)).degrees();
    if (theta_h >= kHighlight) lines[int(theta_h / kCell)].add(std::log(wi.z * wo.z), view.level(k));
  }
  std::vector<double> slopes;
  for (const auto& [place, line] : lines)
    if (line.n >= 5 && line.lever() > 0.2) slopes.insert(slopes.end(), std::size_t(line.n), line.slope());
  if (slopes.size() < kFewestValues) return std::nullopt;
  return GrazingPower{io::median(slopes), io::quantile(slopes, 0.25), io::quantile(slopes, 0.75)};
}

// Rough diffuse surfaces fall with the power 0.6 of the cosines; f_r cos_i cos_o of a diffuse surface falls
// with the power 1.
bool is_both_cosines(const GrazingPower& g) {
  return g.power > 0.75 && g.low > 0.5 && g.high < 1.6;
}

Finding cosine_of_pairs(const Evidence& e, const Explanation& x) {
  const std::string name = x.size > 0 ? "cos_i" : "cos_o";
  const std::string power =
      "the power " + io::short_number(x.size, 2) + " of the cosines' ratio (" + quartiles(x) + ")";
  return judge(e, "cosine_factor", x,
               {0.5,
                "values behave as f_r times " + name + ": exchanging the two directions leaves " + power +
                    "; `quantity: f_r*" + name + "` (or --quantity f_r*" + name + ") removes " +
                    io::percent(x.share, 2) + " of the differences",
                "exchanging the two directions leaves no cosine factor",
                "exchanging the two directions leaves " + power + ", which is not a whole cosine",
                "the noise of the pairs hides a cosine factor below "});
}

}  // namespace

Finding cosine_factor(const Evidence& e) {
  const io::SampleTable& t = e.view.table();
  const Explanation* const x = tried(e, Cause::cosine);
  const auto grazing = grazing_power(e.view);
  const bool is_one = e.causes.found && e.causes.found->cause == Cause::cosine;
  if (is_one || !grazing || !is_both_cosines(*grazing))
    return x ? cosine_of_pairs(e, *x) : too_few_pairs(e, "cosine_factor");
  Finding f = start(t, "cosine_factor");
  f.value = grazing->power;
  f.bound = 0.75;
  f.outcome = x ? Outcome::fail : Outcome::undecided;
  f.is_suspicion = !x;
  f.statement =
      x ? "values behave as f_r times cos_i cos_o: at grazing angles they fall as the power " +
              io::short_number(f.value, 2) +
              " of both cosines, and exchanging the two directions has no effect (divide the values by both "
              "cosines)"
        : "at grazing angles values fall as the power " + io::short_number(f.value, 2) +
              " of the cosines, like f_r times a cosine; without reciprocal pairs this cannot be decided";
  return f;
}

Finding light_gain(const Evidence& e) {
  const Explanation* const x = tried(e, Cause::gain);
  if (!x)
    return not_applicable(e.view.table().source, "light_gain",
                          "too few reciprocal pairs, or fewer than three incidences among them");
  const std::string angle = io::short_number(e.view.scans()[x->scan].theta_i, 4) + " degrees";
  const auto times = [](double log) { return io::short_number(std::exp(log), 3); };
  return judge(
      e, "light_gain", *x,
      {0.15,
       "values at incidence " + angle + " are " + times(x->size) + " times (" + times(x->low) + " and " +
           times(x->high) + ", quartiles) as large as the other incidences predict by reciprocity" +
           by_pairs(*x) + ": the gain differs; divide these values by that factor",
       "all incidences are on the same scale within " + percent_of(kSeen * x->standard_error) + by_pairs(*x),
       "incidence " + angle + " differs from the others by " + percent_of(x->size) +
           " in the median, but the pairs disagree (quartiles " + percent_of(x->low) + " and " +
           percent_of(x->high) + ")",
       "the noise of the pairs hides a difference of a single incidence below "});
}

Finding drift(const Evidence& e) {
  const Explanation* const x = tried(e, Cause::drift);
  if (!x) return too_few_pairs(e, "drift");
  const std::string change = std::string("values ") + (x->size > 0 ? "grow" : "fall") + " by " +
                             percent_of(x->size) + " from the first row of the file to the last";
  return judge(e, "drift", *x,
               {0.2,
                change + ", according to reciprocity" + by_pairs(*x) +
                    ": the lamp or the detector drifts in the order of the rows",
                "the scale is constant within " + percent_of(kSeen * x->standard_error) +
                    " through the file" + by_pairs(*x),
                change + " in the median, but the pairs disagree (" + quartiles(*x) + ")",
                "the noise of the pairs hides a change through the file below "});
}

Finding dark_level(const Evidence& e) {
  const Explanation* const x = tried(e, Cause::dark_level);
  if (!x) return too_few_pairs(e, "dark_level");
  const std::string size = percent_of(x->size) + " of the median value";
  return judge(
      e, "dark_level", *x,
      {0.2,
       "a dark level of " + size + (x->size > 0 ? " was not subtracted" : " too much was subtracted") +
           ", before division by cos_o: the differences between reciprocal pairs have this pattern" +
           by_pairs(*x),
       "a dark level divided by cos_o is below " + percent_of(kSeen * x->standard_error) +
           " of the median value" + by_pairs(*x),
       "an additive level of " + size + " would explain a part of the differences between the pairs (" +
           quartiles(*x) + ")",
       "the noise of the pairs hides an additive level below "});
}

}  // namespace brdf::sheet
