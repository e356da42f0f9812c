// Proves reciprocity from the formula itself.
#pragma once

#include "prove/scalar/graph.h"

namespace brdf::prove {

struct Swapped {
  bool same = false;  // f(wi, wo) and f(wo, wi) are one node in every case
  long cases = 0;     // combinations of the orders of the numbers that are compared
  long nodes = 0;
};

// Records the form for both orders of the directions, under these rules. After `most` cases the recording
// stops and `same` is false.
Swapped record_both_orders(int form, Rules rules, long most = 20000);

}  // namespace brdf::prove
