// A highlight that the directions of a measurement would not show.
#pragma once

#include <optional>

#include "fit/model/data.h"

namespace brdf::fit {

// The width, as Ward's alpha, above which a highlight of weight 0.04 (what a dielectric reflects along its
// normal) would stand out of the samples; narrower ones may lie between them. None where the narrowest that
// is asked for, 1e-4, would be seen. Told from the directions and the values' sizes alone: for each of 14
// widths the standard error of a lobe's weight beside a multiple of the values, whose noise is in proportion
// to them (`scatter`, relative; 0.05 where it is not known).
std::optional<double> hidden_width(const FitData& data, std::optional<double> scatter);

}  // namespace brdf::fit
