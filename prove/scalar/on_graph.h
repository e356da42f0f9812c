// Records the formula of a form for both orders of the directions, as one graph.
#pragma once

#include "brdf/form.h"
#include "prove/scalar/swapped.h"

namespace brdf::prove {

// Records both orders in every case of the comparisons; stops after `most` cases.
template <Form F>
Swapped record(F form, Rules rules, long most) {
  using Weights = typename F::template Weights<Recorded>;
  Swapped result;
  Graph graph(rules);
  const Graph::Scope scope(graph);
  const auto [wi, wo] = RecordedDirections();
  const auto shape = recorded_parameters<typename F::template Shape<Recorded>>();
  const auto weights = recorded_parameters<Weights>();
  do {
    // In a listing that mixes channels, the weights of the first channel are the channel's own. For other
    // weights the listing is not reciprocal in any sense.
    const Recorded there = eval(form, weights, weights, shape, geometry(wi, wo));
    const Recorded back = eval(form, weights, weights, shape, geometry(wo, wi));
    ++result.cases;
    result.same = there == back;
  } while (result.same && result.cases < most && graph.next_case());
  if (result.cases >= most) result.same = false;
  result.nodes = long(graph.nodes());
  return result;
}

}  // namespace brdf::prove
