// Whether a form is written as an authored formula is: both recorded into one graph.
#pragma once

#include <array>

#include "brdf/forms.h"
#include "prove/scalar/graph.h"
#include "prove/scalar/ward_energy.h"

namespace brdf::prove {

template <class P>
P recorded() {
  P p{};
  for (const auto& field : P::fields()) p.*(field.member) = Recorded::input(field.info.name);
  return p;
}

// Whether `same` holds of recorded geometry in every case of its comparisons.
template <class Same>
bool holds_in_every_case(const Same& same) {
  Graph graph;
  const Graph::Scope scope(graph);
  const Vec3<Recorded> wi{Recorded::input(".ix"), Recorded::input(".iy"), Recorded::input(".iz")},
      wo{Recorded::input(".ox"), Recorded::input(".oy"), Recorded::input(".oz")};
  long cases = 0;
  do {
    if (!same(geometry(wi, wo))) return false;
  } while (++cases < 1000 && graph.next_case());
  return cases < 1000;
}

// Whether the form's lobes are those that `author` writes.
template <class F, class Author>
bool is_written_as(F, const Author& author) {
  return holds_in_every_case([&](const auto& g) {
    const auto shape = recorded<typename F::template Shape<Recorded>>();
    return F::lobes(shape, g) == author(shape, g);
  });
}

// A diffuse term and one lobe of two widths.
template <class F>
concept WardForm =
    LinearForm<F> && std::is_same_v<typename F::template Weights<double>, LobeWeights<double>> &&
    std::is_same_v<typename F::template Shape<double>, Roughness<double>>;

template <WardKind kind, WardForm F>
bool is_ward(F form) {
  return is_written_as(form, [](const auto& shape, const auto& g) {
    return std::array{Recorded(1 / kPi), ward_lobe<kind>(shape, g)};
  });
}

}  // namespace brdf::prove
