#include "prove/energy/energy.h"

#include <array>

#include "prove/energy/albedo_of_facets.h"
#include "prove/energy/majorants.h"
#include "prove/scalar/cosine_lobes.h"
#include "prove/scalar/matt_box.h"
#include "prove/scalar/on_box.h"
#include "prove/scalar/recorded_form.h"

namespace brdf::prove {
namespace {

using I = Interval<double>;

template <class F>
concept FacetForm = LinearForm<F> && (lobe_count<F> > 1) && requires(typename F::template Shape<double> s) {
  { s.alpha_x } -> std::convertible_to<double>;
};

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

template <class F, class Majorant>
std::optional<EnergyMethod> facets(F form) {
  if (!has_majorant<F, Majorant>(form)) return std::nullopt;
  EnergyMethod m;
  m.why = "F G2/G1 weighted by the density of visible normals";
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
  if constexpr (requires { typename Majorant::template Cell<EqualWidths>; }) {
    m.albedo = albedo_of_facets<F, Majorant::template Cell>;
    m.stretch = stretch_of<F>;
  }
  return m;
}

template <class F>
std::optional<EnergyMethod> student(F form) {
  const bool its = is_written_as(form, [](const auto& shape, const auto& g) {
    using R = Recorded;
    const Roughness<R> a = shape.ggx();
    const StudentMasking<R> masking(shape.gamma);
    const Fraction<R> v{R(0.5), g.cos_o * masking.length(a, g.wi) + g.cos_i * masking.length(a, g.wo)};
    const R lobe = quotient(d_ggx(a, g), v) * student_over_ggx(shape.gamma, a, g);
    return std::array{R(1 / kPi), lobe, lobe * schlick(g)};
  });
  if (!its) return std::nullopt;
  EnergyMethod m;
  m.albedo = albedo_of_student<F>;
  m.stretch = stretch_of_student<F>;
  return m;
}

// A form with a diffuse term and one lobe about a direction.
template <class F>
concept CosineForm =
    LinearForm<F> && std::is_same_v<typename F::template Weights<double>, LobeWeights<double>> &&
    std::is_same_v<typename F::template Shape<double>, Exponent<double>>;

template <class Lobe>
Bounds enclose_cosine_lobe(std::span<const Bounds>) {
  const I r = Lobe::template normalisation<I>();
  return {r.lo, r.hi};
}

// An albedo in closed form: its whole width is due to the range of turns.
AlbedoBounds of_turns(const I& albedo) {
  return {{albedo.lo, albedo.hi}, {albedo.hi - albedo.lo, 0}};
}

template <class F, class Lobe>
std::optional<AlbedoBounds> albedo_of_cosine_lobe(std::span<const Bounds>, std::span<const Bounds> weights,
                                                  const Views& views, double) {
  I cosine, sine;
  circle(views.turn, cosine, sine);
  const auto w = lobe_weights<F>(weights);
  const I lobe = views.turn.hi == 0 ? I(1) : Lobe::albedo(cosine);
  const I all =
      w[0] * I::of(kPiBounds.lo, kPiBounds.hi) * I(1 / kPi) + w[1] * lobe * Lobe::template normalisation<I>();
  return of_turns(all);
}

template <class Lobe, class F>
std::optional<EnergyMethod> cosine_lobe(F form, const char* why) {
  const bool its = is_written_as(form, [](const auto& shape, const auto& g) {
    return std::array{Recorded(1 / kPi), Lobe::lobe(shape.exponent, g)};
  });
  if (!its) return std::nullopt;
  return EnergyMethod{why, {}, enclose_cosine_lobe<Lobe>, albedo_of_cosine_lobe<F, Lobe>};
}

// Returns pi f of a constant f.
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
std::optional<AlbedoBounds> albedo_of_one_lobe(std::span<const Bounds> shape, std::span<const Bounds> weights,
                                               const Views& views, double) {
  Bounds lobe{};
  if (shape.empty()) {
    lobe = enclose_constant({});
  } else {
    const std::array box{shape[0], views.turn};
    lobe = enclose_rough(box);
  }
  const I all = lobe_weights<F>(weights)[0] * I::of(lobe.lo, lobe.hi);
  return of_turns(all);
}

// Bounds the albedo of the energy-preserving diffuse form. The box has rho, r and the turn.
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

// Bounds the mean of ward_bounded. The box has 1/s and the tilt, which represents u: see ward_bounded_mean.
Bounds enclose_ward_bounded(std::span<const Bounds> box) {
  const I tilt = I::of(box[1].lo, box[1].hi);
  const I beyond = at_least(smaller(I(2) - tilt, I(1)), I());
  const I r = ward_bounded_mean(I::of(box[0].lo, box[0].hi), smaller(tilt, I(1)), beyond);
  return {r.lo, r.hi};
}

// A lobe about the direction of the light. Half a turn of the view about the normal maps the hemisphere to
// itself and keeps cosines and solid angles, so that the reasons and the albedo of the lobe hold unchanged.
template <class F, class Majorant>
std::optional<EnergyMethod> retroreflective(F form) {
  const bool its = is_written_as(form, [](const auto& shape, const auto& g) {
    return std::array{Majorant::lobe(shape, turned_back(g))};
  });
  if (!its) return std::nullopt;
  EnergyMethod m;
  m.why = "G2/G1 weighted by the density of visible normals, with the view turned";
  for (const auto& field : F::template Shape<double>::fields())
    add(m.domain, field.info, std::string(field.info.name));
  add_directions(m.domain);
  m.enclose = enclose_facets<F, Majorant>;
  m.albedo = [](std::span<const Bounds> shape, std::span<const Bounds> weights, const Views& views,
                double accuracy) -> std::optional<AlbedoBounds> {
    std::size_t at = 0;
    const auto s = parameters_from<typename F::template Shape<Exactly>, Exactly>(shape, at);
    const std::array w{Exactly(0), lobe_weights<F>(weights)[0]};
    const auto cells = []<class W>(const W&) {
      return [](const FacetView& view) { return typename Majorant::template Cell<W>(view); };
    };
    return albedo_with<F>(s, square(s.alpha_x), square(s.alpha_y), w, cells, w[1], views, accuracy);
  };
  m.stretch = stretch_of<F>;
  return m;
}

// Returns the sum of the albedos of a matt basis over the views, from Bernstein's coefficients in 1 - cos.
template <class F>
std::optional<AlbedoBounds> albedo_of_matt(std::span<const Bounds>, std::span<const Bounds> weights,
                                           const Views& views, double) {
  I cosine, sine;
  circle(views.turn, cosine, sine);
  const auto w = lobe_weights<F>(weights);
  // A polynomial of x = 1 - cos: at most of degree 2, because the order is at most 5. Its coefficients follow
  // from its values at 0, 1/2 and 1, which are exact for each function.
  I c0(0), c1(0), c2(0);
  for (std::size_t k = 0; k < w.size(); ++k) {
    const auto at = [&](double x) { return matt_albedo(F::basis.indices[k], I(x)); };
    const I start = at(0), middle = at(0.5), end = at(1);
    c0 = c0 + w[k] * start;
    c1 = c1 + w[k] * (I(4) * middle - I(3) * start - end);
    c2 = c2 + w[k] * (I(2) * start - I(4) * middle + I(2) * end);
  }
  const double low = std::clamp(1 - cosine.hi, 0.0, 1.0), high = std::clamp(1 - cosine.lo, 0.0, 1.0);
  const I a = I::widened(low, low), b = I::widened(high, high);
  const I first = c0 + a * (c1 + a * c2), last = c0 + b * (c1 + b * c2),
          between = c0 + I(0.5) * (a + b) * c1 + a * b * c2;
  const I all = hull(hull(first, last), between) * I::of(kPiBounds.lo, kPiBounds.hi) * I(1 / kPi);
  return of_turns(all);
}

template <class F>
std::optional<EnergyMethod> matt(F form) {
  const bool its =
      is_written_as(form, [](const auto&, const auto& g) { return matt_lobes<F::basis.order, Recorded>(g); });
  if (!its) return std::nullopt;
  EnergyMethod m;
  m.albedo = albedo_of_matt<F>;
  return m;
}

template <Form F>
std::optional<EnergyMethod> method_of(F form) {
  if constexpr (LinearForm<F>) {
    using Shape = typename F::template Shape<double>;
    if constexpr (MattForm<F>) {
      return matt(form);
    } else if constexpr (requires { F::about_light; } && std::is_same_v<Shape, Roughness<double>>) {
      for (const auto& found : {retroreflective<F, GgxSmith>(form), retroreflective<F, BeckmannSmith>(form)})
        if (found) return found;
    } else if constexpr (lobe_count<F> == 1) {
      if (is_written_as(form, [](const auto&, const auto&) { return std::array{Recorded(1 / kPi)}; }))
        return EnergyMethod{"f is constant", {}, enclose_constant, albedo_of_one_lobe<F>};
      if constexpr (std::is_same_v<Shape, SlopeDeviation<double>>) {
        if (is_written_as(
                form, [](const auto& s, const auto& g) { return std::array{oren_nayar_lobe(s.sigma, g)}; })) {
          EnergyMethod m{"the integral has a closed form", {}, enclose_rough, albedo_of_one_lobe<F>};
          add(m.domain, Shape::fields()[0].info, std::string(Shape::fields()[0].info.name));
          m.domain.variables.push_back({"turn_from_normal", 0, 1, Variable::Cut::middle});
          return m;
        }
      }
    } else if constexpr (WardForm<F>) {
      if (is_ward<WardKind::bounded>(form)) {
        EnergyMethod m{"opposite slopes are paired",
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
              cosine_lobe<PhongLobe>(form, "the cosine is weighted by a lobe about the mirror direction"))
        return found;
      return cosine_lobe<BlinnLobe>(form, "caps of half vectors reflect most at normal incidence");
    } else if constexpr (std::is_same_v<Shape, StudentRoughness<double>>) {
      return student(form);
    } else if constexpr (FacetForm<F> && (kSchlick<F> || kIndexed<F> || kMetal<F>)) {
      for (const auto& found : {facets<F, GgxSmith>(form), facets<F, BeckmannSmith>(form),
                                facets<F, BeckmannCavities>(form), facets<F, GgxSchlick>(form)})
        if (found) return found;
    }
  } else if constexpr (F::template Weights<double>::fields().size() == 1 &&
                       F::template Shape<double>::fields().size() == 1) {
    if (gives_back(form)) {
      EnergyMethod m{"the integral has a closed form", {}, enclose_given_back};
      for (const ParameterInfo& p :
           {F::template Weights<double>::fields()[0].info, F::template Shape<double>::fields()[0].info})
        add(m.domain, p, std::string(p.name));
      m.domain.variables.push_back({"turn_from_normal", 0, 1, Variable::Cut::middle});
      return m;
    }
  }
  return std::nullopt;
}

const EnergyMethod* method_at(int place) {
  return recorded_method<EnergyMethod>(place, [](auto form) { return method_of(form); });
}

}  // namespace

const EnergyMethod* energy_method(int place) {
  const EnergyMethod* method = method_at(place);
  return method != nullptr && method->enclose != nullptr ? method : nullptr;
}

const EnergyMethod* albedo_method(int place) {
  const EnergyMethod* method = method_at(place);
  return method != nullptr && method->albedo != nullptr ? method : nullptr;
}

}  // namespace brdf::prove
