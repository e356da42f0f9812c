#include "prove/growth_proof.h"

#include "prove/energy/growth.h"

namespace brdf::prove {
namespace {

constexpr double kGap = 0.08;  // relative, above the value that is reached

}  // namespace

std::optional<Growth> growth_of(int form, const SearchOptions& search) {
  const GrowthMethod* method = growth_method(form);
  if (method == nullptr) return std::nullopt;
  Reached best{0, 0};
  double width_of_best = 0;
  const Variable& width = method->domain.variables[0];
  for (int k = 1; k <= 16; ++k) {
    const double at = width.high * k / 16;
    const Reached here = reached_at(*method, at);
    if (here.least > best.least) best = here, width_of_best = at;
  }
  const Cover found = cover(
      method->domain, method->most, [&](Bounds b) { return b.hi <= best.most * (1 + kGap); }, search);
  if (found.open > 0) return std::nullopt;
  return Growth{method->power, method->from, best.least, found.range.hi, width_of_best, found};
}

}  // namespace brdf::prove
