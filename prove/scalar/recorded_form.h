// Decides whether a form is written as an authored formula, by recording both into one graph.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "brdf/forms.h"
#include "prove/scalar/graph.h"
#include "prove/scalar/ward_energy.h"

namespace brdf::prove {

// Returns whether `same` holds for recorded geometry in every case of its comparisons.
template <class Same>
bool holds_in_every_case(const Same& same) {
  Graph graph;
  const Graph::Scope scope(graph);
  const auto [wi, wo] = RecordedDirections();
  long cases = 0;
  do {
    if (!same(geometry(wi, wo))) return false;
  } while (++cases < 1000 && graph.next_case());
  return cases < 1000;
}

// Returns whether the form's lobes are the lobes that `author` writes.
template <class F, class Author>
bool is_written_as(F, const Author& author) {
  return holds_in_every_case([&](const auto& g) {
    const auto shape = recorded_parameters<typename F::template Shape<Recorded>>();
    return F::lobes(shape, g) == author(shape, g);
  });
}

// Returns the result of `method_of` for the form at that index of the catalogue; null if it has no value.
// All forms are recorded at the first call.
template <class Method, class MethodOf>
const Method* recorded_method(int place, MethodOf method_of) {
  static const auto methods = [&] {
    std::vector<std::optional<Method>> all;
    for_each_form([&](auto form) { all.push_back(method_of(form)); });
    return all;
  }();
  const auto& method = methods[std::size_t(place)];
  return method ? &*method : nullptr;
}

// A form with a diffuse term and one lobe of two roughnesses.
template <class F>
concept WardForm =
    LinearForm<F> && std::is_same_v<typename F::template Weights<double>, LobeWeights<double>> &&
    std::is_same_v<typename F::template Shape<double>, Roughness<double>>;

// Returns whether the form is written as Ward's lobe of this kind.
template <WardKind kind, WardForm F>
bool is_ward(F form) {
  return is_written_as(form, [](const auto& shape, const auto& g) {
    return std::array{Recorded(1 / kPi), ward_lobe<kind>(shape, g)};
  });
}

}  // namespace brdf::prove
