// Constructs a reflectance from the struct of a form. All functions of the interface are derived from the
// one formula of the struct.
//
// Include this header in code that makes a reflectance from a struct of its own: Reflectance r = my_form{}.
// It compiles the batches in float and double, the derivatives and the tracer for that form, which takes
// seconds.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "brdf/any_form.h"
#include "brdf/clones.h"
#include "brdf/dual.h"
#include "brdf/form.h"
#include "brdf/reflectance.h"
#include "brdf/sampling.h"
#include "brdf/trace.h"

namespace brdf {

namespace detail {

template <Form F, class T, bool kCosine>
void eval_directions(const ParameterValues<T>& p, const Directions<T>& directions, T* out) {
  using Weights = typename F::template Weights<T>;
  using Shape = typename F::template Shape<T>;
  const auto body = [w = from_values<Weights>(p.weights), f = from_values<Weights>(p.first),
                     s = from_values<Shape>(p.shape), d = directions, out](std::size_t i) {
    const Geometry<T> g = geometry(d.wi(i), d.wo(i));
    out[i] = kCosine ? eval_cos(F{}, w, f, s, g) : eval(F{}, w, f, s, g);
  };
  repeat(body, directions.count);
}

// Returns a direction that rotates with the frame. Its last derivative is the derivative by tangent_phi.
template <int D>
Vec3<Dual<double, D>> turning(const Vec3<double>& w) {
  const auto last = [](double value, double derivative) {
    const auto partial = [&](std::size_t k) { return k + 1 == D ? derivative : 0; };
    return Dual<double, D>(value, Partials<double, D>::make(partial));
  };
  return {last(w.x, w.y), last(w.y, -w.x), last(w.z, 0)};
}

template <Form F, Partial kPartial>
void lobe_directions(std::span<const double> shape, const Directions<double>& directions,
                     const LobeRows& out) {
  constexpr std::size_t P = parameter_count<typename F::template Shape<double>>;
  constexpr int D = kPartial == Partial::none ? 0 : int(P) + (kPartial == Partial::shape_and_phi);
  using S = Dual<double, D>;
  using Shape = typename F::template Shape<S>;
  std::array<S, P> variables;
  for (std::size_t k = 0; k < P; ++k)
    variables[k] = kPartial == Partial::none ? S(shape[k]) : S::variable(shape[k], k);
  const auto body = [s = from_values<Shape>(std::span<const S>(variables)), d = directions,
                     out](std::size_t i) {
    const auto g = [&] {
      if constexpr (kPartial == Partial::shape_and_phi)
        return geometry(turning<D>(d.wi(i)), turning<D>(d.wo(i)));
      else
        return geometry(d.wi(i), d.wo(i));
    }();
    const auto lobes = F::lobes(s, g);
    const bool below = smaller(d.wi_z[i], d.wo_z[i]) < 0;
    [&]<std::size_t... k>(std::index_sequence<k...>) {
      const auto put = [&](std::size_t row, double value) {
        out.data[row * out.stride + i] = below ? 0 : value;
      };
      const auto put_lobe = [&](std::size_t lobe, const S& value) {
        put(lobe * (D + 1), value.a);
        [&]<std::size_t... j>(std::index_sequence<j...>) {
          (put(lobe * (D + 1) + 1 + j, value.v[j]), ...);
        }(std::make_index_sequence<D>{});
      };
      (put_lobe(k, lobes[k]), ...);
    }(std::make_index_sequence<lobe_count<F>>{});
  };
  repeat(body, directions.count);
}

template <Form F>
void lobes_with(std::span<const double> shape, Partial partial, const Directions<double>& d,
                const LobeRows& out) {
  switch (partial) {
    case Partial::none:
      return lobe_directions<F, Partial::none>(shape, d, out);
    case Partial::shape:
      return lobe_directions<F, Partial::shape>(shape, d, out);
    case Partial::shape_and_phi:
      return lobe_directions<F, Partial::shape_and_phi>(shape, d, out);
  }
}

// A form that mixes the channels' weights has no lobes, so its weights are variables, too.
template <Form F>
void gradient_directions(const ParameterValues<double>& p, const Directions<double>& d, const LobeRows& out) {
  constexpr std::size_t P = parameter_count<typename F::template Shape<double>>,
                        W = parameter_count<typename F::template Weights<double>>;
  using D = Dual<double, int(P + W)>;
  using Shape = typename F::template Shape<D>;
  using Weights = typename F::template Weights<D>;
  std::array<D, P> shape;
  std::array<D, W> weights, first;
  for (std::size_t k = 0; k < P; ++k) shape[k] = D::variable(p.shape[k], k);
  for (std::size_t k = 0; k < W; ++k) {
    weights[k] = D::variable(p.weights[k], P + k);
    first[k] = p.first.data() == p.weights.data() ? weights[k] : D(p.first[k]);
  }
  const auto s = from_values<Shape>(std::span<const D>(shape));
  const auto w = from_values<Weights>(std::span<const D>(weights)),
             f = from_values<Weights>(std::span<const D>(first));
  for (std::size_t i = 0; i < d.count; ++i) {
    const D value = brdf::eval(F{}, w, f, s, geometry(d.wi(i), d.wo(i)));
    out.data[i] = value.a;
    for (std::size_t k = 0; k < P + W; ++k) out.data[(1 + k) * out.stride + i] = value.v[k];
  }
}

// Determines the effect of linear() by evaluating it: the weight that each lobe takes, and the factor of
// that weight.
template <LinearForm F>
consteval auto lobe_weights() {
  using W = typename F::template Weights<double>;
  constexpr std::size_t n = parameter_count<W>, lobes = lobe_count<F>;
  constexpr auto at = [](std::size_t weight, double value, std::size_t f0, double fresnel) {
    std::array<double, n> values{};
    values[weight] = value;
    if (f0 < n) values[f0] = fresnel;
    return from_values<W>(std::span<const double>(values)).linear();
  };
  std::size_t f0 = n;
  for (std::size_t k = 0; k < n; ++k)
    if (W::fields()[k].info.role == Role::f0) f0 = k;
  std::array<LobeWeight, lobes> found{};
  std::array<int, lobes> matches{};
  for (std::size_t k = 0; k < n; ++k) {
    if (k == f0) continue;
    const auto dark = at(k, 0, f0, 0.25), low = at(k, 2, f0, 0), part = at(k, 2, f0, 0.25),
               high = at(k, 4, f0, 1);
    for (std::size_t l = 0; l < lobes; ++l) {
      if (dark[l] != 0) matches[l] += 2;
      const auto is = [&](double a, double b, double c) {
        return low[l] == a && part[l] == b && high[l] == c;
      };
      if (is(0, 0, 0)) continue;
      const auto factor = is(2, 2, 4)     ? LobeWeight::Factor::one
                          : is(0, 0.5, 4) ? LobeWeight::Factor::f0
                                          : LobeWeight::Factor::rest;
      matches[l] += factor != LobeWeight::Factor::rest || is(2, 1.5, 0) ? 1 : 2;
      found[l] = {k, factor};
    }
  }
  bool expressible = true;
  for (const int m : matches) expressible = expressible && m == 1;
  return std::pair(found, expressible);
}

template <Form F>
struct FormFacts {
  template <class P>
  static constexpr auto infos() {
    std::array<ParameterInfo, parameter_count<P>> table{};
    std::size_t k = 0;
    for (const auto& field : P::fields()) table[k++] = field.info;
    return table;
  }
  static constexpr auto kWeights = infos<typename F::template Weights<double>>();
  static constexpr auto kShape = infos<typename F::template Shape<double>>();
  static constexpr auto kLobes = [] {
    if constexpr (LinearForm<F>) {
      constexpr auto found = lobe_weights<F>();
      static_assert(found.second,
                    "linear() must give each lobe one weight, or one weight times f0 or 1 - f0; other "
                    "weights cannot be fitted");
      static_assert(weights_follow_from_lobes(found.first, kWeights),
                    "every weight needs a lobe, and f0 must divide the lobes of one weight in two ways");
      return found.first;
    } else {
      return std::array<LobeWeight, 0>{};
    }
  }();

  static constexpr ReflectanceInfo make() {
    ReflectanceInfo r;
    r.name = F::name;
    r.family = F::family;
    r.canonical = r.name == r.family;
    r.weights = kWeights;
    r.shape = kShape;
    r.lobes = kLobes;
    r.mixes_channels = !LinearForm<F>;
    r.differentiable = r.has_glsl = true;
    r.follows_lobe = SampledForm<F>;
    if constexpr (requires { F::violations; }) r.violations = F::violations;
    if constexpr (requires { F::kink; }) r.kink = F::kink;
    if constexpr (requires { F::accuracy; }) r.accuracy = &F::accuracy;
    if constexpr (requires { typename F::Facets; }) r.facets = &F::Facets::facts;
    if constexpr (requires { F::albedos; }) r.albedos = F::albedos;
    if constexpr (requires { F::basis; }) r.basis = &F::basis;
    if constexpr (requires { F::about_light; }) r.about_light = F::about_light;
    return r;
  }
};

template <Form F>
class FormModel final : public ReflectanceModel {
  template <class T>
  using Weights = typename F::template Weights<T>;
  template <class T>
  using Shape = typename F::template Shape<T>;

 public:
  const ReflectanceInfo& info() const override {
    static constexpr ReflectanceInfo kInfo = FormFacts<F>::make();
    return kInfo;
  }

  void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override {
    eval_directions<F, double, false>(p, d, out);
  }
  void eval_cos(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override {
    eval_directions<F, double, true>(p, d, out);
  }
  void eval(const ParameterValues<float>& p, const Directions<float>& d, float* out) const override {
    eval_directions<F, float, false>(p, d, out);
  }
  void eval_cos(const ParameterValues<float>& p, const Directions<float>& d, float* out) const override {
    eval_directions<F, float, true>(p, d, out);
  }

  void lobes(std::span<const double> shape, Partial partial, const Directions<double>& d,
             const LobeRows& out) const override {
    if constexpr (LinearForm<F>) lobes_with<F>(shape, partial, d, out);
  }

  void gradient(const ParameterValues<double>& p, const Directions<double>& d,
                const LobeRows& out) const override {
    if constexpr (LinearForm<F>)
      ReflectanceModel::gradient(p, d, out);
    else
      gradient_directions<F>(p, d, out);
  }

  std::vector<TableWeight> weights_of(std::span<const double> lobe_weights) const override {
    std::vector<TableWeight> out;
    if constexpr (LinearForm<F>) {
      constexpr std::size_t n = lobe_count<F>;
      using D = Dual<double, int(n)>;
      std::array<D, n> linear;
      for (std::size_t k = 0; k < n; ++k) linear[k] = D::variable(lobe_weights[k], k);
      const Weights<D> w = Weights<D>::from_linear(linear);
      for (const auto& field : Weights<D>::fields()) {
        const D& x = w.*(field.member);
        out.push_back({x.a, {x.v.d, x.v.d + n}});
      }
    }
    return out;
  }

  Vec3<double> sample(std::span<const double> shape, double u1, double u2, double u3, const Vec3<double>& wo,
                      double share) const override {
    return brdf::sample(F{}, from_values<Shape<double>>(shape), u1, u2, u3, wo, share);
  }
  double pdf(std::span<const double> shape, const Vec3<double>& wi, const Vec3<double>& wo,
             double share) const override {
    return brdf::pdf(F{}, from_values<Shape<double>>(shape), wi, wo, share);
  }

  std::string glsl(const GlslOptions& options) const override { return glsl_functions(F{}, options); }
  std::string glsl_sampler(const GlslOptions& options) const override {
    return glsl_sampler_functions(F{}, options);
  }
};

}  // namespace detail

// Returns the model of a form of the catalogue, which the library alone compiles, with the flags that its
// batches need. A second copy in a program would take the place of the library's in all of the program.
template <class F>
const ReflectanceModel& model_in_library();

template <class F>
const ReflectanceModel& reflectance_of() {
  if constexpr (kInCatalogue<F>) {
    return model_in_library<F>();
  } else {
    static const detail::FormModel<F> model;
    return model;
  }
}

// A string as a template argument.
template <std::size_t N>
struct FixedName {
  char text[N];
  consteval FixedName(const char (&literal)[N]) { std::copy_n(literal, N, text); }
};

namespace detail {

template <FixedName kName, template <class> class WeightsOf, template <class> class ShapeOf, class Lobes>
struct LobesForm : Takes<WeightsOf, ShapeOf> {
  static constexpr std::string_view name = kName.text;
  static constexpr std::string_view family = kName.text;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static auto lobes(const ShapeOf<S>& shape, const Geometry<G>& g) {
    return Lobes{}(shape, g);
  }
};

}  // namespace detail

// Constructs a reflectance from a function without captures: lobes(shape, geometry), as in the struct of a
// form.
//   reflectance_from<"velvet", LobeWeights, Exponent>([](const auto& shape, const auto& g) { ... })
template <FixedName kName, template <class> class WeightsOf, template <class> class ShapeOf, class Lobes>
Reflectance reflectance_from(Lobes) {
  return detail::LobesForm<kName, WeightsOf, ShapeOf, Lobes>{};
}

}  // namespace brdf
