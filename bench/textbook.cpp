#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "bench/scalar_code.h"

namespace brdf::bench {
namespace {

template <class T>
constexpr T pi = T(kPi);

template <class T>
T dot3(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec3<T> normalised(const Vec3<T>& v) {
  const T s = T(1) / std::sqrt(dot3(v, v));
  return {v.x * s, v.y * s, v.z * s};
}

// The tangent frame and the cosines with which every shader begins.
template <class T>
struct Shading {
  Vec3<T> n{0, 0, 1}, t{1, 0, 0}, b{0, 1, 0};
  Vec3<T> l, v, h;
  T n_l, n_v, n_h, v_h;
  Shading(const Vec3<T>& light, const Vec3<T>& view) : l(light), v(view), h(normalised(light + view)) {
    n_l = std::max(dot3(n, l), T(0));
    n_v = std::max(dot3(n, v), T(0));
    n_h = std::max(dot3(n, h), T(0));
    v_h = std::max(dot3(v, h), T(0));
  }
};

template <class T>
T lambert_textbook(const T* w, const T*, const Shading<T>& s) {
  return w[0] / pi<T> * s.n_l;
}

template <class T>
T oren_nayar_textbook(const T* w, const T* shape, const Shading<T>& s) {
  const T sigma2 = shape[0] * shape[0];
  const T a = T(1) - T(0.5) * sigma2 / (sigma2 + T(0.33)), b = T(0.45) * sigma2 / (sigma2 + T(0.09));
  const T theta_l = std::acos(s.n_l), theta_v = std::acos(s.n_v);
  const Vec3<T> light = normalised(s.l - s.n * s.n_l), view = normalised(s.v - s.n * s.n_v);
  const T cos_phi = std::max(dot3(light, view), T(0));
  return w[0] / pi<T> *
         (a + b * cos_phi * std::sin(std::max(theta_l, theta_v)) * std::tan(std::min(theta_l, theta_v))) *
         s.n_l;
}

template <class T>
T phong_textbook(const T* w, const T* shape, const Shading<T>& s) {
  const Vec3<T> r = s.n * (T(2) * s.n_l) - s.l;
  const T lobe = (shape[0] + T(2)) / (T(2) * pi<T>)*std::pow(std::max(dot3(r, s.v), T(0)), shape[0]);
  return (w[0] / pi<T> + w[1] * lobe) * s.n_l;
}

template <class T>
T blinn_phong_textbook(const T* w, const T* shape, const Shading<T>& s) {
  const T n = shape[0];
  const T scale = (n + T(2)) * (n + T(4)) / (T(8) * pi<T> * (std::pow(T(2), -n / T(2)) + n));
  return (w[0] / pi<T> + w[1] * scale * std::pow(s.n_h, n)) * s.n_l;
}

template <class T>
T ward_textbook(const T* w, const T* shape, const Shading<T>& s) {
  if (s.n_l <= T(0) || s.n_v <= T(0)) return T(0);
  const T x = dot3(s.h, s.t) / shape[0], y = dot3(s.h, s.b) / shape[1];
  const T lobe = std::exp(-(x * x + y * y) / (s.n_h * s.n_h)) /
                 (T(4) * pi<T> * shape[0] * shape[1] * std::sqrt(s.n_l * s.n_v));
  return (w[0] / pi<T> + w[1] * lobe) * s.n_l;
}

template <class T>
T schlick_textbook(T f0, T v_h) {
  return f0 + (T(1) - f0) * std::pow(T(1) - v_h, T(5));
}

template <class T>
T smith_ggx(T ax, T ay, const Vec3<T>& w, const Shading<T>& s) {
  const T c = dot3(s.n, w), x = ax * dot3(s.t, w), y = ay * dot3(s.b, w);
  return (std::sqrt(T(1) + (x * x + y * y) / (c * c)) - T(1)) / T(2);
}

template <class T>
T ggx_textbook(const T* w, const T* shape, const Shading<T>& s) {
  if (s.n_l <= T(0) || s.n_v <= T(0)) return T(0);
  const T x = dot3(s.h, s.t) / shape[0], y = dot3(s.h, s.b) / shape[1];
  const T d = T(1) / (pi<T> * shape[0] * shape[1] * std::pow(x * x + y * y + s.n_h * s.n_h, T(2)));
  const T g = T(1) / (T(1) + smith_ggx(shape[0], shape[1], s.l, s) + smith_ggx(shape[0], shape[1], s.v, s));
  const T f = schlick_textbook(w[2], s.v_h);
  return (w[0] / pi<T> + w[1] * d * g * f / (T(4) * s.n_l * s.n_v)) * s.n_l;
}

template <class T>
T beckmann(T ax, T ay, const Shading<T>& s) {
  const T x = dot3(s.h, s.t) / ax, y = dot3(s.h, s.b) / ay;
  return std::exp(-(x * x + y * y) / (s.n_h * s.n_h)) / (pi<T> * ax * ay * std::pow(s.n_h, T(4)));
}

template <class T>
T smith_beckmann(T ax, T ay, const Vec3<T>& w, const Shading<T>& s) {
  const T c = dot3(s.n, w), x = ax * dot3(s.t, w), y = ay * dot3(s.b, w);
  const T a = c / std::sqrt(x * x + y * y);
  return (std::erf(a) - T(1)) / T(2) + std::exp(-a * a) / (T(2) * a * std::sqrt(pi<T>));
}

template <class T>
T beckmann_textbook(const T* w, const T* shape, const Shading<T>& s) {
  if (s.n_l <= T(0) || s.n_v <= T(0)) return T(0);
  const T g =
      T(1) / (T(1) + smith_beckmann(shape[0], shape[1], s.l, s) + smith_beckmann(shape[0], shape[1], s.v, s));
  const T f = schlick_textbook(w[2], s.v_h);
  return (w[0] / pi<T> + w[1] * beckmann(shape[0], shape[1], s) * g * f / (T(4) * s.n_l * s.n_v)) * s.n_l;
}

template <class T>
T vcavity_textbook(const T* w, const T* shape, const Shading<T>& s) {
  if (s.n_l <= T(0) || s.n_v <= T(0)) return T(0);
  const T g = std::min(T(1), std::min(T(2) * s.n_h * s.n_v / s.v_h, T(2) * s.n_h * s.n_l / s.v_h));
  const T c = s.v_h, k = std::sqrt(shape[2] * shape[2] - T(1) + c * c);
  const T p = (c * (k + c) - T(1)) / (c * (k - c) + T(1)), q = (k - c) / (k + c);
  const T f = T(0.5) * q * q * (T(1) + p * p);
  return (w[0] / pi<T> + w[1] * beckmann(shape[0], shape[1], s) * g * f / (T(4) * s.n_l * s.n_v)) * s.n_l;
}

template <class T, T (*kShade)(const T*, const T*, const Shading<T>&)>
void evaluate(std::span<const T> weights, std::span<const T> shape, const Directions<T>& d, T* out) {
  for (std::size_t i = 0; i < d.count; ++i)
    out[i] = kShade(weights.data(), shape.data(), Shading<T>(d.wi(i), d.wo(i)));
}

// The models of textbooks, by the catalogue's names.
template <class T>
struct Known {
  std::string_view name;
  Scalar<T> code;
  Goals goals{};
};
template <class T>
constexpr std::array<Known<T>, 8> kKnown{
    {{"lambert", &evaluate<T, lambert_textbook<T>>, {0, 0, 0}},
     {"oren_nayar", &evaluate<T, oren_nayar_textbook<T>>, {0, 0, 1.4}},
     {"phong", &evaluate<T, phong_textbook<T>>},
     {"blinn_phong", &evaluate<T, blinn_phong_textbook<T>>},
     {"ward", &evaluate<T, ward_textbook<T>>, {0.4, 0.4}},
     {"cook_torrance", &evaluate<T, ggx_textbook<T>>, {0.85, 0.75}},
     {"cook_torrance_beckmann", &evaluate<T, beckmann_textbook<T>>},
     {"cook_torrance_vcavity", &evaluate<T, vcavity_textbook<T>>, {0.4, 0.4}}}};

template <class T>
const Known<T>* find(const Reflectance& form) {
  for (const Known<T>& known : kKnown<T>)
    if (known.name == form.info().name) return &known;
  return nullptr;
}

}  // namespace

template <class T>
Scalar<T> textbook(const Reflectance& form) {
  const Known<T>* known = find<T>(form);
  return known ? known->code : nullptr;
}
template Scalar<float> textbook(const Reflectance&);
template Scalar<double> textbook(const Reflectance&);

Goals goals_of(const Reflectance& form) {
  const Known<double>* known = find<double>(form);
  return known ? known->goals : Goals{0, 0, 0};
}

}  // namespace brdf::bench
