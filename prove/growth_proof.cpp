#include "prove/growth_proof.h"

#include <algorithm>
#include <array>

#include "prove/scalar/growth.h"

namespace brdf::prove {
namespace {

constexpr double kGap = 0.08;  // relative, above what is reached
constexpr int kParts = 8;      // of the cosines

struct Reached {
  double least, most;  // over the cosines
};

Reached reached_at(const GrowthMethod& method, double width) {
  const double far = method.domain.variables[1].high;
  Reached found{1e300, 0};
  for (int k = 0; k < kParts; ++k) {
    const std::array box{Bounds{width, width}, Bounds{far * k / kParts, far * (k + 1) / kParts}};
    const double low = method.reached(box).lo;
    found = {std::min(found.least, low), std::max(found.most, low)};
  }
  return found;
}

}  // namespace

std::optional<Growth> growth_of(int form, const SearchOptions& search) {
  const GrowthMethod* method = growth_method(form);
  if (method == nullptr) return std::nullopt;
  Reached best{0, 0};
  const Variable& width = method->domain.variables[0];
  for (int k = 1; k <= 16; ++k) {
    const Reached here = reached_at(*method, width.high * k / 16);
    if (here.least > best.least) best = here;
  }
  const Cover found = cover(
      method->domain, method->most, [&](Bounds b) { return b.hi <= best.most * (1 + kGap); }, search);
  if (found.open > 0) return std::nullopt;
  return Growth{method->power, method->from, best.least, found.range.hi};
}

}  // namespace brdf::prove
