#include "prove/scalar/swapped.h"

#include "brdf/forms.h"
#include "prove/scalar/on_graph.h"

namespace brdf::prove {
Swapped record_both_orders(int place, Rules rules, long most) {
  Swapped result;
  with_form(place, [&](auto form) { result = record(form, rules, most); });
  return result;
}

}  // namespace brdf::prove
