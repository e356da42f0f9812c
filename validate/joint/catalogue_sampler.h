// The sampler of a form of the catalogue, as an outside sampler is judged.
#pragma once

#include <memory>

#include "brdf/direction_sampler.h"
#include "brdf/reflectance.h"

namespace brdf::validate {

// Returns the form's sampler, a mixture with equal shares of its lobe and the cosine, in double precision.
std::shared_ptr<const DirectionSampler> catalogue_sampler(const Reflectance& form);

}  // namespace brdf::validate
