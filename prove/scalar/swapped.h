// Reciprocity from the formula itself.
#pragma once

#include "prove/scalar/graph.h"

namespace brdf::prove {

struct Swapped {
  bool same = false;  // f(wi, wo) and f(wo, wi) are one node in every case
  long cases = 0;     // of how the numbers that are compared stand to one another
  long nodes = 0;
};

// Records the form for both orders of the directions, under these rules. Gives up, not the same, after `most`
// cases.
Swapped record_both_orders(int form, Rules rules, long most = 20000);

}  // namespace brdf::prove
