#include "validate/search/jump_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf::validate {
namespace {

constexpr double kLargestTheta = 89;      // degrees; another check covers the horizon
constexpr int kSamples = 48;              // samples per arc
constexpr double kNear = 1e-12;           // of an arc: a difference that remains at this distance is a step
constexpr double kSuspect = 0.05;         // a change between samples that is examined further
constexpr std::size_t kMostSuspects = 4;  // per arc
// Of an arc: at this distance from a step, f must have the same value as directly at the step, on both
// sides.
constexpr double kBeside = 1e-7;

// One angle that moves while the others are fixed.
struct Arc {
  Pair base;
  int which;  // theta_o, phi_o or theta_i

  Pair at(double t) const {
    Pair p = base;
    if (which == 0) p.theta_o = t * kLargestTheta;
    if (which == 1) p.phi_o = p.phi_i + (1.2 * t - 0.1) * 180;  // beyond both sides of the plane of incidence
    if (which == 2) p.theta_i = t * kLargestTheta;
    p.wi = direction(degrees(p.theta_i), degrees(p.phi_i));
    p.wo = direction(degrees(p.theta_o), degrees(p.phi_o));
    return p;
  }
};

class ArcSearch {
 public:
  ArcSearch(const Material& m, const Arc& arc, long& evaluations)
      : m_(m), arc_(arc), evaluations_(evaluations) {}

  // The largest step that exceeds `least`.
  std::optional<Jump> run(double least) {
    std::array<Values, kSamples> f;
    for (int k = 0; k < kSamples; ++k) f[std::size_t(k)] = values((k + 0.37) / kSamples);
    std::vector<std::pair<double, int>> suspects;
    for (int k = 0; k + 1 < kSamples; ++k)
      if (const double change = change_of(f[std::size_t(k)], f[std::size_t(k + 1)]); change > kSuspect)
        suspects.emplace_back(-change, k);
    std::ranges::sort(suspects);
    suspects.resize(std::min(suspects.size(), kMostSuspects));
    std::optional<Jump> largest;
    for (const auto& [change, k] : suspects) {
      const auto jump = narrowed((k + 0.37) / kSamples, (k + 1.37) / kSamples, f[std::size_t(k)],
                                 f[std::size_t(k + 1)], largest ? largest->value : least);
      if (jump) largest = jump;
    }
    return largest;
  }

 private:
  Values values(double t) {
    const Pair p = arc_.at(t);
    Values f(m_.channels.size());
    eval(m_, p.wi, p.wo, f);
    evaluations_ += long(f.size());
    return f;
  }

  // The change of the channel with the largest change. Channels with a value that is not finite are left
  // out; another check reports them.
  static double change_of(const Values& a, const Values& b) {
    double most = 0;
    for (std::size_t c = 0; c < a.size(); ++c)
      if (std::isfinite(a[c]) && std::isfinite(b[c]))
        most = std::max(most, difference(a[c], b[c], kFaintest));
    return most;
  }

  std::optional<Jump> narrowed(double left, double right, Values at_left, Values at_right, double least) {
    double highest = 0;
    for (const Values* f : {&at_left, &at_right})
      for (const double x : *f) highest = std::max(highest, std::abs(x));
    while (right - left > kNear) {
      const double middle = 0.5 * (left + right);
      Values f = values(middle);
      const bool in_left = change_of(at_left, f) >= change_of(f, at_right);
      (in_left ? right : left) = middle;
      (in_left ? at_right : at_left) = std::move(f);
      if (!(change_of(at_left, at_right) > least)) return std::nullopt;
    }
    return step_at(left, right, at_left, at_right, highest);
  }

  // Rejects poles, which grow without limit, and values that consist of rounding errors, which change
  // everywhere.
  std::optional<Jump> step_at(double left, double right, const Values& at_left, const Values& at_right,
                              double highest) {
    const double change = change_of(at_left, at_right);
    if (left < kBeside || change_of(values(left - kBeside), at_left) > 0.1 * change ||
        change_of(at_right, values(right + kBeside)) > 0.1 * change)
      return std::nullopt;
    Jump jump{m_, arc_.at(left), arc_.at(right)};
    for (std::size_t c = 0; c < at_left.size(); ++c) {
      const double value = difference(at_left[c], at_right[c], kFaintest);
      if (!(value > jump.value) || std::max(std::abs(at_left[c]), std::abs(at_right[c])) > 1e3 * highest)
        continue;
      jump.value = value, jump.before = at_left[c], jump.after = at_right[c];
    }
    return jump.value > 0 ? std::optional(jump) : std::nullopt;
  }

  const Material& m_;
  Arc arc_;
  long& evaluations_;
};

// The subject's own parameters, then points inside the cube, because widths are often 0 on its faces.
std::vector<Material> materials(const Subject& subject, const CheckOptions& options) {
  std::vector<Material> out{subject.own()};
  const std::size_t dimensions = subject.dimensions();
  if (dimensions == 0) return out;
  for (std::vector<double> corner : cube_corners(dimensions, 4)) {
    for (double& x : corner) x = 0.1 + 0.8 * x;
    out.push_back(subject.at(corner));
  }
  const std::size_t cover = options.effort == Effort::full ? 96 : 16;
  for (std::size_t k = 0; k < cover; ++k) {
    std::vector<double> point = cover_point(k, dimensions, options.seed);
    for (double& x : point) x = 0.05 + 0.9 * x;
    out.push_back(subject.at(point));
  }
  return out;
}

}  // namespace

std::optional<Jump> largest_jump(const Subject& subject, const CheckOptions& options, double least,
                                 long& evaluations) {
  const std::size_t arcs = options.effort == Effort::full ? 48 : 12;
  std::optional<Jump> largest;
  std::size_t drawn = 0;
  for (const Material& m : materials(subject, options))
    for (std::size_t k = 0; k < arcs; ++k) {
      if (options.budget && !options.budget->take()) continue;
      const std::vector<double> at = cover_point(drawn++, 4, options.seed);
      Arc arc{{}, int(drawn % 3)};
      arc.base.theta_i = kLargestTheta * at[0], arc.base.theta_o = kLargestTheta * at[1];
      const bool all_round = subject.outside_facts() && subject.outside_facts()->all_round;
      arc.base.phi_i = subject.anisotropic() ? (all_round ? 360 : 90) * at[2] : 0;
      arc.base.phi_o = arc.base.phi_i + (all_round ? 360 : 180) * at[3];
      if (auto jump = ArcSearch(m, arc, evaluations).run(largest ? largest->value : least))
        largest = std::move(jump);
    }
  return largest;
}

}  // namespace brdf::validate
