#include "synth/random.h"

#include <cmath>

#include "brdf/math.h"
#include "io/samples.h"

namespace brdf::synth {

NormalPairs::Pair NormalPairs::next() {
  // 53 bits, moved by half a step: never 0
  const auto uniform = [this] { return (static_cast<double>(bits_() >> 11) + 0.5) * 0x1p-53; };
  const double radius = std::sqrt(-2.0 * math::log(uniform()));
  const double degrees = 360.0 * uniform();
  return {radius * io::cos_degrees(degrees), radius * io::sin_degrees(degrees)};
}

}  // namespace brdf::synth
