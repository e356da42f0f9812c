// Pairs of directions that see a lobe: around it at its own widths, and evenly over the hemisphere.
#pragma once

#include "interop/wanted.h"
#include "io/samples.h"

namespace brdf::interop {

// Two sets that share no direction: what is fitted to and what the loss is measured on.
enum class Pairs { fitted, judged };

// Rows of directions up to 80 degrees from the normal, without values.
io::SampleTable pairs_about(const Wanted& wanted, Pairs which);

}  // namespace brdf::interop
