// The samples of a fit: the table that is fitted, and the data sheet of the table as it was read.
#pragma once

#include "fit/model/options.h"
#include "io/samples/samples.h"
#include "sheet/data_sheet.h"

namespace brdf::fit {

struct Samples {
  io::SampleTable table;
  sheet::DataSheet sheet;
  std::shared_ptr<const io::Budget> budget;  // of the options, or the one that the table names; may be null
};

// Makes the data sheet of the table as it was read, then prepares the table for a fit. Rows that hold a
// fill value are removed unless the options keep them. Polarisations and repeats are arranged, and the
// scale is divided out, according to the options. Each change is listed in the warnings of the table.
// Reads the budget that a comment of the table names, unless the options have one. Throws InputError under
// the conditions of io::arrange, io::make_relative and io::stated_budget.
Samples arranged(io::SampleTable read, const FitOptions& options);

}  // namespace brdf::fit
