#include "study/overview.h"

#include <algorithm>

#include "io/fingerprint.h"
#include "io/html_report.h"
#include "io/numbers.h"
#include "study/folder.h"

namespace brdf::study {
namespace {

using io::Cell;
using io::Json;
using io::Mark;

std::string page_of(const std::vector<Row>& rows) {
  io::HtmlReport report("Study of " + std::to_string(rows.size()) + " samples");
  const auto good =
      std::size_t(std::count_if(rows.begin(), rows.end(), [](const Row& r) { return r.usable(); }));
  report.verdict(good == rows.size() ? Mark::good : Mark::warn,
                 std::to_string(good) + " of " + std::to_string(rows.size()) + " samples have a usable fit.");
  std::vector<std::vector<Cell>> cells;
  for (const Row& row : rows) {
    if (row.fault != Fault::none) {
      cells.push_back({{row.json["name"]}, {"error", Mark::bad}, {row.json["error"]}, {}});
      continue;
    }
    cells.push_back({{row.json["name"]},
                     {row.json["verdict"], row.usable() ? Mark::good : Mark::bad},
                     {row.json["form"]},
                     {io::percent(row.json["median_relative_error"].is_null()
                                      ? 0.0
                                      : row.json["median_relative_error"].get<double>())}});
  }
  report.table({"sample", "verdict", "form", "median error"}, cells);
  return report.document(io::provenance());
}

}  // namespace

void write_overview(const std::vector<Row>& rows, const std::filesystem::path& folder) {
  Json results = io::to_json(io::provenance());
  results["results"] = Json::array();
  for (const Row& row : rows) results["results"].push_back(row.json);
  publish(folder, {{kPage, page_of(rows)}}, std::move(results), "overview");
}

}  // namespace brdf::study
