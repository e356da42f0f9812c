#include <algorithm>
#include <atomic>
#include <cmath>

#include "brdf/integrals.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "validate/form/checks.h"
#include "validate/search/pair_search.h"
#include "validate/search/search.h"

namespace brdf::validate {
namespace {

constexpr double kExact = 1e-9;  // tolerance of the albedo that is reported
constexpr long kMostToCompare = 20000;
// Tolerance by which an albedo of exactly 1 may come out higher. The tolerance is larger for outside code
// in float, because its constants are rounded to float.
constexpr double kSlack = 1e-9, kOutsideSlack = 1e-6;

// The elevation (radians) at x in [0, 1]: from the normal down to max_theta (degrees), with denser spacing
// towards grazing.
double elevation_at(double x, double max_theta) {
  const double lowest = degrees(90 - max_theta).radians();
  return lowest + (kPi / 2 - lowest) * (1 - x) * (1 - x);
}

struct WorstAlbedo {
  double value = -HUGE_VAL, bound = 0;
  bool converged = true;
  std::size_t channel = 0;
  std::vector<double> weights;  // of a form, if they were chosen here
  long evaluations = 0;

  // The f of outside code may be NaN or infinite within the hemisphere.
  bool is_known() const { return std::isfinite(value) && std::isfinite(bound); }
};

// Returns the corners of the domain of a form's weights at which the albedo may be largest. The weights of a
// basis are independent, so that the sign of each function's albedo decides.
std::vector<std::vector<double>> worst_corners(const Subject& subject, std::span<const AlbedoResult> lobes) {
  const ReflectanceInfo& f = info(*subject.of_form());
  std::vector<std::vector<double>> corners;
  if (f.basis) {
    std::vector<double>& w = corners.emplace_back();
    for (std::size_t k = 0; k < f.weights.size(); ++k) {
      const ParameterInfo weight = within_unit(f.weights[k]);
      w.push_back(lobes[k].value > lobes[k].error_bound    ? weight.max
                  : lobes[k].value < -lobes[k].error_bound ? weight.min
                                                           : 0);
    }
    return corners;
  }
  for (std::size_t corner = 0; corner < std::size_t{1} << f.weights.size(); ++corner) {
    std::vector<double> w;
    for (std::size_t k = 0; k < f.weights.size(); ++k)
      w.push_back(corner >> k & 1 ? std::min(f.weights[k].max, 1.0) : f.weights[k].min);
    double shared = 0;
    for (const std::size_t k : subject.shared_weights()) shared += w[k];
    if (!(shared > 1)) corners.push_back(std::move(w));
  }
  return corners;
}

// Largest albedo over the weights that a form may have. The albedo is linear in each weight, so the worst
// weights are corners of their domain.
WorstAlbedo over_weights(const Subject& subject, std::span<const double> shape, double theta, double phi,
                         const AlbedoOptions& options) {
  WorstAlbedo worst;
  const auto lobes = lobe_albedos(*subject.of_form(), shape, radians(theta), radians(phi), options);
  const ReflectanceInfo& f = info(*subject.of_form());
  for (std::vector<double> w : worst_corners(subject, lobes)) {
    if (subject.is_restricted()) {
      Material at = make_material(*subject.of_form(), subject.channels());
      at.terms.front().shape.front().assign(shape.begin(), shape.end());
      std::fill(at.terms.front().weights.begin(), at.terms.front().weights.end(), w);
      w = subject.restricted(std::move(at)).terms.front().weights.front();
    }
    const std::vector<double> linear = linear_weights(f, w);
    double value = 0, bound = 0;
    for (std::size_t k = 0; k < linear.size(); ++k) {
      value += linear[k] * lobes[k].value;
      if (linear[k] != 0) bound += std::abs(linear[k]) * lobes[k].error_bound;
    }
    if (value > worst.value) {
      worst.value = value;
      worst.bound = bound;
      worst.weights = std::move(w);
    }
  }
  worst.converged = worst.bound <= options.tolerance * std::abs(worst.value);
  worst.evaluations = lobes.front().evaluations;
  return worst;
}

// With an error bound of this size or more it is undecided whether the albedo exceeds 1.
constexpr double kTooWide = 0.01;

// If the largest albedo is below this value, nearly all light is lost.
constexpr double kNearlyAll = 0.01;

// The other of the two directions that a furnace may fix.
Fixed other(Fixed fixed) {
  return fixed == Fixed::light ? Fixed::viewer : Fixed::light;
}

WorstAlbedo over_channels(const Material& m, double theta, double phi, const AlbedoOptions& options) {
  WorstAlbedo worst;
  const auto results = directional_albedo(m, radians(theta), radians(phi), options);
  for (std::size_t c = 0; c < results.size(); ++c)
    if (results[c].value > worst.value)
      worst = {results[c].value, results[c].error_bound, results[c].converged, c, {}, results[c].evaluations};
  return worst;
}

// The domain of the search: the whole domain, or (tied) equal widths only, for which the azimuth has no
// effect.
class EnergySearch {
 public:
  EnergySearch(const Subject& subject, const CheckOptions& options, bool tied, Fixed fixed = Fixed::light)
      : subject_(subject), options_(options), tied_(tied), fixed_(fixed) {
    linear_ = subject.of_form() && info(*subject.of_form()).fittable();
    parameters_ = (linear_ ? subject.shape_dimensions() : subject.dimensions()) - (tied ? 1 : 0);
    turns_ = subject.anisotropic() && !tied;
  }

  Finding run() {
    const bool full = options_.effort == Effort::full;
    const std::size_t dimensions = parameters_ + (turns_ ? 2 : 1);
    SearchOptions search;
    // A line or a plane needs fewer points than a space for the same distance between neighbours.
    search.cover = std::min<std::size_t>(full ? 1000 : 100, (full ? 250 : 50) * dimensions);
    search.starts = full ? 12 : 4;
    search.steps = full ? 80 : 45;
    search.finest = 1e-6;
    search.seed = options_.seed;
    search.budget = options_.budget;
    search.any_thread = true;
    // Outside code may have a dozen parameters; the cost of the climbs is held to that of a form.
    constexpr std::size_t kFew = 7;
    if (!full && dimensions > kFew) {
      search.starts = 2;
      search.steps = search.steps * int(kFew) / int(dimensions);
    }
    const auto to = [&](double tolerance) -> Objective {
      return [this, tolerance](std::span<const double> point) {
        const WorstAlbedo found = albedo(point, tolerance);
        return found.is_known() || found.value == HUGE_VAL ? found.value : -HUGE_VAL;
      };
    };
    return judge(maximise(to(1e-3), dimensions, search, corners(dimensions), to(1e-5)));
  }

 private:
  // All corners: the extremes of the parameters, at the normal and at the largest angle, and points close
  // to these corners.
  std::vector<std::vector<double>> corners(std::size_t dimensions) const {
    std::vector<std::vector<double>> points;
    for (std::vector<double> point : cube_corners(dimensions, 6)) {
      points.push_back(point);
      if (parameters_ == 0) continue;
      for (std::size_t d = 0; d < parameters_; ++d) point[d] = 0.2 + 0.6 * point[d];
      points.push_back(point);
    }
    return points;
  }

  // The subject's coordinates of a point of the search.
  std::vector<double> padded(std::span<const double> point) const {
    std::vector<double> p(point.begin(), point.begin() + long(parameters_));
    if (tied_) {
      const auto [along, across] = info(*subject_.of_form()).axes();
      p.insert(p.begin() + across, 0);
      p[std::size_t(across)] = p[std::size_t(along)];
    }
    p.resize(subject_.dimensions(), 1.0);
    return p;
  }
  double elevation(std::span<const double> point) const {
    return elevation_at(point[parameters_], options_.max_theta);
  }
  double azimuth(std::span<const double> point) const {
    const OutsideFacts* facts = subject_.outside_facts();
    return turns_ ? kPi / 2 * point[parameters_ + 1] * (facts && facts->all_round ? 4 : 1) : 0;
  }

  WorstAlbedo albedo(std::span<const double> point, double tolerance, double lift = 1) {
    AlbedoOptions options;
    options.tolerance = tolerance;
    options.fixed = fixed_;
    // Albedos that are only compared need no full precision, however narrow the lobe becomes for the
    // parameters of outside code.
    if (subject_.is_outside() && tolerance > kExact) options.max_evaluations = kMostToCompare;
    const double theta = kPi / 2 - elevation(point) * lift;
    const Material m = subject_.at(padded(point));
    WorstAlbedo found =
        linear_ ? over_weights(subject_, m.terms.front().shape.front(), theta, azimuth(point), options)
                : over_channels(m, theta, azimuth(point), options);
    evaluations_ += found.evaluations;
    return found;
  }

  Finding judge(const Best& best) {
    const std::vector<double>& point = best.point;
    WorstAlbedo worst = albedo(point, kExact);
    for (const double tolerance : {1e-5, 1e-3})  // the best tolerance that can be reached
      if (!worst.is_known()) worst = albedo(point, tolerance);
    Finding finding{subject_.name(), "energy"};
    finding.value = worst.value;
    finding.bound = 1;
    const bool above = worst.value - worst.bound > 1 + (subject_.is_outside() ? kOutsideSlack : kSlack);
    const double theta = 90 - radians(elevation(point)).degrees(), phi = radians(azimuth(point)).degrees();
    Material at = subject_.at(padded(point));
    if (linear_ && !worst.weights.empty()) at.terms.front().weights.front() = worst.weights;
    Witness w;
    w.parameters = subject_.parameters(at);
    w.angles = {{"theta", theta}, {"phi", phi}};
    w.channel = at.channels[worst.channel];
    w.command = subject_.command("albedo", at,
                                 (fixed_ == Fixed::viewer ? "--fixed o " : "") + std::string("--theta ") +
                                     io::to_text(theta) + " --phi " + io::to_text(phi) + " --tolerance 1e-9");
    finding.witness = w;
    finding.evaluations = evaluations_;
    if (!worst.is_known()) return unknown(std::move(finding), best.value);
    const std::string size = io::short_number(worst.value, 7) + " (+-" + io::short_number(worst.bound, 2) +
                             ") up to " + io::to_text(options_.max_theta) + " degrees";
    finding.conclude(!above, "largest directional albedo found: " + size, "directional albedo up to " + size);
    if (!above && !(worst.bound < kTooWide)) {
      finding.outcome = Outcome::undecided;
      finding.statement = "the largest albedo that was found is not known accurately enough: " + size;
    }
    if (subject_.is_outside() && worst.value < kNearlyAll)
      finding.statement += "; nearly all light is lost for all parameters";
    if (above) finding.statement += growth(point, worst.value);
    if (!worst.converged) finding.statement += "; the integral did not reach 1e-9";
    finding.evaluations = evaluations_;
    return finding;
  }

  // The finding if no integral has a finite value.
  static Finding unknown(Finding finding, double value) {
    finding.value = value;
    if (value == HUGE_VAL) {
      finding.conclude(
          false, "", "the directional albedo is unbounded: f cos has no finite integral over the hemisphere");
    } else {
      finding.outcome = Outcome::undecided;
      finding.statement =
          "f is not finite within the hemisphere at any parameters that were tried, so the directional "
          "albedo is undefined";
    }
    return finding;
  }

  // If the worst angle is the limit max_theta, describes the growth of the albedo E beyond it: E ~ cos^-p.
  std::string growth(const std::vector<double>& point, double here) {
    if (point[parameters_] < 1 || options_.max_theta >= 90) return "";
    const double nearer = albedo(point, 1e-6, 0.01).value, nearest = albedo(point, 1e-6, 1e-4).value;
    if (!std::isfinite(nearest)) return "; beyond this angle the albedo grows without limit";
    const double power = std::log(nearest / nearer) / std::log(100.0);
    if (power > 0.05)
      return "; beyond this angle the albedo grows as 1/cos^" + io::short_number(power, 2) + " without limit";
    return "; beyond this angle the albedo tends to " + io::short_number(nearest, 5) +
           (nearest > here ? "" : " (no higher)");
  }

  const Subject& subject_;
  const CheckOptions& options_;
  const bool tied_;
  const Fixed fixed_;
  bool linear_ = false, turns_ = false;
  std::size_t parameters_ = 0;
  std::atomic<long> evaluations_ = 0;
};

}  // namespace

namespace {

// Returns whether reciprocity is violated at pairs of a cover.
bool is_one_way(const Subject& subject, const CheckOptions& options) {
  constexpr std::size_t kPairs = 400;
  constexpr double kSeen = 1e-6;
  for (std::size_t k = 0; k < kPairs; ++k) {
    const std::vector<double> point = cover_point(k, pair_dimensions(subject), options.seed);
    const Material m = subject.at(point);
    const Pair p = pair_of(subject, point);
    if (std::min(p.wi.z, p.wo.z) < 0.01) continue;  // closer to the horizon rounding may be larger
    Values here(m.channels.size()), there(here.size());
    eval(m, p.wi, p.wo, here);
    eval(m, p.wo, p.wi, there);
    for (std::size_t c = 0; c < here.size(); ++c)
      if (difference(here[c], there[c], kFaintest) > kSeen) return true;
  }
  return false;
}

// For code that is not reciprocal the albedo depends on the direction that is fixed, so both are searched.
// Integrals over the viewer give the fraction of a light's power that is reflected; furnaces fix the
// viewer.
Finding of_both_directions(Finding light, const Subject& subject, const CheckOptions& options) {
  const Finding viewer = EnergySearch(subject, options, false, other(Fixed::light)).run();
  const bool light_fails = light.outcome == Outcome::fail || viewer.outcome == Outcome::pass;
  Finding finding = light_fails ? light : viewer;
  finding.statement =
      "at fixed incidence: " + light.statement + "; at fixed viewing direction: " + viewer.statement;
  finding.evaluations = light.evaluations + viewer.evaluations;
  return finding;
}

}  // namespace

Finding check_energy(const Subject& subject, const CheckOptions& options) {
  Finding finding = EnergySearch(subject, options, false).run();
  if (subject.is_outside() && is_one_way(subject, options))
    finding = of_both_directions(std::move(finding), subject, options);
  // A form that depends on the tangent only by orientation has no two widths that could be equal.
  if (!subject.of_form() || !info(*subject.of_form()).anisotropic()) return finding;
  // Many programs support one width only. Therefore the worst albedo at equal widths is reported in
  // addition to the overall worst.
  const Finding equal = EnergySearch(subject, options, true).run();
  finding.tied = Restricted{equal.value, *equal.witness};
  finding.evaluations += equal.evaluations;
  const ReflectanceInfo& f = info(*subject.of_form());
  const std::size_t told = f.weights.size() + std::size_t(f.axes().along);  // weights come first
  finding.statement += "; the largest with equal widths " + io::short_number(equal.value, 5) + " (" +
                       tied_name(f) + " " + io::short_number(equal.witness->parameters[told].second, 3) +
                       ", " + io::to_text(float(equal.witness->angles.front().second)) + " degrees)";
  return finding;
}

}  // namespace brdf::validate
