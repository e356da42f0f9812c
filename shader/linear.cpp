#include "shader/linear.h"

#include <algorithm>
#include <cmath>

#include "brdf/directions.h"
#include "brdf/random.h"
#include "io/files/numbers.h"
#include "shader/dependence.h"

namespace brdf::shader {
namespace {

constexpr int kProbes = 24;
constexpr double kSame = 1e-9;

// Values of the function at random directions and parameters, some of which are then changed.
class Probe {
 public:
  explicit Probe(const Function& function) : f_(function), runner_(function) {}

  // Moves to a new place: directions above the horizon, all parameters within their ranges (weights below
  // 1).
  void move() {
    const auto direction_at_random = [&] {
      return direction(radians(1.4 * uniform()), radians(2 * kPi * uniform()));
    };
    wi_ = direction_at_random();
    // Often close to the mirror direction, because a lobe that is 0 elsewhere would look linear in
    // everything.
    const double u = uniform();
    wo_ = u < 0.7 ? near({-wi_.x, -wi_.y, wi_.z}, u * 0.4) : direction_at_random();
    values_ = f_.defaults();
    for (const Parameter& p : f_.parameters)
      for (std::size_t k = 0; k < (p.colour ? 3u : 1u); ++k)
        values_[p.first + k] = within(p, 0.1 + 0.8 * uniform());
  }
  double within(const Parameter& p, double x) const {
    if (p.whole) return std::min(p.min + std::floor((p.max - p.min + 1) * x), p.max);
    const double max = std::min(p.max, std::max(p.min + 1, 1.0));
    return p.log_scale && p.min > 0 ? p.min * std::pow(p.max / p.min, x) : p.min + (max - p.min) * x;
  }
  void set(std::size_t parameter, double value) {
    const Parameter& p = f_.parameters[parameter];
    for (std::size_t k = 0; k < (p.colour ? 3u : 1u); ++k) values_[p.first + k] = value;
  }
  double value(std::size_t component = 0) {
    return evaluate<double>(f_, runner_, values_, wi_, wo_, component);
  }
  // The value with light and viewer exchanged.
  double exchanged() { return evaluate<double>(f_, runner_, values_, wo_, wi_, 0); }
  // "light (0.1, 0, 0.995), viewer (...), a=0.3".
  std::string place() const {
    const auto words = [](const Vec3<double>& w) {
      return "(" + io::short_number(w.x) + ", " + io::short_number(w.y) + ", " + io::short_number(w.z) + ")";
    };
    std::vector<std::string> out{"light " + words(wi_), "viewer " + words(wo_)};
    for (const Parameter& p : f_.parameters) out.push_back(p.name + "=" + io::short_number(values_[p.first]));
    return io::joined(out);
  }
  double cos_i() const { return wi_.z; }
  double cos_o() const { return wo_.z; }
  double uniform() { return random_.uniform(); }

 private:
  Vec3<double> near(const Vec3<double>& w, double by) {
    const double phi = 2 * kPi * uniform();
    const Vec3<double> v{w.x + by * std::cos(phi), w.y + by * std::sin(phi), w.z + 0.02};
    return v * (1 / std::sqrt(dot(v, v)));
  }

  const Function& f_;
  Runner<double, 1> runner_;
  std::vector<double> values_;
  Vec3<double> wi_{}, wo_{};
  Random random_{1};
};

bool same(double a, double b, double scale) {
  return std::abs(a - b) <= kSame * scale;
}

// Tests a property at kProbes places. `look` returns whether the property holds at a place, or std::nullopt
// if the function has no finite value there. Returns false as soon as `look` returns false, or if there are
// too few places with a value.
template <class Look>
bool holds_at_places(const Function& f, Look&& look) {
  constexpr int kMostTried = 10 * kProbes, kEnough = kProbes / 3;
  Probe probe(f);
  int seen = 0;
  for (int k = 0; k < kMostTried && seen < kProbes; ++k) {
    probe.move();
    const std::optional<bool> said = look(probe);
    if (said && !*said) return false;
    seen += said.has_value();
  }
  return seen >= kEnough;
}

// The largest magnitude of the numbers; std::nullopt if one of them is NaN or infinite.
std::optional<double> scale_of(std::initializer_list<double> numbers) {
  double scale = 0;
  for (const double x : numbers) {
    if (!std::isfinite(x)) return std::nullopt;
    scale = std::max(scale, std::abs(x));
  }
  return scale;
}

// Returns whether f is a straight line in the parameter over its whole range, ends included, and changes with
// it.
bool is_affine(const Function& f, std::size_t parameter) {
  const Parameter& p = f.parameters[parameter];
  bool changes = false;
  return holds_at_places(f,
                         [&](Probe& probe) -> std::optional<bool> {
                           double y[5], scale = 0;
                           for (int j = 0; j < 5; ++j) {
                             probe.set(parameter, p.min + (p.max - p.min) * j / 4);
                             y[j] = probe.value();
                             if (!std::isfinite(y[j])) return std::nullopt;
                             scale = std::max(scale, std::abs(y[j]));
                           }
                           changes = changes || !same(y[4], y[0], scale);
                           for (int j = 1; j < 4; ++j)
                             if (!same(y[j + 1] - y[j], y[1] - y[0], scale)) return false;
                           return true;
                         }) &&
         changes;
}

// The linear parameters with f0. The other weights are separate from one another, and f0 is separate from
// all except one of them.
std::optional<Linear> with_f0(const Function& f, const Degrees& degrees, std::vector<std::size_t> weights,
                              std::optional<std::size_t> f0) {
  if (weights.empty() || !vanishes_with(f, weights)) return std::nullopt;
  Linear out;
  out.weights = std::move(weights);
  if (f0) {
    out.weights.push_back(*f0);
    std::ranges::sort(out.weights);
    out.f0 = int(std::ranges::find(out.weights, *f0) - out.weights.begin());
  }
  int divided = -1;
  for (std::size_t k = 0; k < out.weights.size(); ++k) {
    if (int(k) == out.f0) continue;
    if (f0 && !degrees.is_separate(*f0, out.weights[k])) {
      if (divided >= 0) return std::nullopt;
      divided = int(k);
      out.lobes.push_back({k, LobeWeight::Factor::f0});
      out.lobes.push_back({k, LobeWeight::Factor::rest});
    } else {
      out.lobes.push_back({k, LobeWeight::Factor::one});
    }
  }
  if (f0 && divided < 0) return std::nullopt;
  return out;
}

}  // namespace

std::optional<Linear> linear_parameters(const Function& f) {
  const Degrees degrees = degrees_of(f);
  std::vector<std::size_t> affine;
  for (std::size_t k = 0; k < f.parameters.size(); ++k) {
    const Parameter& p = f.parameters[k];
    const bool is = !p.boolean && !p.whole && p.role != Role::width && p.role != Role::width_across &&
                    degrees.is_affine(k) && is_affine(f, k);
    if (is)
      affine.push_back(k);
    else if (p.colour)
      return std::nullopt;  // a colour differs per channel, so it must be a weight
  }
  // Colours first, then parameters with the role of a weight, then the others in their order.
  const auto rank = [&](std::size_t k) {
    const Parameter& p = f.parameters[k];
    return p.role == Role::f0                                    ? 3
           : p.colour                                            ? 0
           : p.role == Role::diffuse || p.role == Role::specular ? 1
                                                                 : 2;
  };
  std::vector<std::size_t> order = affine, weights, others;
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  for (const std::size_t k : order) {
    const bool fits = std::ranges::all_of(weights, [&](std::size_t w) { return degrees.is_separate(k, w); });
    (fits ? weights : others).push_back(k);
  }
  std::ranges::sort(weights);
  const auto holds_colours = [&](const Linear& linear) {
    for (std::size_t k = 0; k < f.parameters.size(); ++k)
      if (f.parameters[k].colour && std::ranges::find(linear.weights, k) == linear.weights.end())
        return false;
    return true;
  };
  for (const std::size_t f0 : others)
    if (const auto linear = with_f0(f, degrees, weights, f0); linear && holds_colours(*linear)) return linear;
  if (const auto linear = with_f0(f, degrees, weights, std::nullopt); linear && holds_colours(*linear))
    return linear;
  return std::nullopt;
}

std::string said_of_holes(const Function& f) {
  Probe probe(f);
  int holes = 0;
  std::string first;
  for (int k = 0; k < kProbes; ++k) {
    probe.move();
    if (std::isfinite(probe.value())) continue;
    if (++holes == 1) first = probe.place();
  }
  if (holes == 0) return "";
  return "the value is not finite at " + std::to_string(holes) + " of " + std::to_string(kProbes) +
         " directions that were tried, such as " + first + "; linearity was judged from the others";
}

bool is_zero_where_asked(const Function& f) {
  Probe probe(f);
  for (int k = 0; k < 2 * kProbes; ++k) {
    probe.move();
    for (const std::size_t c : {0, 1, 2})
      if (probe.value(c) != 0) return false;
  }
  return true;
}

bool holds_cosine(const Function& f) {
  constexpr double kReciprocal = 1e-6, kSeen = 1e-2;
  bool seen = false;
  return holds_at_places(f,
                         [&](Probe& probe) -> std::optional<bool> {
                           const double here = probe.value(), there = probe.exchanged();
                           const auto scale = scale_of({here, there});
                           if (!scale) return std::nullopt;
                           const double of_i = here / probe.cos_i(), of_o = there / probe.cos_o();
                           seen = seen || std::abs(here - there) > kSeen * *scale;
                           return std::abs(of_i - of_o) <=
                                  kReciprocal * std::max(std::abs(of_i), std::abs(of_o));
                         }) &&
         seen;
}

}  // namespace brdf::shader
