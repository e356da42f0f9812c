// The samples of a fit: a table as it is fitted, and what its data sheet says of it as it was read.
#pragma once

#include "fit/model/options.h"
#include "io/samples/samples.h"
#include "sheet/data_sheet.h"

namespace brdf::fit {

struct Samples {
  io::SampleTable table;
  sheet::DataSheet sheet;
};

// The sheet is made of the table as it was read. Rows that hold a fill value are then left out, unless the
// options keep them, and polarisations and repeats are arranged and the scale divided out as the options ask.
// What was done stands in the table's warnings. Throws InputError as io::arrange and io::make_relative do.
Samples arranged(io::SampleTable read, const FitOptions& options);

}  // namespace brdf::fit
