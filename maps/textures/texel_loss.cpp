#include "maps/textures/texel_loss.h"

#include "brdf/frame.h"
#include "interop/loss.h"
#include "interop/pairs.h"

namespace brdf::maps {

TexelComparison::TexelComparison(const Material& wanted)
    : pairs_(io::unit_directions(interop::pairs_about(wanted, interop::Pairs::judged))),
      values_(interop::values_at(wanted, pairs_.view())) {}

TexelComparison::Figures TexelComparison::figures_of(const Material& carried,
                                                     const Vec3<double>& normal) const {
  const Directions<double> pairs = pairs_.view();
  DirectionArrays<double> turned(pairs.count);
  for (std::size_t k = 0; k < pairs.count; ++k)
    turned.set(k, in_frame_of(normal, pairs.wi(k)), in_frame_of(normal, pairs.wo(k)));
  const interop::Figures figures =
      interop::figures_of(values_, interop::values_at(carried, turned.view()), pairs);
  return {figures.rms, figures.largest};
}

}  // namespace brdf::maps
