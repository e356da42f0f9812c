// Integrals over the samples of a scan.
#pragma once

#include <optional>
#include <vector>

#include "sheet/data_sheet.h"
#include "sheet/view.h"

namespace brdf::sheet {

// Integrates up to 60 scans, chosen evenly. `scatter`: relative noise of one value, taken as 10 % if
// unknown. Half of the noise is added to the bound, since noise that the samples have in common does not
// average out.
std::vector<MeasuredAlbedo> albedos(const View& view, std::optional<double> scatter);

}  // namespace brdf::sheet
