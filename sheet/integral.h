// Integrals over the samples of a scan.
#pragma once

#include <optional>
#include <vector>

#include "sheet/data_sheet.h"
#include "sheet/view.h"

namespace brdf::sheet {

// Of up to 60 scans, evenly chosen. `scatter`: relative, of one value; half of it is added to the bound,
// since noise that is common to the samples does not average out.
std::vector<MeasuredAlbedo> albedos(const View& view, std::optional<double> scatter);

}  // namespace brdf::sheet
