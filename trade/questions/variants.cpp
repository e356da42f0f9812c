#include "trade/questions/variants.h"
#include "brdf/forms.h"

#include <cmath>

#include "trade/approximations/lobes.h"
#include "trade/questions/picture.h"

namespace brdf::trade {
namespace {

// kd/pi + D V (a + b (1 - cos_d)^5), column 6 alpha, column
// 7 f0 (a = ks f0, b = ks (1 - f0)); kd 0.3, ks 0.5.
template <class V, bool fresnel>
struct whole_model {
  V v;
  template <class T>
  static std::array<T, 3> lobes(const V& v, const T& alpha, const Geometry<T>& g) {
    const Roughness<T> a{alpha, alpha};
    const T vd = quotient(d_ggx(a, g), v(a, g));
    return {T(1 / kPi), vd, fresnel ? vd * schlick(g) : T(0)};
  }
  template <class T>
  T operator()(const Row<T>& x) const {
    const std::array<T, 3> l = lobes(v, x[6], geometry_of(x));
    return T(0.3) * l[0] + T(0.5) * (x[7] * l[1] + (T(1) - x[7]) * l[2]);
  }
};
template <class M>
struct at_defaults {
  M model;
  template <class T>
  T operator()(Row<T> x) const {
    x[6] = T(0.3);
    x[7] = T(0.04);
    return model(x);
  }
};

using Lobes = std::array<double, 3> (*)(double alpha, const Geometry<double>& g);
template <class V, bool fresnel>
std::array<double, 3> lobes_of(double alpha, const Geometry<double>& g) {
  return whole_model<V, fresnel>::lobes(V{}, alpha, g);
}

struct Variant {
  const char* name;
  const char* note;
  Lobes lobes;
  Kernel (*kernel_of)();
  Kernel (*picture_of)();
};
template <class V, bool fresnel>
constexpr Variant variant(const char* name, const char* note) {
  return {name, note, lobes_of<V, fresnel>, [] { return kernel(whole_model<V, fresnel>{}); },
          [] { return kernel(at_defaults<whole_model<V, fresnel>>{}); }};
}
const std::array kVariants{
    variant<hammon_correlated, true>("masking by Hammon", "no square roots"),
    variant<schlick_ggx_half, true>("masking by Schlick-GGX", "k = alpha/2"),
    variant<masking_dropped, true>("masking dropped", "G = 1"),
    variant<smith_correlated, false>("no Fresnel", "the reflectance at normal incidence for every angle"),
    variant<hammon_correlated, false>("masking by Hammon, no Fresnel", "both"),
};

const Variant& find_variant(const std::string& name) {
  for (const Variant& v : kVariants)
    if (name == v.name) return v;
  return kVariants[0];
}

// Normal equations of one channel, and the best weights
// that are not negative: every subset of lobes is solved.
struct Normal {
  double a[3][3] = {}, b[3] = {}, c = 0;
  void add(const std::array<double, 3>& lobe, double g, double w2) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) a[i][j] += w2 * lobe[std::size_t(i)] * lobe[std::size_t(j)];
      b[i] += w2 * lobe[std::size_t(i)] * g;
    }
    c += w2 * g * g;
  }
  double cost(const std::array<double, 3>& x) const {
    double sum = c;
    for (int i = 0; i < 3; ++i) {
      sum -= 2 * b[i] * x[std::size_t(i)];
      for (int j = 0; j < 3; ++j) sum += x[std::size_t(i)] * a[i][j] * x[std::size_t(j)];
    }
    return sum;
  }
  // Gaussian elimination with the diagonal as pivot; lobes without weight are skipped.
  bool solve(int subset, std::array<double, 3>& x) const {
    std::vector<int> in;
    for (int i = 0; i < 3; ++i)
      if ((subset >> i) & 1) in.push_back(i);
    const std::size_t n = in.size();
    std::vector<std::vector<double>> m(n, std::vector<double>(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) m[i][j] = a[in[i]][in[j]];
      m[i][n] = b[in[i]];
    }
    for (std::size_t k = 0; k < n; ++k) {
      if (!(m[k][k] > 1e-12 * a[in[k]][in[k]])) return false;
      for (std::size_t i = k + 1; i < n; ++i)
        for (std::size_t j = n + 1; j-- > k;) m[i][j] -= m[i][k] / m[k][k] * m[k][j];
    }
    x = {};
    for (std::size_t k = n; k-- > 0;) {
      double sum = m[k][n];
      for (std::size_t j = k + 1; j < n; ++j) sum -= m[k][j] * x[std::size_t(in[j])];
      x[std::size_t(in[k])] = sum / m[k][k];
      if (x[std::size_t(in[k])] < 0) return false;
    }
    return true;
  }
  std::array<double, 3> best() const {
    std::array<double, 3> best{}, x{};
    for (int subset = 1; subset < 8; ++subset)
      if (solve(subset, x) && cost(x) < cost(best)) best = x;
    return best;
  }
};

struct Sample {
  Geometry<double> g;
  std::array<double, 3> f;
  double weight;  // irradiance cos_i
};

}  // namespace

std::vector<std::string> variant_names() {
  std::vector<std::string> names;
  for (const Variant& v : kVariants) names.push_back(v.name);
  return names;
}

std::vector<Question> variant_questions() {
  Domain everyday = direction_domain({"alpha", 0.05, 1, true}, {"f0", 0.02, 1, true}, 80);
  Question q{kVariantQuestion,
             "f_r",
             Measure::relative,
             everyday,
             {direction_domain({"alpha", 1e-4, 1e-4}, {"f0", 0.02, 1, true}, 80),
              direction_domain({"alpha", 0.05, 1, true}, {"f0", 1e-4, 1e-4}, 80),
              direction_domain({"alpha", 0.05, 1, true}, {"f0", 0.9999, 0.9999}, 80),
              direction_domain({"alpha", 0.05, 1, true}, {"f0", 0.02, 1, true}, 89.5)},
             {}};
  const Variant exact =
      variant<smith_correlated, true>("cook_torrance", "Smith's correlated masking, Schlick");
  q.choices.push_back({exact.name, exact.kernel_of(), exact.note, exact.picture_of()});
  for (const Variant& v : kVariants) q.choices.push_back({v.name, v.kernel_of(), v.note, v.picture_of()});
  return {q};
}

FittedVariant fit_variant(const std::string& name, const io::SampleTable& table) {
  const Variant& variant = find_variant(name);
  const DirectionArrays<double> arrays = io::unit_directions(table);
  const Directions<double> d = arrays.view();
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const auto g = geometry(d.wi(k), d.wo(k));
    const double sigma = table.has_sigma(0) ? table.sigma[0][k] : 1;
    samples.push_back({g, {table.values[0][k], table.values[1][k], table.values[2][k]}, g.cos_i / sigma});
  }
  FittedVariant best{name, 0, {}, {}};
  const auto at = [&](double log_alpha, FittedVariant* keep) {
    const double alpha = std::exp(log_alpha);
    std::array<Normal, 3> normal{};
    for (const Sample& s : samples) {
      const std::array<double, 3> lobe = variant.lobes(alpha, s.g);
      for (std::size_t c = 0; c < 3; ++c) normal[c].add(lobe, s.f[c], s.weight * s.weight);
    }
    double cost = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<double, 3> w = normal[c].best();
      cost += normal[c].cost(w);
      if (keep) keep->weights[c] = w;
    }
    if (keep) keep->alpha = alpha;
    return cost;
  };
  // A grid finds the basin, golden section its bottom.
  const double low = std::log(0.005), high = 0;
  double centre = low, least = at(low, nullptr);
  const double step = (high - low) / 24;
  for (int k = 1; k <= 24; ++k)
    if (const double cost = at(low + k * step, nullptr); cost < least) least = cost, centre = low + k * step;
  double a = std::max(low, centre - step), b = std::min(high, centre + step);
  const double ratio = 0.6180339887498949;
  for (int k = 0; k < 30; ++k) {
    const double x = b - ratio * (b - a), y = a + ratio * (b - a);
    if (at(x, nullptr) < at(y, nullptr))
      b = y;
    else
      a = x;
  }
  at(0.5 * (a + b), &best);
  best.reflectance = [lobes = variant.lobes, alpha = best.alpha, w = best.weights](const Vec3<double>& wi,
                                                                                   const Vec3<double>& wo) {
    const auto g = geometry(wi, wo);
    const std::array<double, 3> l = lobes(alpha, g);
    std::array<double, 3> f{};
    for (std::size_t c = 0; c < 3; ++c) f[c] = w[c][0] * l[0] + w[c][1] * l[1] + w[c][2] * l[2];
    return f;
  };
  return best;
}

}  // namespace brdf::trade
