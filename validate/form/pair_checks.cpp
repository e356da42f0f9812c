#include <algorithm>
#include <cmath>

#include "brdf/geometry.h"
#include "io/files/numbers.h"
#include "validate/form/checks.h"
#include "validate/outside/outside_checks.h"
#include "validate/search/degrees.h"
#include "validate/search/jump_search.h"
#include "validate/search/pair_search.h"

namespace brdf::validate {
namespace {

constexpr double kReciprocityBound = 1e-10;  // rounding: the form gets the same numbers in another order
constexpr double kOutsideBound = 1e-6;       // rounding of code that was not written with this bound in mind
// A tangent frame rounds the directions, and narrow lobes magnify this rounding.
constexpr double kIsotropyBound = 1e-6;

// The largest measure(channel) over the channels.
template <class Measure>
double worst_channel(const Material& m, Measure&& measure) {
  double worst = -HUGE_VAL;
  for (std::size_t c = 0; c < m.channels.size(); ++c) worst = std::max(worst, measure(c));
  return worst;
}

double asymmetry(const Material& m, const Vec3<double>& i1, const Vec3<double>& o1, const Vec3<double>& i2,
                 const Vec3<double>& o2, double least) {
  std::vector<double> a(m.channels.size()), b(a.size());
  eval(m, i1, o1, a);
  eval(m, i2, o2, b);
  return worst_channel(m, [&](std::size_t c) { return difference(a[c], b[c], least); });
}

Finding from_best(const Subject& subject, std::string check, const Best& best, double value, double bound,
                  int evals) {
  Finding finding;
  finding.subject = subject.name();
  finding.check = std::move(check);
  finding.value = value;
  finding.bound = bound;
  finding.evaluations = best.calls * evals * long(subject.channels().size());
  finding.witness = pair_witness(subject, subject.at(best.point), pair_of(subject, best.point));
  return finding;
}

// For outside code: a step of f within the hemisphere takes precedence over a fault at the horizon.
Finding with_jump(Finding finding, const Subject& subject, const CheckOptions& options) {
  const auto jump = largest_jump(subject, options, finding.bound, finding.evaluations);
  if (!jump) return finding;
  const std::string horizon = finding.outcome == Outcome::fail ? "; " + finding.statement : "";
  finding.value = jump->value;
  finding.witness = pair_witness(subject, jump->at, jump->here, false, &jump->there);
  finding.conclude(false, "",
                   "f jumps from " + io::short_number(jump->before, 4) + " to " +
                       io::short_number(jump->after, 4) + " /sr within the hemisphere" +
                       subject.explained_jump(*jump) + horizon);
  return finding;
}

}  // namespace

Finding check_finite(const Subject& subject, const CheckOptions& options) {
  if (subject.is_outside()) return check_outside_finite(subject, options);
  Finding finding{subject.name(), "finite"};
  std::vector<Vec3<double>> directions;
  for (const double z : {1.0, 0.7, 0.1, 1e-3, 1e-6, 1e-9, 1e-13, 1e-300, 0.0, -1e-300, -1e-9, -0.5, -1.0})
    for (const double phi : {0.0, 1.0, kPi / 2, kPi}) directions.push_back(at_cosine(z, phi));
  directions.push_back({1e-310, 0, 1});
  directions.push_back({1, 1e-310, 1e-310});
  std::vector<std::vector<double>> points = cube_corners(subject.dimensions(), 6);
  for (const std::size_t last = points.size() + 16; points.size() < last;)
    points.push_back(cover_point(points.size(), subject.dimensions(), 1));
  for (const auto& point : points) {
    const Material m = subject.at(point);
    std::vector<double> f(m.channels.size()), f_cos(m.channels.size());
    for (const auto& wi : directions)
      for (const auto& wo : directions) {
        eval(m, wi, wo, f);
        eval_cos(m, wi, wo, f_cos);
        finding.evaluations += 2 * long(f.size());
        for (std::size_t c = 0; c < f.size(); ++c) {
          if (std::isfinite(f[c]) && std::isfinite(f_cos[c])) continue;
          if (finding.value++ > 0) continue;
          const auto polar = [](const Vec3<double>& w) { return in_degrees(std::acos(w.z)); };
          const auto azimuth = [](const Vec3<double>& w) { return in_degrees(std::atan2(w.y, w.x)); };
          finding.witness =
              pair_witness(subject, m, {wi, wo, polar(wi), azimuth(wi), polar(wo), azimuth(wo)});
        }
      }
  }
  finding.conclude(!(finding.value > 0), "every value is finite, at the pairs tried",
                   "some values are not finite");
  return finding;
}

namespace {

// The worst pair at which a violation is due to the model. For outside code, a violation found in double
// counts only if it persists with more digits. `rounding` is the largest violation that did not persist, or
// 0.
struct Confirmed {
  Best best;
  double rounding = 0;
};
Confirmed confirmed_worst(const Subject& subject, const PairMeasure& measure, const PairMeasure& exact,
                          double bound, const CheckOptions& options) {
  Confirmed found{worst_pair(subject, measure, options)};
  const OutsideFacts* facts = subject.outside_facts();
  const auto in_more_digits = [&](const std::vector<double>& point) {
    return exact(subject.at(point), pair_of(subject, point));
  };
  if (!facts || !facts->in_more_digits || !(found.best.value > bound)) return found;
  const double at_witness = in_more_digits(found.best.point);
  if (at_witness > bound) {
    found.best.value = at_witness;
    return found;
  }
  found.rounding = found.best.value;
  long left = options.effort == Effort::full ? 400'000 : 40'000;  // of evaluations with more digits
  found.best = worst_pair(
      subject,
      [&](const Material& m, const Pair& p) {
        const double value = measure(m, p);
        return value > bound && left-- > 0 ? exact(m, p) : std::min(value, bound);
      },
      options);
  return found;
}

std::string of_rounding(const Confirmed& found, const std::string& text) {
  return found.rounding > 0 ? "; in double " + text + ", which is rounding" : "";
}

// f of all channels with more digits.
Values precise(const Subject& subject, const Material& m, const Vec3<double>& wi, const Vec3<double>& wo) {
  return subject.outside_facts()->in_more_digits(m, wi, wo);
}

}  // namespace

Finding check_non_negative(const Subject& given, const CheckOptions& options) {
  constexpr double kBound = 1e-12;
  // Isotropy is shown in real numbers; underflow and overflow differ between the azimuths.
  const Subject subject = given.is_outside() ? given.at_every_turn() : given;
  const auto least = [](const Values& f) { return -*std::ranges::min_element(f); };
  const Confirmed found = confirmed_worst(
      subject,
      [&](const Material& m, const Pair& p) {
        Values f(m.channels.size());
        eval(m, p.wi, p.wo, f);
        return worst_channel(m, [&](std::size_t c) { return -f[c]; });
      },
      [&](const Material& m, const Pair& p) { return least(precise(subject, m, p.wi, p.wo)); }, kBound,
      options);
  const Best& best = found.best;
  Finding finding = from_best(subject, "non_negative", best, -best.value, 0, 1);
  finding.conclude(
      !(finding.value < -kBound),
      "never below 0" + of_rounding(found, "f is down to " + io::short_number(-found.rounding, 3) + " /sr"),
      "f down to " + io::short_number(finding.value, 3) + " /sr");
  if (finding.outcome == Outcome::fail) {
    const Pair pair = pair_of(subject, best.point);
    finding.statement += subject.explained(finding.check, subject.at(best.point), pair.wi, pair.wo);
  }
  return finding;
}

Finding check_reciprocity(const Subject& subject, const CheckOptions& options) {
  const double bound = subject.is_outside() ? kOutsideBound : kReciprocityBound;
  const Confirmed found = confirmed_worst(
      subject, [](const Material& m, const Pair& p) { return asymmetry(m, p.wi, p.wo, p.wo, p.wi, 0); },
      [&](const Material& m, const Pair& p) {
        const Values a = precise(subject, m, p.wi, p.wo), b = precise(subject, m, p.wo, p.wi);
        return worst_channel(m, [&](std::size_t c) { return difference(a[c], b[c], 0); });
      },
      bound, options);
  const Best& best = found.best;
  Finding finding = from_best(subject, "reciprocity", best, best.value, bound, 2);
  finding.witness = pair_witness(subject, subject.at(best.point), pair_of(subject, best.point), true);
  finding.conclude(!(finding.value > finding.bound),
                   "f(i,o) = f(o,i) to rounding, cosines from 1 to 1e-6" +
                       of_rounding(found, "they differ by " + io::percent(found.rounding)),
                   "f(i,o) and f(o,i) differ by " + io::percent(finding.value) + " of the larger");
  return finding;
}

namespace {

// The change of f when the directions are reflected at the plane of each term's tangent.
double change_by_reflection(const Material& m, const Pair& p) {
  double worst = 0;
  for (const Term& term : m.terms) {
    const double c = std::cos(2 * term.tangent_phi.radians()), s = std::sin(2 * term.tangent_phi.radians());
    const auto reflected = [&](const Vec3<double>& w) -> Vec3<double> {
      return {c * w.x + s * w.y, s * w.x - c * w.y, w.z};
    };
    worst = std::max(worst, asymmetry(Material{m.channels, {term}}, p.wi, p.wo, reflected(p.wi),
                                      reflected(p.wo), kFaintest));
  }
  return worst;
}

// The change of f when both directions turn by a quarter or a half turn. Only exact turns are used: at the
// edge of a cosine lobe x^n, rounding a direction can change f by any amount.
double change_by_turns(const Material& m, const Pair& p) {
  double worst = 0;
  for (const auto& [c, s] : {std::pair{0.0, 1.0}, std::pair{-1.0, 0.0}})
    worst = std::max(worst, asymmetry(m, p.wi, p.wo, turn(p.wi, c, s), turn(p.wo, c, s), kFaintest));
  return worst;
}

// The change of f for a turn that is not hidden by the symmetry of a square, at least 1 degree above the
// horizon, where rounding is small.
double change_by_any_turn(const Material& m, const Pair& p) {
  if (std::min(p.wi.z, p.wo.z) < 0.02) return 0;
  const double c = std::cos(0.7), s = std::sin(0.7);
  return asymmetry(m, p.wi, p.wo, turn(p.wi, c, s), turn(p.wo, c, s), kFaintest);
}

// For outside code that reads no tangent and that nothing proves to be isotropic.
Finding isotropy_of_outside(const Subject& subject, const CheckOptions& options) {
  const Confirmed found = confirmed_worst(
      subject,
      [](const Material& m, const Pair& p) {
        return std::max(change_by_turns(m, p), change_by_any_turn(m, p));
      },
      [&](const Material& m, const Pair& p) {
        const Values here = precise(subject, m, p.wi, p.wo);
        double worst = change_by_any_turn(m, p);
        for (const auto& [c, s] : {std::pair{0.0, 1.0}, std::pair{-1.0, 0.0}}) {
          const Values there = precise(subject, m, turn(p.wi, c, s), turn(p.wo, c, s));
          for (std::size_t k = 0; k < here.size(); ++k)
            worst = std::max(worst, difference(here[k], there[k], kFaintest));
        }
        return worst;
      },
      kIsotropyBound, options);
  Finding finding = from_best(subject, "isotropy", found.best, found.best.value, kIsotropyBound, 6);
  finding.conclude(!(finding.value > finding.bound),
                   "isotropic, at the pairs tried; the program itself does not ensure it",
                   "changes when the sample is rotated, although the shader reads no tangent");
  return finding;
}

}  // namespace

Finding check_isotropy(const Subject& subject, const CheckOptions& options) {
  const OutsideFacts* facts = subject.outside_facts();
  const bool two_widths = subject.of_form() && info(*subject.of_form()).anisotropic();
  const bool has_tangent = !facts || facts->oriented || two_widths;
  if (facts && facts->may_turn && !has_tangent) return isotropy_of_outside(subject, options);
  // Isotropic: exact turns of both directions. Anisotropic: the reflection at the plane of the tangent.
  const bool anisotropic = subject.anisotropic();
  const Best best = worst_pair(subject, anisotropic ? change_by_reflection : change_by_turns, options);
  Finding finding = from_best(subject, "isotropy", best, best.value, kIsotropyBound, anisotropic ? 2 : 4);
  std::string symmetric = "anisotropic: symmetric about the tangent";
  if (anisotropic && !subject.of_form())
    symmetric += " at " + io::short_number(subject.own().terms.front().tangent_phi.degrees(), 3) + " degrees";
  finding.conclude(!(finding.value > finding.bound), anisotropic ? symmetric : "isotropic",
                   anisotropic ? "not symmetric about the tangent" : "changes when the sample is rotated");
  return finding;
}

Finding check_continuity(const Subject& subject, const CheckOptions& options) {
  // f cos_i with the light at the horizon, divided by its largest value on the way there. Masking fades
  // over the narrower width times the viewer's cosine, at least 1e-4 times 1e-6. The cosine used for the
  // horizon, 1e-12, is a hundredth of this product.
  constexpr double kBound = 0.02;
  const bool outside = subject.is_outside();
  const Best best = worst_pair(
      subject,
      [outside](const Material& m, const Pair& p) {
        std::vector<double> f(m.channels.size()), largest(f.size(), kTiny), before(f.size()), level(f.size());
        const double phi = in_radians(p.phi_i);
        for (double z = 0.9; z > 1e-12; z *= 0.1) {
          eval_cos(m, at_cosine(z, phi), p.wo, f);
          for (std::size_t c = 0; c < f.size(); ++c) {
            largest[c] = std::max(largest[c], std::abs(f[c]));
            // Code in float keeps its divisors away from 0 by about 1e-6, which hides the divided value.
            // The value is therefore judged at cosines above that.
            const bool flat = std::abs(f[c] - before[c]) < kBound * std::abs(f[c]);
            if (outside && p.wo.z > 0.1 && z < 1e-3 && z > 5e-6) level[c] = flat ? std::abs(f[c]) : 0;
            before[c] = f[c];
          }
        }
        eval_cos(m, {std::cos(phi), std::sin(phi), 1e-12}, p.wo, f);
        for (std::size_t c = 0; c < f.size(); ++c) f[c] = std::max(std::abs(f[c]), level[c]);
        // The remainder of a lobe's far tail is not a visible edge.
        return worst_channel(
            m, [&](std::size_t c) { return largest[c] < 1e-9 ? 0 : std::abs(f[c]) / largest[c]; });
      },
      options);
  Finding finding = from_best(subject, "continuity", best, best.value, kBound, 13);
  Pair pair = pair_of(subject, best.point);
  pair.theta_i = 90;
  finding.witness = pair_witness(subject, subject.at(best.point), pair);
  finding.conclude(!(finding.value > finding.bound), "f cos_i tends to 0 at the horizon",
                   "f cos_i does not tend to 0 at the horizon: the value jumps");
  return outside ? with_jump(std::move(finding), subject, options) : finding;
}

}  // namespace brdf::validate
