// Reports of a round robin: a table for the terminal, JSON, and a page.
#pragma once

#include <iosfwd>
#include <string>

#include "fit/between/round_robin.h"
#include "io/files/json.h"

namespace brdf::fit {

// Returns the sentence on the uncertainties of the laboratories: they contain the budgets, or scatter alone.
std::string about_budgets(const RoundRobin& result);
// Returns the sentence on the error of the form, and the table that the form describes only roughly.
std::string about_form(const RoundRobin& result);
// Returns "f(0:45): consensus 0.1351 (0.1338 to 0.1364), standard uncertainty 0.385 %, ..." or the reason why
// there is no consensus.
std::string in_words(const RoundRobinQuantity& quantity);
// Returns whether the laboratories differ by more than their uncertainties, as a sentence.
std::string spread_in_words(const RoundRobinQuantity& quantity);

// Prints every quantity with the degrees of equivalence.
void print(std::ostream& out, const RoundRobin& result);
// Returns the JSON of `brdf consensus --json`.
io::Json to_json(const RoundRobin& result);
// Returns a self-contained page: for each quantity a plot of the values with the consensus and its interval,
// and the degrees of equivalence.
std::string html_page(const RoundRobin& result);

}  // namespace brdf::fit
