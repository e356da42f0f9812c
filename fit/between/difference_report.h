// Reports of the difference between two tables: text for the terminal, JSON, and a page.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "fit/between/explanations.h"
#include "io/files/json.h"

namespace brdf::fit {

// Returns the answer in one sentence: "no difference beyond the budgets ...", "different beyond the budgets:
// alpha ...", "cannot be told: ..." or "undecided: ...".
std::string answer(const Difference& difference);
// Returns whether f differs beyond the budgets in the plane of incidence, and at which directions. Empty
// without budgets, and if there is an obstacle.
std::string directions_in_words(const Difference& difference);
// Returns the number of measured values at the same directions that differ beyond the budgets. Empty if such
// values were not compared.
std::string values_in_words(const Difference& difference);
// Returns "explained by a scale error of +0.9 % in b.csv", or "not explained by ... alone" with the size that
// leaves the least.
std::string in_words(const Explanation& explanation);

// Prints the answer, the parameters, the directions and the explanations.
void print(std::ostream& out, const Comparison& comparison);
// Returns the JSON of `brdf compare --json`. Without budgets it has no probability.
io::Json to_json(const Comparison& comparison);
// Returns a self-contained page: the answer, the difference of the fitted values with its band, and the
// measured values of both tables.
std::string html_page(const Comparison& comparison, const std::vector<TableToFit>& tables);

}  // namespace brdf::fit
