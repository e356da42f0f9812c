#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "brdf/integrals.h"
#include "io/text.h"
#include "validate/checks.h"
#include "validate/search.h"

namespace brdf::validate {
namespace {

constexpr double kRadians = kPi / 180;
constexpr double kSlack = 1e-9;  // an albedo of exactly 1 may come out this much above

// The elevation at x in [0, 1]: from the normal to max_theta, closer together towards grazing.
double elevation_at(double x, double max_theta) {
  const double lowest = (90 - max_theta) * kRadians;
  return lowest + (kPi / 2 - lowest) * (1 - x) * (1 - x);
}

struct Albedo {
  double value = -HUGE_VAL, bound = 0;
  bool converged = true;
  std::size_t channel = 0;
  std::vector<double> weights;  // of a form, where they were chosen here
  long evaluations = 0;
};

// Largest albedo over the weights that a form may have. Albedo is linear in each weight, so the worst weights
// are corners of their domain.
Albedo over_weights(const Reflectance& form, std::span<const double> shape, double theta, double phi,
                    const AlbedoOptions& options) {
  Albedo worst;
  const auto lobes = lobe_albedos(form, shape, radians(theta), radians(phi), options);
  const ReflectanceInfo& f = info(form);
  const int kd = f.weight_index(Role::diffuse), ks = f.weight_index(Role::specular);
  for (std::size_t corner = 0; corner < std::size_t{1} << f.weights.size(); ++corner) {
    std::vector<double> w;
    for (std::size_t k = 0; k < f.weights.size(); ++k)
      w.push_back(corner >> k & 1 ? std::min(f.weights[k].max, 1.0) : f.weights[k].min);
    if (kd >= 0 && ks >= 0 && w[std::size_t(kd)] + w[std::size_t(ks)] > 1) continue;
    const std::vector<double> linear = linear_weights(f, w);
    double value = 0, bound = 0;
    for (std::size_t k = 0; k < linear.size(); ++k) {
      value += linear[k] * lobes[k].value;
      if (linear[k] != 0) bound += std::abs(linear[k]) * lobes[k].error_bound;
    }
    if (value > worst.value) {
      worst.value = value;
      worst.bound = bound;
      worst.weights = w;
    }
  }
  worst.converged = worst.bound <= options.tolerance * std::abs(worst.value);
  worst.evaluations = lobes.front().evaluations;
  return worst;
}

Albedo over_channels(const Material& m, double theta, double phi, const AlbedoOptions& options) {
  Albedo worst;
  const auto results = directional_albedo(m, radians(theta), radians(phi), options);
  for (std::size_t c = 0; c < results.size(); ++c)
    if (results[c].value > worst.value)
      worst = {results[c].value, results[c].error_bound, results[c].converged, c, {}, results[c].evaluations};
  return worst;
}

// Where the search looks: everywhere, or (tied) at equal widths, where the azimuth is without effect.
class EnergySearch {
 public:
  EnergySearch(const Subject& subject, const CheckOptions& options, bool tied)
      : subject_(subject), options_(options), tied_(tied) {
    linear_ = subject.of_form() && info(*subject.of_form()).fittable();
    parameters_ = (linear_ ? subject.shape_dimensions() : subject.dimensions()) - (tied ? 1 : 0);
    turns_ = subject.anisotropic() && !tied;
  }

  Finding run() {
    const bool full = options_.effort == Effort::full;
    const std::size_t dimensions = parameters_ + (turns_ ? 2 : 1);
    SearchOptions search;
    search.cover = full ? 1000 : 100;
    search.starts = full ? 12 : 4;
    search.steps = full ? 80 : 45;
    search.finest = 1e-6;
    search.seed = options_.seed;
    const auto to = [&](double tolerance) -> Objective {
      return [this, tolerance](std::span<const double> point) { return albedo(point, tolerance).value; };
    };
    return judge(maximise(to(1e-3), dimensions, search, corners(dimensions), to(1e-5)).point);
  }

 private:
  // All corners: the extremes of the parameters, at the
  // normal and at the largest angle, and points near there.
  std::vector<std::vector<double>> corners(std::size_t dimensions) const {
    std::vector<std::vector<double>> points;
    for (std::size_t c = 0; c < std::size_t{1} << std::min<std::size_t>(dimensions, 6); ++c) {
      std::vector<double> point(dimensions);
      for (std::size_t d = 0; d < dimensions; ++d) point[d] = double(c >> d & 1);
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
    if (tied_) p.insert(p.begin() + tied_at(), point[std::size_t(tied_at() - 1)]);
    p.resize(subject_.dimensions(), 1.0);
    return p;
  }
  // alpha_y follows alpha_x in every table.
  long tied_at() const { return info(*subject_.of_form()).shape_index("alpha_y"); }
  double elevation(std::span<const double> point) const {
    return elevation_at(point[parameters_], options_.max_theta);
  }
  double azimuth(std::span<const double> point) const {
    return turns_ ? kPi / 2 * point[parameters_ + 1] : 0;
  }

  Albedo albedo(std::span<const double> point, double tolerance, double lift = 1) {
    AlbedoOptions options;
    options.tolerance = tolerance;
    const double theta = kPi / 2 - elevation(point) * lift;
    const Material m = subject_.at(padded(point));
    Albedo found = linear_ ? over_weights(*subject_.of_form(), m.terms.front().shape.front(), theta,
                                          azimuth(point), options)
                           : over_channels(m, theta, azimuth(point), options);
    evaluations_ += found.evaluations;
    return found;
  }

  Finding judge(const std::vector<double>& point) {
    const Albedo worst = albedo(point, 1e-9);
    Finding finding{subject_.name(), "energy"};
    finding.value = worst.value;
    finding.bound = 1;
    const bool above = worst.value - worst.bound > 1 + kSlack;
    finding.verdict = above ? Verdict::fail : Verdict::pass;
    const double theta = 90 - elevation(point) / kRadians, phi = azimuth(point) / kRadians;
    Material at = subject_.at(padded(point));
    if (linear_) at.terms.front().weights.front() = worst.weights;
    Witness w;
    w.parameters = subject_.parameters(at);
    w.angles = {{"theta", theta}, {"phi", phi}};
    w.channel = at.channels[worst.channel];
    w.command = "brdf albedo " + subject_.selector(at) + " --theta " + io::to_text(theta) + " --phi " +
                io::to_text(phi) + " --tolerance 1e-9";
    finding.witness = w;
    std::ostringstream text;
    text.precision(7);
    text << (above ? "reflects up to " : "albedo at most ") << worst.value << " (+-";
    text.precision(2);
    text << worst.bound << ") up to " << io::to_text(options_.max_theta) << " degrees";
    if (above) text << growth(point, worst.value);
    if (!worst.converged) text << "; the integral did not reach 1e-9";
    finding.statement = text.str();
    finding.evaluations = evaluations_;
    return finding;
  }

  // Where the worst angle is the limit, what happens beyond it: E ~ cos^-p.
  std::string growth(const std::vector<double>& point, double here) {
    if (point[parameters_] < 1 || options_.max_theta >= 90) return "";
    const double nearer = albedo(point, 1e-6, 0.01).value, nearest = albedo(point, 1e-6, 1e-4).value;
    std::ostringstream text;
    const double power = std::log(nearest / nearer) / std::log(100.0);
    if (power > 0.05)
      text << std::setprecision(2) << "; beyond, it grows as 1/cos^" << power << " without limit";
    else
      text << std::setprecision(5) << "; beyond, it tends to " << nearest
           << (nearest > here ? "" : " (no higher)");
    return text.str();
  }

  const Subject& subject_;
  const CheckOptions& options_;
  const bool tied_;
  bool linear_ = false, turns_ = false;
  std::size_t parameters_ = 0;
  long evaluations_ = 0;
};

}  // namespace

Finding check_energy(const Subject& subject, const CheckOptions& options) {
  Finding finding = EnergySearch(subject, options, false).run();
  if (!subject.of_form() || !subject.anisotropic()) return finding;
  // Many programs know one width only, so the worst of equal widths is told beside the worst of all.
  const Finding equal = EnergySearch(subject, options, true).run();
  finding.tied = Restricted{equal.value, *equal.witness};
  finding.evaluations += equal.evaluations;
  std::ostringstream text;
  text.precision(5);
  text << "; with equal widths at most " << equal.value << " (alpha ";
  for (const auto& [name, value] : equal.witness->parameters)
    if (name == "alpha_x") text << std::setprecision(3) << value;
  text << ", " << io::to_text(float(equal.witness->angles.front().second)) << " degrees)";
  finding.statement += text.str();
  return finding;
}

}  // namespace brdf::validate
