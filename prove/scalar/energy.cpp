#include "prove/scalar/energy.h"

#include <array>

#include "prove/scalar/graph.h"
#include "prove/scalar/majorants.h"
#include "prove/scalar/on_box.h"

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

template <class T>
Roughness<T> widths_of(const Roughness<T>& shape) {
  return shape;
}
template <class Shape>
auto widths_of(const Shape& shape) {
  return Roughness<decltype(shape.alpha_x)>{shape.alpha_x, shape.alpha_y};
}

template <class P>
P recorded() {
  P p{};
  for (const auto& field : P::fields()) p.*(field.member) = Recorded::input(field.info.name);
  return p;
}

// Whether the form's lobes are those that `author` writes, in every case of its comparisons.
template <class F, class Author>
bool is_written_as(F, const Author& author) {
  Graph graph;
  const Graph::Scope scope(graph);
  const Vec3<Recorded> wi{Recorded::input(".ix"), Recorded::input(".iy"), Recorded::input(".iz")},
      wo{Recorded::input(".ox"), Recorded::input(".oy"), Recorded::input(".oz")};
  const auto shape = recorded<typename F::template Shape<Recorded>>();
  long cases = 0;
  do {
    const auto g = geometry(wi, wo);
    if (!(F::lobes(shape, g) == author(shape, g))) return false;
  } while (++cases < 1000 && graph.next_case());
  return cases < 1000;
}

template <class F, class Majorant>
bool has_majorant(F form) {
  return is_written_as(form, [](const auto& shape, const auto& g) {
    using R = Recorded;
    const R lobe = Majorant::lobe(widths_of(shape), g);
    if constexpr (kSchlick<F>)
      return std::array{R(1 / kPi), lobe, lobe * schlick(g)};
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
      return dielectric_fresnel<I>();
  }();
  const I r = fresnel * Majorant::ratio(widths, g);
  return {r.lo, r.hi};
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
  return m;
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

template <Form F>
std::optional<EnergyMethod> method_of(F form) {
  if constexpr (LinearForm<F>) {
    if constexpr (lobe_count<F> == 1) {
      using Shape = typename F::template Shape<double>;
      if (is_written_as(form, [](const auto&, const auto&) { return std::array{Recorded(1 / kPi)}; }))
        return EnergyMethod{"f is constant", {}, enclose_constant};
      if constexpr (std::is_same_v<Shape, SlopeDeviation<double>>) {
        if (is_written_as(
                form, [](const auto& s, const auto& g) { return std::array{oren_nayar_lobe(s.sigma, g)}; })) {
          EnergyMethod m{"its integral in closed form", {}, enclose_rough};
          add(m.domain, Shape::fields()[0].info, std::string(Shape::fields()[0].info.name));
          m.domain.variables.push_back({"turn_from_normal", 0, 1, Variable::Cut::middle});
          return m;
        }
      }
    } else if constexpr (FacetForm<F> && (kSchlick<F> || kIndexed<F>)) {
      for (const auto& found : {facets<F, GgxSmith>(form), facets<F, BeckmannSmith>(form),
                                facets<F, BeckmannCavities>(form), facets<F, GgxSchlick>(form)})
        if (found) return found;
    }
  }
  return std::nullopt;
}

}  // namespace

const EnergyMethod* energy_method(int place) {
  static const auto methods = [] {
    std::vector<std::optional<EnergyMethod>> all;
    for_each_form([&](auto form) { all.push_back(method_of(form)); });
    return all;
  }();
  const auto& method = methods[std::size_t(place)];
  return method ? &*method : nullptr;
}

}  // namespace brdf::prove
