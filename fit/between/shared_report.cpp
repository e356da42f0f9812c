#include "fit/between/shared_report.h"

#include <cmath>

#include "fit/report/report.h"
#include "fit/report/states.h"
#include "io/files/numbers.h"

namespace brdf::fit {

std::string amount_text(double amount, bool logarithmic, int digits) {
  if (!std::isfinite(amount)) return "-";
  return logarithmic ? io::percent(amount, digits) : io::short_number(amount, digits);
}

std::string signed_amount_text(double amount, bool logarithmic, int digits) {
  if (!std::isfinite(amount)) return "-";
  return (amount < 0 ? "-" : "+") + amount_text(std::abs(amount), logarithmic, digits);
}

std::string probability_text(double p) {
  return p < 1e-99 ? "below 1e-99" : io::short_number(p, 2);
}

std::string form_and_metric(const FittedTables& fits) {
  std::string text = fits.form;
  if (!fits.form_reason.empty()) text += " (" + fits.form_reason + ")";
  text += ", residual " + std::string(name_of(fits.metric));
  if (!fits.metric_reason.empty()) text += " (" + fits.metric_reason + ")";
  return text;
}

io::Json fits_json(const FittedTables& fits) {
  io::Json tables = io::Json::array();
  for (const FittedTable& t : fits.tables)
    tables.push_back({{"samples", t.name},
                      {"rows", t.rows},
                      {"verdict", name_of(t.fit.verdict)},
                      {"residual_over_scatter",
                       io::finite_or_null(t.fit.lack_of_fit.residual_over_scatter.value_or(kUnknown))},
                      {"findings", t.fit.findings}});
  return {{"form", fits.form},
          {"metric", name_of(fits.metric)},
          {"channels", fits.channels},
          {"budget", fits.have_budgets()},
          {"tables", std::move(tables)}};
}

void add_fits(io::HtmlReport& page, const FittedTables& fits) {
  page.heading("The fits");
  page.paragraph("Form and metric of all tables: " + form_and_metric(fits) + ".");
  std::vector<io::Row> rows;
  for (const FittedTable& t : fits.tables)
    rows.push_back({{.text = io::file_name(t.name)},
                    {.text = std::to_string(t.rows)},
                    {.text = std::string(name_of(t.fit.verdict)), .mark = mark_of(t.fit)},
                    {.text = io::percent(t.fit.median_relative_error)},
                    {.text = in_words(t.fit.lack_of_fit)}});
  page.table({"table", "rows", "verdict", "median error (fitted)", "lack of fit"}, rows);
}

}  // namespace brdf::fit
