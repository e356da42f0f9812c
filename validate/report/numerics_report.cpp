#include <cmath>
#include <cstdio>
#include <ostream>

#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/parallel.h"
#include "validate/numerics/numerics.h"

namespace brdf::validate {
namespace {

io::Json json_of(const Vec3<double>& w) {
  return {w.x, w.y, w.z};
}
io::Json json_of(const NumericsRow& row) {
  return {{"form", row.form},
          {"scalar", row.scalar},
          {"max_error", row.errors.body},
          {"where",
           {{"set", row.where.parameters}, {"wi", json_of(row.where.wi)}, {"wo", json_of(row.where.wo)}}},
          {"faint_error", row.errors.faint},
          {"tail_error", row.errors.tail},
          {"count", row.count},
          {"as_stored", row.as_stored},
          {"nan", row.nan},
          {"inf", row.inf},
          {"negative", row.negative},
          {"within_budget", meets_budget(row)},
          {"within_statement", meets_statement(row)}};
}

// "60,17.2": polar angle and azimuth in degrees.
std::string angles_of(const Vec3<double>& w) {
  const Angle theta = radians(std::atan2(std::hypot(w.x, w.y), w.z)), phi = radians(std::atan2(w.y, w.x));
  return io::short_number(theta.degrees()) + "," + io::short_number(phi.degrees());
}

std::string line_of(const NumericsRow& row) {
  char text[160];
  std::snprintf(text, sizeof text, "%-26s %-6s  %8.1e  %8.1e  %8.1e  %7zu  %3zu  %3zu  %8zu  %-11s  ",
                row.form.c_str(), row.scalar.c_str(), row.errors.body, row.errors.faint, row.errors.tail,
                row.count, row.nan, row.inf, row.negative,
                !meets_budget(row)     ? "over budget"
                : meets_statement(row) ? "ok"
                                       : "over stated");
  return text + row.where.parameters + "  " + angles_of(row.where.wi) + " -> " + angles_of(row.where.wo) +
         "\n";
}

}  // namespace

bool report_numerics(const std::vector<Reflectance>& forms, const NumericsOptions& options, bool json,
                     std::ostream& out, const std::function<void(int done, int total)>& progress) {
  io::Json all = io::Json::array();
  std::vector<std::string> unmeasured;
  auto form = forms.begin();
  int over = 0;
  const auto report = [&](const NumericsRow& row) {
    over += !meets_budget(row) || !meets_statement(row);
    if (json)
      all.push_back(json_of(row));
    else
      out << line_of(row) << std::flush;
  };
  if (!json)
    out << "form                       scalar      body     faint      tail   values  nan  inf  negative  "
           "budget       where the body is worst: parameters, light -> view in degrees\n";
  io::parallel_in_order(
      int(forms.size()), int(io::all_processors()), progress,
      [&](int k) { return measure_numerics(forms[std::size_t(k)], options); },
      [&](const std::vector<NumericsRow>& rows) {
        for (const NumericsRow& row : rows) report(row);
        if (rows.empty()) unmeasured.emplace_back(form->info().name);
        ++form;
      });
  if (json) {
    io::Json document{{"rows", all}, {"provenance", io::to_json(io::provenance())}};
    if (!unmeasured.empty()) document["not_applicable"] = unmeasured;
    out << io::to_text(document) << '\n';
    return over == 0;
  }
  const Accuracy::Errors f = numerics_budget("float"), d = numerics_budget("double");
  char budgets[160];
  std::snprintf(budgets, sizeof budgets, "%-33s  %8.1e  %8.1e  %8.1e\n%-33s  %8.1e  %8.1e  %8.1e\n",
                "budget in float", f.body, f.faint, f.tail, "budget in double", d.body, d.faint, d.tail);
  for (const std::string& name : unmeasured)
    out << name
        << ": not applicable, because the form is not in the catalogue and has no 50-digit evaluation\n";
  out << budgets
      << "Largest errors found by search, against 50 digits (float: against double), for f of at least 1e-6 "
         "(body), 1e-12 (faint), 1e-30 (tail) of the lobe's peak. "
      << (over == 0 ? "All rows are within the budget and the errors stated in the forms' headers."
                    : io::plural(over, "row") + " above a limit.")
      << '\n';
  return over == 0;
}

}  // namespace brdf::validate
