// The uncertainty budget of a fit in words, JSON and on a page.
#pragma once

#include <string>
#include <vector>

#include "fit/assess/result.h"
#include "io/files/json.h"
#include "io/page/html_report.h"
#include "io/samples/samples.h"

namespace brdf::fit {

// The limit of every interval without a budget.
inline constexpr const char* kScatterOnly =
    "scatter only: a common scale or angle error is not in it (--budget FILE adds it)";

// Returns whether some parameter of the fit has an interval; too few rows give none.
bool has_intervals(const FormFit& fit);
// Returns the sentence that states which errors the intervals of a fit contain.
std::string scope_of_intervals(const FormFit& fit);
// Returns the budget of the rows and the combined standard uncertainty of every parameter, with its largest
// parts, one line each. Empty without a budget.
std::vector<std::string> budget_in_words(const FormFit& fit);

// Returns "standard uncertainty of kd: 0.0026 (0.64 %); shares of the variance: reference_standard 61 %".
std::string uncertainty_text(const std::string& name, double value, const Combined& uncertainty);

// A value that follows from the parameters, with its standard uncertainty.
struct DerivedUncertainty {
  std::string quantity;  // "albedo at 8 degrees"
  std::string channel;
  double value;
  Combined uncertainty;
};
// Returns the albedo at 8 degrees and f at 0:45, for every channel. Empty without a budget, or if the
// covariance of the parameters is not known.
std::vector<DerivedUncertainty> derived_uncertainties(const FormFit& fit);

// Returns the sources of the budget, the standard uncertainties of derived quantities and, with `table`, the
// sensitivities and the combined relative standard uncertainty of every row, up to 10,000 values. Null
// without a budget.
io::Json budget_json(const FormFit& fit, const io::SampleTable* table);

// Adds the budget to a page: its sources, and the parts of the uncertainty of each parameter and of the rows.
// Adds nothing without a budget.
void add_budget(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table);

}  // namespace brdf::fit
