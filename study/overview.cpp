#include "study/overview.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "io/files/address.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/page/html_report.h"
#include "study/folder.h"

namespace brdf::study {
namespace {

using io::Cell;
using io::Json;
using io::Mark;

std::string text_of(const Json& json, const char* key) {
  return json.at(key).get<std::string>();
}

double number_of(const Json& json, const char* key) {
  return json.at(key).is_number() ? json.at(key).get<double>() : std::nan("");
}

// The number of passed checks or, if checks failed, the number of failed ones with their names below.
Cell checks_cell(const Json& counts, const Json& failed) {
  const int good = counts.at("pass").get<int>(), open = counts.at("undecided").get<int>(),
            known = counts.at("known_violation").get<int>();
  if (failed.empty())
    return {.text = std::to_string(good + known) + " passed",
            .mark = open + known > 0 ? Mark::warn : Mark::good,
            .note = open > 0 ? std::to_string(open) + " undecided" : "",
            .sorted_by = 0};
  return {.text = std::to_string(failed.size()) + " failed",
          .mark = Mark::bad,
          .note = io::joined(failed.get<std::vector<std::string>>()),
          .sorted_by = double(failed.size())};
}

Cell energy_cell(const Json& row) {
  const double albedo = number_of(row, "largest_albedo");
  if (std::isnan(albedo)) return {.text = "-"};
  const Json& kept = row.at("keeps_energy");
  return {.text = io::percent(albedo),
          .mark = kept.is_null()     ? Mark::none
                  : kept.get<bool>() ? Mark::good
                                     : Mark::warn,
          .sorted_by = albedo};
}

Cell share_cell(double share) {
  if (std::isnan(share)) return {.text = "-"};
  return {.text = io::percent(share), .sorted_by = share};
}

Cell picture_cell(const Row& row, const char* file, const std::string& link, const std::string& alt) {
  try {
    return {.link = link, .png = io::read_content(row.folder / file).bytes, .alt = alt};
  } catch (const InputError&) {  // no picture was drawn
    return {.text = "-"};
  }
}

// Remarks on a sample that its numbers do not show.
std::string remark_on(const Row& row) {
  if (row.fault != Fault::none) return text_of(row.json, "error");
  const auto weak = row.json.at("weakly_determined").get<std::vector<std::string>>();
  return weak.empty() ? "" : "weakly determined: " + io::joined(weak);
}

Cell verdict_cell(const Row& row) {
  if (row.fault != Fault::none) return {.text = "error", .mark = Mark::bad};
  std::string verdict = text_of(row.json, "verdict");
  std::ranges::replace(verdict, '_', ' ');
  return {.text = verdict,
          .mark = find_named<Mark>(text_of(row.json, "mark")).value_or(Mark::bad),
          .note = text_of(row.json, "form")};
}

io::Row cells_of(const Row& row, bool pictures) {
  const bool studied = row.fault == Fault::none;
  const std::string name = text_of(row.json, "name"),
                    link = studied ? io::address_of(name) + "/" + kPage : "";
  io::Row cells{{.text = name, .link = link}};
  if (pictures)
    cells.push_back(studied ? picture_cell(row, kSmallStudio, link, name + ", fitted, in the studio")
                            : Cell{});
  cells.push_back(verdict_cell(row));
  if (studied) {
    const double over = number_of(row.json, "residual_over_scatter");
    cells.push_back(share_cell(number_of(row.json, "median_relative_error")));
    cells.push_back(std::isnan(over)
                        ? Cell{.text = "-"}
                        : Cell{.text = io::short_number(over, over < 100 ? 2 : 3), .sorted_by = over});
    cells.push_back(energy_cell(row.json));
    cells.push_back(checks_cell(row.json.at("sheet"), row.json.at("sheet_failed")));
  } else {
    cells.resize(cells.size() + 4);
  }
  cells.push_back({.text = remark_on(row)});
  return cells;
}

// The reasons for missing pictures, each once.
std::set<std::string> missing_pictures(const std::vector<Row>& rows) {
  std::set<std::string> reasons;
  for (const Row& row : rows)
    if (row.fault == Fault::none && !row.json.at("no_pictures").is_null())
      reasons.insert(text_of(row.json, "no_pictures"));
  return reasons;
}

std::size_t count(const std::vector<Row>& rows, bool (*is)(const Row&)) {
  return std::size_t(std::ranges::count_if(rows, is));
}

bool is_drawn(const Row& row) {
  return row.fault == Fault::none && row.json.at("no_pictures").is_null();
}

std::string verdict_of(const std::vector<Row>& rows, std::size_t usable, std::size_t warned) {
  const std::size_t broken = count(rows, [](const Row& row) { return row.fault != Fault::none; });
  std::string text = std::to_string(usable) + " of " + io::plural(rows.size(), "sample") +
                     (usable == 1 ? " has" : " have") + " a usable fit";
  if (warned > 0) text += ", " + std::to_string(warned) + " of them with warnings";
  if (broken > 0) text += "; " + std::to_string(broken) + " could not be studied";
  return text + ".";
}

void add_table(io::HtmlReport& report, const std::vector<Row>& rows) {
  report.explain("energy",
                 "The largest directional albedo of the fitted material over the angles of incidence. Above "
                 "100 % it violates energy conservation.");
  report.explain("samples", "The data check: checks of the measurements themselves, before any fit.");
  const bool pictures = count(rows, is_drawn) > 0;
  std::vector<std::string> header{"sample"};
  if (pictures) header.emplace_back("in the studio");
  header.insert(header.end(), {"verdict", "median", "x scatter", "energy", "samples", "remarks"});
  std::vector<io::Row> cells;
  for (const Row& row : rows) cells.push_back(cells_of(row, pictures));
  report.style("body { max-width: 78rem; } td img { max-width: 5rem; }");
  report.table(header, cells, true);
}

std::string page_of(const std::vector<Row>& rows) {
  io::HtmlReport report("Study of " + io::plural(rows.size(), "sample"));
  const std::size_t usable = count(rows, [](const Row& row) { return row.usable(); });
  const std::size_t warned =
      count(rows, [](const Row& row) { return row.usable() && row.json.at("mark") != "good"; });
  report.verdict(usable == rows.size() && warned == 0 ? Mark::good : Mark::warn,
                 verdict_of(rows, usable, warned));
  for (const std::string& reason : missing_pictures(rows))
    report.paragraph("Samples without pictures: " + reason + ".");
  add_table(report, rows);
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
