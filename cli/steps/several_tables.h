// The options of the verbs that compare tables of one surface, and the tables.
#pragma once

#include <string>
#include <vector>

#include "cli/options/products.h"
#include "fit/between/tables.h"
#include "fit/choice.h"

namespace CLI {
class App;
}

namespace brdf::cli {

struct SeveralTables {
  std::vector<std::string> samples;
  std::vector<std::string> budgets;  // one for all tables, or one for each
  fit::FitChoice choice;
  std::string page;
  bool json = false;
};

// The options of add_table_options(), for the table of a verb's options (cli/options/products.h).
inline constexpr OptionOf kTableOptions[] = {
    {"SAMPLES --form --metric --anisotropic --per-channel --shape --free-scale --keep-fill --polarisation "
     "--repeats --quantity --mirror-side --layout --budget --max-theta --fix --start --bounds --tie "
     "--physical "
     "--robust --weights --starts --aperture --report --json",
     1},
    {"--seed", 1, "--starts"}};

// Adds the samples, the options of a fit, --report and --json. --budget may be repeated.
void add_table_options(CLI::App& verb, SeveralTables& o, const std::string& description);

// Reads the tables, each with the options of its fit. Checks the outputs before any file is read. `verb`
// names the caller in warnings.
std::vector<fit::TableToFit> tables_to_fit(const SeveralTables& o, const std::string& verb);

// Writes the page, if one was requested.
void write_page(const SeveralTables& o, const std::string& html);

}  // namespace brdf::cli
