#include <cstdio>
#include <ostream>

#include "io/json.h"
#include "validate/numerics.h"

namespace brdf::validate {
namespace {

io::Json json_of(const NumericsRow& row) {
  return {{"form", row.form},   {"scalar", row.scalar},           {"max_error", row.max_error},
          {"where", row.where}, {"faint_error", row.faint_error}, {"tail_error", row.tail_error},
          {"count", row.count}, {"as_stored", row.as_stored},     {"nan", row.nan},
          {"inf", row.inf},     {"negative", row.negative},       {"within_budget", meets_budget(row)}};
}

std::string line_of(const NumericsRow& row) {
  char text[160];
  std::snprintf(text, sizeof text, "%-26s %-6s  %8.1e  %8.1e  %8.1e  %7zu  %3zu  %3zu  %8zu  %s\n",
                row.form.c_str(), row.scalar.c_str(), row.max_error, row.faint_error, row.tail_error,
                row.count, row.nan, row.inf, row.negative, meets_budget(row) ? "ok" : "over budget");
  return text;
}

}  // namespace

bool report_numerics(const std::vector<AnyForm>& forms, bool json, std::ostream& out) {
  bool all_good = true;
  io::Json rows = io::Json::array();
  if (!json)
    out << "form                       scalar     body     faint      tail   values  nan  inf  negative\n";
  for (const AnyForm& form : forms)
    for (const NumericsRow& row : measure_numerics(form)) {
      all_good &= meets_budget(row);
      if (json)
        rows.push_back(json_of(row));
      else
        out << line_of(row) << std::flush;
    }
  if (json)
    out << io::to_text(io::Json{{"rows", rows}}) << '\n';
  else
    out << "Errors relative to 50 digits where f is at least 1e-6, 1e-12 and 1e-30 of the lobe's peak; "
           "budgets 5e-6, "
           "1e-5, 5e-5 (float) and 1e-14, 2e-14, 5e-14 (double).\n";
  return all_good;
}

}  // namespace brdf::validate
