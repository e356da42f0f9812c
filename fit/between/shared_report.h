// Parts that the reports on several tables share.
#pragma once

#include <string>

#include "fit/between/tables.h"
#include "io/files/json.h"
#include "io/page/html_report.h"

namespace brdf::fit {

// Returns an uncertainty or a difference: in per cent if the quantity is logarithmic.
std::string amount_text(double amount, bool logarithmic, int digits = 3);
// Returns the same with a sign: "+0.93 %", "-1.39 %".
std::string signed_amount_text(double amount, bool logarithmic, int digits = 3);

// Returns a probability: "0.14", "2.7e-12", or "below 1e-99".
std::string probability_text(double p);

// Returns "cook_torrance, residual log_relative (chosen by 6 of 6 tables)".
std::string form_and_metric(const FittedTables& fits);
// Returns {"form", "metric", "channels", "budget", "tables": [{"samples", "rows", "verdict", "findings"}]}.
io::Json fits_json(const FittedTables& fits);
// Adds the form, the metric, and a table of the fits.
void add_fits(io::HtmlReport& page, const FittedTables& fits);

}  // namespace brdf::fit
