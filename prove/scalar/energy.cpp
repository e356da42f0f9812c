#include "prove/scalar/energy.h"

#include <array>

#include "prove/scalar/cosine_lobes.h"
#include "prove/scalar/majorants.h"
#include "prove/scalar/on_box.h"
#include "prove/scalar/recorded_form.h"

namespace brdf::prove {
namespace {

template <class F>
concept FacetForm = LinearForm<F> && (lobe_count<F> > 1) && requires(typename F::template Shape<double> s) {
  { s.alpha_x } -> std::convertible_to<double>;
};
template <class F>
inline constexpr bool kSchlick = std::is_same_v<typename F::template Weights<double>, SchlickWeights<double>>;
template <class F>
inline constexpr bool kIndexed = requires(typename F::template Shape<double> s) { s.eta; } &&
                                 std::is_same_v<typename F::template Weights<double>, LobeWeights<double>>;

template <class F>
inline constexpr bool kMetal = requires(typename F::template Shape<double> s) {
  s.n;
  s.k;
} && std::is_same_v<typename F::template Weights<double>, LobeWeights<double>>;

template <class T>
Roughness<T> widths_of(const Roughness<T>& shape) {
  return shape;
}
template <class Shape>
auto widths_of(const Shape& shape) {
  return Roughness<decltype(shape.alpha_x)>{shape.alpha_x, shape.alpha_y};
}

template <class F, class Majorant>
bool has_majorant(F form) {
  return is_written_as(form, [](const auto& shape, const auto& g) {
    using R = Recorded;
    const R lobe = Majorant::lobe(widths_of(shape), g);
    if constexpr (kSchlick<F>)
      return std::array{R(1 / kPi), lobe, lobe * schlick(g)};
    else if constexpr (kMetal<F>)
      return std::array{R(1 / kPi), lobe * brdf::fresnel_conductor(shape.n, shape.k, at_most(g.cos_d, R(1)))};
    else
      return std::array{R(1 / kPi), lobe * fresnel_dielectric(shape.eta, g.cos_d)};
  });
}

using I = Interval<double>;

void add_directions(Domain& domain) {
  for (const char* w : {"i", "o"}) {
    domain.variables.push_back({std::string("cos_") + w, 0, 1, Variable::Cut::cosine});
    domain.variables.push_back({std::string("turn_") + w, -2, 2, Variable::Cut::middle});
  }
}
void add(Domain& domain, const ParameterInfo& p, std::string name, bool tied = false) {
  domain.variables.push_back({std::move(name), p.min, p.max,
                              p.log_scale && p.min > 0 ? Variable::Cut::logarithmic : Variable::Cut::middle,
                              false, tied});
}

template <class F, class Majorant>
Bounds enclose_facets(std::span<const Bounds> box) {
  std::size_t at = 0;
  const auto next = [&] {
    const Bounds b = box[at++];
    return I::of(b.lo, b.hi);
  };
  Roughness<I> widths;
  widths.alpha_x = next();
  widths.alpha_y = Majorant::tied ? widths.alpha_x : next();
  I f0(0);
  if constexpr (kSchlick<F>) f0 = next();
  const Vec3<I> wi = direction<I>(box[at], box[at + 1]), wo = direction<I>(box[at + 2], box[at + 3]);
  const Geometry<I> g = geometry(wi, wo);
  const I fresnel = [&] {
    if constexpr (kSchlick<F>)
      return schlick_fresnel(f0, g);
    else
      return most_fresnel<I>();
  }();
  const I r = fresnel * Majorant::ratio(widths, g);
  return {r.lo, r.hi};
}

template <class F>
auto lobe_weights(std::span<const Bounds> weights) {
  std::size_t at = 0;
  return parameters_from<typename F::template Weights<I>, I>(weights, at).linear();
}

// What facets reflect with these weights, a function of cos_d.
template <class F>
auto reflectance_of(const typename F::template Shape<I>& s, const auto& w) {
  if constexpr (kSchlick<F>)
    return [w](const auto& c) { return schlick_at(c) * w[2] + w[1]; };
  else if constexpr (kMetal<F>)
    return [w, s](const auto& c) { return conductor_at(s.n.lo, s.k.lo, c) * w[1]; };
  else if constexpr (kIndexed<F>)
    return [w, s](const auto& c) { return dielectric_at(s.eta.lo, c) * w[1]; };
  else
    return [w](const auto&) { return w[1]; };
}

// The lobes' weights times their albedos: 1 of the diffuse one.
template <class F, class Cell>
std::optional<Bounds> albedo_of_facets(std::span<const Bounds> shape, std::span<const Bounds> weights,
                                       Bounds turn, double accuracy) {
  std::size_t at = 0;
  const auto s = parameters_from<typename F::template Shape<I>, I>(shape, at);
  const double alpha = s.alpha_x.lo;
  if (!s.alpha_x.is(alpha) || !s.alpha_y.is(alpha)) return std::nullopt;
  const auto w = lobe_weights<F>(weights);
  const Bounds facets = facet_albedo<Cell>(alpha, reflectance_of<F>(s, w), turn, accuracy);
  I most = w[1];  // F G2/G1 beside the density of visible normals, see majorants.h
  if constexpr (kSchlick<F>) most = most + w[2];
  const I lobe = I::of(std::min(facets.lo, most.hi), std::min(facets.hi, most.hi));
  const I all = w[0] * I::of(kPiBounds.lo, kPiBounds.hi) * I(1 / kPi) + lobe;
  return Bounds{all.lo, all.hi};
}

template <class F>
double stretch_of(std::span<const Bounds> shape) {
  std::size_t at = 0;
  return parameters_from<typename F::template Shape<I>, I>(shape, at).alpha_x.lo;
}

template <class F, class Majorant>
std::optional<EnergyMethod> facets(F form) {
  if (!has_majorant<F, Majorant>(form)) return std::nullopt;
  EnergyMethod m;
  m.why = "F G2/G1 beside the density of visible normals";
  using Shape = typename F::template Shape<double>;
  const auto fields = Shape::fields();
  for (const Role role : {Role::width, Role::width_across})
    for (const auto& field : fields)
      if (field.info.role == role && (role == Role::width || !Majorant::tied))
        add(m.domain, field.info, Majorant::tied ? "both_widths" : std::string(field.info.name),
            Majorant::tied);
  if constexpr (kSchlick<F>) {
    using W = typename F::template Weights<double>;
    for (const auto& field : W::fields())
      if (field.info.role == Role::f0) add(m.domain, field.info, std::string(field.info.name));
  }
  add_directions(m.domain);
  m.enclose = enclose_facets<F, Majorant>;
  if constexpr (requires { typename Majorant::Cell; }) {
    m.albedo = albedo_of_facets<F, typename Majorant::Cell>;
    m.stretch = stretch_of<F>;
  }
  return m;
}

// A diffuse term and one lobe about a direction.
template <class F>
concept CosineForm =
    LinearForm<F> && std::is_same_v<typename F::template Weights<double>, LobeWeights<double>> &&
    std::is_same_v<typename F::template Shape<double>, Exponent<double>>;

template <class Lobe>
Bounds enclose_cosine_lobe(std::span<const Bounds>) {
  const I r = Lobe::template normalisation<I>();
  return {r.lo, r.hi};
}

template <class F, class Lobe>
std::optional<Bounds> albedo_of_cosine_lobe(std::span<const Bounds>, std::span<const Bounds> weights,
                                            Bounds turn, double) {
  I cosine, sine;
  circle(turn, cosine, sine);
  const auto w = lobe_weights<F>(weights);
  const I lobe = turn.lo == 0 && turn.hi == 0 ? I(1) : Lobe::albedo(cosine);
  const I all =
      w[0] * I::of(kPiBounds.lo, kPiBounds.hi) * I(1 / kPi) + w[1] * lobe * Lobe::template normalisation<I>();
  return Bounds{all.lo, all.hi};
}

template <class Lobe, class F>
std::optional<EnergyMethod> cosine_lobe(F form, const char* why) {
  const bool its = is_written_as(form, [](const auto& shape, const auto& g) {
    return std::array{Recorded(1 / kPi), Lobe::lobe(shape.exponent, g)};
  });
  if (!its) return std::nullopt;
  return EnergyMethod{why, {}, enclose_cosine_lobe<Lobe>, albedo_of_cosine_lobe<F, Lobe>};
}

// pi f of a constant f.
Bounds enclose_constant(std::span<const Bounds>) {
  const I r = I::of(kPiBounds.lo, kPiBounds.hi) * I(1 / kPi);
  return {r.lo, r.hi};
}

Bounds enclose_rough(std::span<const Bounds> box) {
  I cosine, sine;
  circle(box[1], cosine, sine);
  const auto unit = [](const I& x) { return I::of(std::max(x.lo, 0.0), std::min(x.hi, 1.0)); };
  const I r = oren_nayar_albedo_of(I::of(box[0].lo, box[0].hi), unit(sine), unit(cosine));
  return {r.lo, r.hi};
}

template <class F>
std::optional<Bounds> albedo_of_one_lobe(std::span<const Bounds> shape, std::span<const Bounds> weights,
                                         Bounds turn, double) {
  Bounds lobe{};
  if (shape.empty()) {
    lobe = enclose_constant({});
  } else {
    const std::array box{shape[0], turn};
    lobe = enclose_rough(box);
  }
  const I all = lobe_weights<F>(weights)[0] * I::of(lobe.lo, lobe.hi);
  return Bounds{all.lo, all.hi};
}

// rho, r and the turn.
Bounds enclose_given_back(std::span<const Bounds> box) {
  I cosine, sine;
  circle(box[2], cosine, sine);
  const I r = given_back_albedo(I::of(box[0].lo, box[0].hi), I::of(box[1].lo, box[1].hi), sine, cosine);
  return {r.lo, r.hi};
}
template <class F>
bool gives_back(F form) {
  return holds_in_every_case([&](const auto& g) {
    const auto shape = recorded_parameters<typename F::template Shape<Recorded>>();
    const auto weights = recorded_parameters<typename F::template Weights<Recorded>>();
    const auto only = [](const auto& p) { return p.*(std::remove_cvref_t<decltype(p)>::fields()[0].member); };
    const auto value = given_back_value(only(weights), only(shape), g);
    return eval(form, weights, weights, shape, g) == select(g.lowest < Recorded(0), Recorded(0), value);
  });
}

// 1/s and the tilt, which stands for u: see ward_bounded_mean.
Bounds enclose_ward_bounded(std::span<const Bounds> box) {
  const I tilt = I::of(box[1].lo, box[1].hi);
  const I beyond = at_least(smaller(I(2) - tilt, I(1)), I());
  const I r = ward_bounded_mean(I::of(box[0].lo, box[0].hi), smaller(tilt, I(1)), beyond);
  return {r.lo, r.hi};
}

template <Form F>
std::optional<EnergyMethod> method_of(F form) {
  if constexpr (LinearForm<F>) {
    if constexpr (lobe_count<F> == 1) {
      using Shape = typename F::template Shape<double>;
      if (is_written_as(form, [](const auto&, const auto&) { return std::array{Recorded(1 / kPi)}; }))
        return EnergyMethod{"f is constant", {}, enclose_constant, albedo_of_one_lobe<F>};
      if constexpr (std::is_same_v<Shape, SlopeDeviation<double>>) {
        if (is_written_as(
                form, [](const auto& s, const auto& g) { return std::array{oren_nayar_lobe(s.sigma, g)}; })) {
          EnergyMethod m{"its integral in closed form", {}, enclose_rough, albedo_of_one_lobe<F>};
          add(m.domain, Shape::fields()[0].info, std::string(Shape::fields()[0].info.name));
          m.domain.variables.push_back({"turn_from_normal", 0, 1, Variable::Cut::middle});
          return m;
        }
      }
    } else if constexpr (WardForm<F>) {
      if (is_ward<WardKind::bounded>(form)) {
        EnergyMethod m{"opposite slopes beside one another",
                       {},
                       enclose_ward_bounded,
                       albedo_of_facets<F, WardBoundedCell>,
                       stretch_of<F>};
        m.domain.variables.push_back({"facet_cos2", 0, 1, Variable::Cut::middle});
        m.domain.variables.push_back({"facet_tilt", 0, 2, Variable::Cut::middle});
        return m;
      }
    } else if constexpr (CosineForm<F>) {
      if (auto found =
              cosine_lobe<PhongLobe>(form, "the lit cosine beside a lobe about the mirror direction"))
        return found;
      return cosine_lobe<BlinnLobe>(form, "caps of half vectors reflect most at normal incidence");
    } else if constexpr (FacetForm<F> && (kSchlick<F> || kIndexed<F> || kMetal<F>)) {
      for (const auto& found : {facets<F, GgxSmith>(form), facets<F, BeckmannSmith>(form),
                                facets<F, BeckmannCavities>(form), facets<F, GgxSchlick>(form)})
        if (found) return found;
    }
  } else if constexpr (F::template Weights<double>::fields().size() == 1 &&
                       F::template Shape<double>::fields().size() == 1) {
    if (gives_back(form)) {
      EnergyMethod m{"its integral in closed form", {}, enclose_given_back};
      for (const ParameterInfo& p :
           {F::template Weights<double>::fields()[0].info, F::template Shape<double>::fields()[0].info})
        add(m.domain, p, std::string(p.name));
      m.domain.variables.push_back({"turn_from_normal", 0, 1, Variable::Cut::middle});
      return m;
    }
  }
  return std::nullopt;
}

}  // namespace

const EnergyMethod* energy_method(int place) {
  return recorded_method<EnergyMethod>(place, [](auto form) { return method_of(form); });
}

}  // namespace brdf::prove
