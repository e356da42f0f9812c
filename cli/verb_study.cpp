#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>

#include "cli/fit_options.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/terminal.h"
#include "cli/verbs.h"
#include "io/error.h"
#include "io/numbers.h"
#include "study/study.h"

namespace brdf::cli {
namespace {

struct Options {
  std::vector<std::string> samples;
  std::string output;
  bool json = false, no_pictures = false;
  unsigned jobs = 1;
  fit::FitChoice choice;
};

void print_text(const std::vector<study::Row>& rows, const std::filesystem::path& folder) {
  PlainText out;
  std::size_t widest = 0;
  for (const study::Row& row : rows) widest = std::max(widest, row.json["name"].get<std::string>().size());
  for (const study::Row& row : rows) {
    out << std::left << std::setw(int(widest) + 2) << row.json["name"].get<std::string>();
    if (row.fault == study::Fault::none)
      out << row.json["statement"].get<std::string>() << (row.kept ? " (kept)" : "") << '\n';
    else
      out << "error\n";
    for (const io::Json& warning : row.json.value("warnings", io::Json::array()))
      out << "  " << warning.get<std::string>() << '\n';
  }
  out << (folder / study::kPage).string() << '\n';
}

// Why samples have no study, a line for each.
void say_faults(const std::vector<study::Row>& rows) {
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].fault != study::Fault::none)
      std::cerr << "[" << k + 1 << "/" << rows.size() << "] " << rows[k].json["error"].get<std::string>()
                << '\n';
}

void print_json(const std::vector<study::Row>& rows) {
  io::Json out = io::to_json(io::provenance());
  out["results"] = io::Json::array();
  for (const study::Row& row : rows) {
    io::Json json = row.json;
    json["kept"] = row.kept;
    out["results"].push_back(std::move(json));
  }
  std::cout << io::to_text(out);
}

Exit run(const Options& o) {
  watch_for_interrupt();
  study::StudyOptions options;
  options.folder = o.output;
  options.sample.models = fit::models_of(o.choice.form);
  options.sample.fit = fit_options(o.choice, o.jobs);
  options.sample.fit_words = fit::words_of(o.choice);
  options.settings = io::provenance().version + options.sample.fit_words;
  options.sample.pictures = !o.no_pictures;
  options.jobs = o.jobs;
  options.progress = progress_line("brdf study");
  const std::vector<study::Row> rows = study::study(o.samples, options);
  say_faults(rows);
  o.json ? print_json(rows) : print_text(rows, o.output);
  const auto has = [&](study::Fault fault) {
    return std::any_of(rows.begin(), rows.end(), [&](const study::Row& row) { return row.fault == fault; });
  };
  if (has(study::Fault::environment)) return Exit::environment;
  return std::all_of(rows.begin(), rows.end(), [](const study::Row& row) { return row.usable(); })
             ? Exit::good
             : Exit::failed;
}

}  // namespace

void add_study(CLI::App& app) {
  auto options = std::make_shared<Options>();
  Options& o = *options;
  CLI::App* verb = add_verb(app, Purpose::judge, "study",
                            "All of one sample's story on one page; of many with an overview");
  verb->add_option("SAMPLES", o.samples, "Sample tables (CSV, MERL, ...)")->required();
  add_fit_options(*verb, o.choice);
  verb->add_option("-o,--output", o.output,
                   "Folder of the results: index.html, and with several samples a folder for each")
      ->required();
  verb->add_option("--jobs", o.jobs, "Samples studied at the same time")->check(CLI::Range(1u, 256u));
  verb->add_flag("--no-pictures", o.no_pictures, "Leave out the spheres, which take most of the time");
  verb->add_flag("--json", o.json, "JSON on stdout");
  verb->footer(
      "Samples whose results are in the folder, made from the same file by the same options, are kept.\n"
      "Examples: brdf study paint.csv -o paint\n"
      "          brdf study samples/*.csv --jobs 4 -o studied\n"
      "          brdf study samples/*.csv --form cook_torrance --no-pictures --json -o numbers");
  on_run(*verb, [options] { return run(*options); });
}

}  // namespace brdf::cli
