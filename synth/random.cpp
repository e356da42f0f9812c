#include "synth/random.h"

#include <cmath>

#include "brdf/math.h"
#include "brdf/random.h"
#include "io/samples/degrees.h"

namespace brdf::synth {

NormalPairs::Pair NormalPairs::next() {
  const auto uniform = [this] { return uniform01(bits_) + 0x1p-54; };  // shifted by half a step: never 0
  const double radius = std::sqrt(-2.0 * math::log(uniform()));
  const double degrees = 360.0 * uniform();
  return {radius * io::cos_degrees(degrees), radius * io::sin_degrees(degrees)};
}

}  // namespace brdf::synth
