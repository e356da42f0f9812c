#include "cli/program/study_files.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "cli/options/next_step.h"
#include "cli/options/terminal.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"
#include "io/files/standard_input.h"
#include "io/files/text.h"
#include "io/page/marks.h"
#include "study/folder.h"

namespace brdf::cli {
namespace {

// Returns true if the sample was not studied because the run was interrupted.
bool was_left(const study::Row& row) {
  return row.fault == study::Fault::interrupted;
}

// Returns the word of the row's mark: "good", "warning".
std::string_view word_of(const study::Row& row) {
  const auto mark = find_named<io::Mark>(row.json["mark"].get<std::string>());
  return io::look_of(mark.value_or(io::Mark::bad)).word;
}

std::string text_of(const io::Json& json) {
  return io::printable(json.get<std::string>());
}

std::size_t widest_name(const std::vector<std::string>& samples) {
  std::size_t widest = 0;
  for (const std::string& name : study::folder_names(samples))
    widest = std::max(widest, io::printable(name).size());
  return widest;
}

void print_text(const study::Row& row, std::size_t widest) {
  PlainText out;
  out << std::left << std::setw(int(widest) + 2) << text_of(row.json["name"]);
  if (row.fault == study::Fault::none)
    out << word_of(row) << ": " << text_of(row.json["statement"]) << (row.kept ? " (kept)" : "") << '\n';
  else
    out << "error\n";
  for (const io::Json& warning : row.json.value("warnings", io::Json::array()))
    out << "  " << text_of(warning) << '\n';
  if (row.misses_tolerance())
    out << "  Outside the tolerance of " << io::percent(row.json["tolerance"].get<double>()) << ".\n";
  for (const study::Change& c : row.changes)
    out << "  Changed: " << io::printable(c.what) << " from " << c.before << " to " << c.after
        << (c.is_beyond ? ", outside the older 95 % interval.\n" : ", within the older 95 % interval.\n");
}

// Prints the assumptions about the sample, and the reason if it has no study.
void say_faults(const study::Row& row, std::size_t k, std::size_t rows) {
  for (const std::string& sentence : row.assumptions)
    Warning() << "brdf study: " << io::input_name(row.file) << ": " << sentence;
  if (row.fault != study::Fault::none && !was_left(row))
    Warning() << "[" << k + 1 << "/" << rows << "] " << row.json["error"].get<std::string>();
}

// Returns the command that shows the material of a single sample in the window.
std::string command_for(const std::vector<study::Row>& rows, bool is_readable) {
  if (rows.size() != 1) return "";
  const std::filesystem::path material = rows[0].folder / study::kMaterial;
  if (!std::filesystem::exists(material)) return "";
  return view_command(material.string(), is_readable ? rows[0].file : "");
}

// Returns whether this run wrote or kept the page. A page of an earlier study of one sample does not count.
bool has_page(const std::vector<study::Row>& rows, const std::filesystem::path& page) {
  const bool is_of_one = rows.size() == 1 && rows[0].folder / study::kPage == page;
  return std::filesystem::exists(page) && !(is_of_one && rows[0].fault != study::Fault::none);
}

void print_json(const std::vector<study::Row>& rows) {
  io::Json out = io::to_json(io::provenance());
  out["results"] = io::Json::array();
  for (const study::Row& row : rows) {
    io::Json json = study::to_json(row);
    json["kept"] = row.kept;
    out["results"].push_back(std::move(json));
  }
  std::cout << io::to_text(out);
}

}  // namespace

Exit study_files(const std::vector<std::string>& samples, study::StudyOptions options, bool json,
                 bool is_readable) {
  const std::size_t widest = json ? 0 : widest_name(samples);
  std::size_t printed = 0;
  options.finished = [&](const study::Row& row, std::size_t k, std::size_t rows) {
    say_faults(row, k, rows);
    if (!json && !was_left(row)) print_text(row, widest);
    std::cout << std::flush;
    printed = k + 1;
  };
  const std::vector<study::Row> rows = study::study(samples, options);
  // A part of a study whose samples all have faults.
  for (std::size_t k = printed; k < rows.size(); ++k) options.finished(rows[k], k, rows.size());
  if (const auto left = std::ranges::count_if(rows, was_left); left > 0)
    Warning() << "brdf study: interrupted: " << left << " of " << rows.size() << " not processed";
  if (json) print_json(rows);
  // An interrupted study of one sample, and a full disk, leave no page.
  if (const auto page = options.folder / study::kPage; !json && has_page(rows, page)) {
    PlainText() << io::printable(page.string()) << '\n';
    print_next_step({open_page(page.string()), command_for(rows, is_readable)});
  }
  const auto has = [&](study::Fault fault) {
    return std::ranges::any_of(rows, [&](const study::Row& row) { return row.fault == fault; });
  };
  if (has(study::Fault::environment)) return Exit::environment;
  return std::ranges::all_of(rows,
                             [](const study::Row& row) { return row.usable() && !row.misses_tolerance(); })
             ? Exit::good
             : Exit::failed;
}

}  // namespace brdf::cli
