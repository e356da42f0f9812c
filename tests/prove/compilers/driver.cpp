// Prints the content of a certificate for every form, in hexadecimal: the domain and the cover of each
// property, and whether both orders of the directions give one formula. Uses only prove/scalar and the
// search, to build quickly with several compilers.
#include <cstdio>

#include "brdf/forms.h"
#include "prove/check/claim.h"
#include "prove/scalar/rounding.h"
#include "prove/scalar/swapped.h"
#include "prove/search.h"

namespace {

using namespace brdf::prove;

constexpr SearchOptions kSearch{60, 1e9};  // no time limit, so every machine makes the same boxes

void print(const Claim& claim) {
  std::printf("%d %d %d\n", claim.form, int(claim.property), int(claim.precision));
  const auto domain = domain_of(claim);
  if (!domain) return;
  for (const Variable& v : domain->variables) std::printf(" %s %a %a\n", v.name.c_str(), v.low, v.high);
  const double most = claim.property == Property::energy ? 1.02 : 0;
  const Cover found = cover(
      *domain, [&](const Box& box) { return enclose(claim, box); },
      [&](Bounds b) { return settles(claim.property, b, most); }, kSearch);
  for (const Cover::Node& n : found.nodes)
    std::printf(" %d %a %a %a %d\n", n.variable, n.cut, n.bounds.lo, n.bounds.hi, int(n.open));
}

}  // namespace

int main() {
  for (int form = 0; form < int(brdf::kFormCount); ++form) {
    for (const Rules rules : {Rules::bits, Rules::exact})
      std::printf("%d both orders %d\n", form, int(record_both_orders(form, rules).same));
    for (const Property property :
         {Property::finite, Property::non_negative, Property::rounding, Property::energy})
      for (const Precision precision : {Precision::float_type, Precision::double_type})
        if (is_of_a_precision(property) || precision == Precision::double_type)
          print({form, property, precision});
  }
}
