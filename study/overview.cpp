#include "study/overview.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>
#include <set>
#include <tuple>

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

std::vector<std::string> names_in(const Json& json, const char* key) {
  return json.at(key).get<std::vector<std::string>>();
}

// The number of passed checks or, if checks failed, the number of failed ones; with the names of the checks
// that failed or are undecided.
Cell checks_cell(const Json& row) {
  const Json& counts = row.at("sheet");
  const std::vector<std::string> failed = names_in(row, "sheet_failed"),
                                 open = names_in(row, "sheet_undecided");
  const std::string undecided = open.empty() ? "" : "undecided: " + io::joined(open);
  if (failed.empty()) {
    const int known = counts.at("known_violation").get<int>();
    return {.text = std::to_string(counts.at("pass").get<int>() + known) + " passed",
            .mark = known > 0       ? Mark::warn
                    : !open.empty() ? Mark::unknown
                                    : Mark::good,
            .note = undecided,
            .sorted_by = double(open.size()) / 100};
  }
  return {.text = std::to_string(failed.size()) + " failed",
          .mark = Mark::bad,
          .note = io::joined(failed) + (open.empty() ? "" : "; " + undecided),
          .sorted_by = double(failed.size())};
}

Cell energy_cell(const Json& row) {
  const double albedo = number_of(row, "largest_albedo");
  if (std::isnan(albedo)) return {.text = "-"};
  const Json& kept = row.at("keeps_energy");
  const std::vector<std::string> open = names_in(row, "sheet_undecided");
  const bool undecided = std::ranges::find(open, "energy") != open.end();
  return {.text = io::percent(albedo),
          .mark = kept.is_null()      ? Mark::none
                  : !kept.get<bool>() ? Mark::warn
                  : undecided         ? Mark::unknown
                                      : Mark::good,
          .note = undecided ? "undecided for the measurements" : "",
          .sorted_by = albedo};
}

Cell share_cell(double share) {
  if (std::isnan(share)) return {.text = "-"};
  return {.text = io::percent(share), .sorted_by = share};
}

// Pictures are embedded up to this number of samples. Larger overviews refer to the files in the folders of
// the samples, because 200 embedded pictures would exceed 3 MB.
constexpr std::size_t kMostEmbedded = 40;

Cell picture_cell(const Row& row, const char* file, const std::string& folder, const std::string& alt,
                  bool embedded) {
  const std::string link = folder + "/" + kPage;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(row.folder / file, ignored)) return {.text = "-"};
  if (!embedded) return {.link = link, .alt = alt, .picture_file = folder + "/" + file};
  return {.link = link, .png = io::read_result(row.folder / file).bytes, .alt = alt};
}

// Remarks on a sample that its numbers do not show.
std::string remark_on(const Row& row) {
  if (row.fault != Fault::none) return text_of(row.json, "error");
  const auto weak = row.json.at("weakly_determined").get<std::vector<std::string>>();
  return weak.empty() ? "" : "weakly determined: " + io::joined(weak);
}

Mark mark_of(const Row& row) {
  if (row.fault != Fault::none) return Mark::bad;
  const Mark own = find_named<Mark>(text_of(row.json, "mark")).value_or(Mark::bad);
  return row.misses_tolerance() ? Mark::bad : own;
}

double error_of(const Row& row) {
  return row.fault == Fault::none ? number_of(row.json, "median_relative_error") : std::nan("");
}

// Returns the rows from the worst to the best: by mark, then by the median error, then in the given order.
std::vector<const Row*> worst_first(const std::vector<Row>& rows) {
  std::vector<const Row*> order;
  for (const Row& row : rows) order.push_back(&row);
  const auto key = [](const Row* row) {
    const double error = error_of(*row);
    return std::tuple(-int(mark_of(*row)), row->fault == Fault::none, std::isnan(error) ? -HUGE_VAL : -error);
  };
  std::ranges::stable_sort(order, {}, key);
  return order;
}

std::string verdict_text(const Row& row) {
  if (row.fault != Fault::none) return "error";
  std::string verdict = text_of(row.json, "verdict");
  std::ranges::replace(verdict, '_', ' ');
  return verdict;
}

Cell verdict_cell(const Row& row) {
  const Mark mark = mark_of(row);
  // The word of the mark comes first: "converged" alone reads as if the fit were good.
  std::string note = verdict_text(row);
  if (row.fault == Fault::none) note += ", " + text_of(row.json, "form");
  if (row.misses_tolerance()) note += ", outside the tolerance";
  return {.text = std::string(io::look_of(mark).word), .mark = mark, .note = note};
}

// The changes outside the intervals by name; other changes are counted.
Cell change_cell(const Row& row) {
  if (row.fault != Fault::none) return {};
  if (!row.compared) return {.text = "-"};
  if (row.changes.empty()) return {.text = "unchanged", .sorted_by = 0};
  std::string text;
  std::size_t beyond = 0;
  for (const Change& c : row.changes)
    if (c.is_beyond) text += (beyond++ ? "; " : "") + c.what + " from " + c.before + " to " + c.after;
  const std::size_t within = row.changes.size() - beyond;
  const std::string rest = within == 0 ? ""
                                       : io::plural(within, "change") + " within the 95 % " +
                                             (within == 1 ? "interval" : "intervals");
  if (beyond == 0) return {.text = rest, .sorted_by = 0.5};
  return {.text = text, .mark = Mark::warn, .note = rest, .sorted_by = double(beyond)};
}

struct Columns {
  bool pictures = false, embedded = true, tolerance = false, changes = false;
};

io::Row cells_of(const Row& row, const Columns& columns) {
  const bool studied = row.fault == Fault::none;
  const std::string name = text_of(row.json, "name"), folder = studied ? io::address_of(name) : "";
  io::Row cells;
  cells.reserve(9);
  cells.push_back({.text = name, .link = studied ? folder + "/" + kPage : ""});
  if (columns.pictures)
    cells.push_back(
        studied ? picture_cell(row, kSmallStudio, folder, name + ", fitted, in the studio", columns.embedded)
                : Cell{});
  cells.push_back(verdict_cell(row));
  if (studied) {
    const double over = number_of(row.json, "residual_over_scatter");
    Cell error = share_cell(number_of(row.json, "median_relative_error"));
    if (columns.tolerance) error.mark = row.misses_tolerance() ? Mark::bad : Mark::good;
    cells.push_back(error);
    cells.push_back(std::isnan(over)
                        ? Cell{.text = "not known", .mark = Mark::unknown}
                        : Cell{.text = io::short_number(over, over < 100 ? 2 : 3), .sorted_by = over});
    cells.push_back(energy_cell(row.json));
    cells.push_back(checks_cell(row.json));
  } else {
    cells.resize(cells.size() + 4);
  }
  if (columns.changes) cells.push_back(change_cell(row));
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

// Names the worst samples: "Worst: phong (misfit, median error (fitted) 30 %), ...".
std::string worst_text(const std::vector<const Row*>& order) {
  constexpr std::size_t kNamed = 3;
  std::string text;
  for (std::size_t k = 0; k < std::min(order.size(), kNamed); ++k) {
    const Row& row = *order[k];
    if (mark_of(row) == Mark::good) break;
    const double error = error_of(row);
    text += (text.empty() ? " Worst: " : ", ") + text_of(row.json, "name") + " (" + verdict_text(row) +
            (std::isnan(error) ? "" : ", median error (fitted) " + io::percent(error, 2)) + ")";
  }
  return text.empty() ? "" : text + ".";
}

std::string verdict_of(const std::vector<Row>& rows, const std::vector<const Row*>& order, std::size_t usable,
                       std::size_t warned) {
  const std::size_t broken = count(rows, [](const Row& row) { return row.fault != Fault::none; }),
                    missing = count(rows, [](const Row& row) { return row.misses_tolerance(); });
  std::string text = std::to_string(usable) + " of " + io::plural(rows.size(), "sample") +
                     (usable == 1 ? " has" : " have") + " a usable fit";
  if (warned > 0) text += ", " + std::to_string(warned) + " of them with warnings";
  if (broken > 0) text += "; " + std::to_string(broken) + " could not be studied";
  if (missing > 0) text += "; " + std::to_string(missing) + " outside the tolerance";
  return text + "." + worst_text(order);
}

void add_changes(io::HtmlReport& report, const std::vector<Row>& rows, const std::filesystem::path& against) {
  const std::size_t compared = count(rows, [](const Row& row) { return row.compared; });
  if (compared == 0) return;
  const auto beyond = [](const Row& row) {
    return std::ranges::any_of(row.changes, [](const Change& c) { return c.is_beyond; });
  };
  const std::size_t moved = count(rows, beyond);
  report.paragraph(
      "Compared with " + (against.empty() ? "the earlier results in this folder" : against.string()) + ": " +
      (moved == 0 ? "every form is the same, and every parameter is within its older 95 % interval."
                  : io::plural(moved, "sample") + (moved == 1 ? " has" : " have") +
                        " another form, or a parameter outside its older 95 % interval."));
}

void add_table(io::HtmlReport& report, const std::vector<Row>& rows, const std::vector<const Row*>& order) {
  report.explain(
      "energy",
      "The largest directional albedo of the fitted material at ten or more angles of incidence up to "
      "85 degrees. Above 100 % it violates energy conservation.");
  report.explain("measurements", "The data check: checks of the measurements themselves, before any fit.");
  report.explain("change", "Differences of the parameters from the older study of the same sample.");
  const Columns columns{.pictures = count(rows, is_drawn) > 0,
                        .embedded = rows.size() <= kMostEmbedded,
                        .tolerance = count(rows,
                                           [](const Row& row) {
                                             return row.fault == Fault::none &&
                                                    !row.json.at("tolerance").is_null();
                                           }) > 0,
                        .changes = count(rows, [](const Row& row) { return row.compared; }) > 0};
  std::vector<std::string> header{"sample"};
  if (columns.pictures) header.emplace_back("in the studio");
  header.insert(header.end(), {"verdict", "median error (fitted)", "x scatter", "energy", "measurements"});
  if (columns.changes) header.emplace_back("change");
  header.emplace_back("remarks");
  std::vector<io::Row> cells;
  cells.reserve(order.size());
  for (const Row* row : order) cells.push_back(cells_of(*row, columns));
  report.style("body { max-width: 84rem; } td img { width: 5rem; height: 5rem; max-width: none; }");
  report.table(header, cells, true);
}

std::string page_of(const std::vector<Row>& rows, const std::filesystem::path& against) {
  io::HtmlReport report("Study of " + io::plural(rows.size(), "sample"));
  const std::vector<const Row*> order = worst_first(rows);
  const std::size_t usable = count(rows, [](const Row& row) { return row.usable(); });
  const std::size_t warned =
      count(rows, [](const Row& row) { return row.usable() && row.json.at("mark") != "good"; });
  report.verdict(mark_of(*order.front()), verdict_of(rows, order, usable, warned));
  for (const std::string& reason : missing_pictures(rows))
    report.paragraph("Samples without pictures: " + reason + ".");
  add_changes(report, rows, against);
  add_table(report, rows, order);
  return report.document(io::provenance());
}

}  // namespace

void write_overview(const std::vector<Row>& rows, const std::filesystem::path& folder,
                    const std::filesystem::path& against) {
  // A user who has interrupted a study of many thousands of samples waits for both.
  std::future<std::string> page = std::async(std::launch::async, [&] { return page_of(rows, against); });
  Json results = io::to_json(io::provenance());
  results["results"] = Json::array();
  for (const Row& row : rows) results["results"].push_back(to_json(row));
  publish(folder, {{kPage, page.get()}}, std::move(results), "overview");
}

}  // namespace brdf::study
