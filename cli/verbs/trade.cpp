#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/options/next_step.h"
#include "cli/options/progress.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/verb.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "trade/ledger/compare.h"
#include "trade/ledger/report.h"
#include "trade/trade.h"

namespace brdf::cli {
namespace {

struct TradeArguments {
  trade::TradeOptions options;
  std::vector<std::string> outputs;
  std::vector<std::string> compared;  // two ledgers
  bool json = false;
};

constexpr std::string_view kSuffixes[] = {".json", ".csv", ".html"};

void check_outputs(const TradeArguments& a) {
  std::vector<io::Target> targets;
  for (const std::string& path : a.outputs) {
    if (!is_stream(path) &&
        std::ranges::find(kSuffixes, std::filesystem::path(path).extension()) == std::end(kSuffixes))
      throw InputError("-o " + path + ": the ledger is written as .json, .csv or .html");
    if (!a.compared.empty()) throw InputError("-o " + path + ": --compare writes to stdout");
    targets.push_back({"-o", path});
  }
  text_stream(targets, a.json);  // throws if two of them are standard output
  io::check_targets(targets);
}

void write_ledger_as(const std::filesystem::path& path, const trade::Ledger& ledger) {
  if (path.extension() == ".csv")
    io::write_file_atomically(path, trade::to_csv(ledger));
  else if (path.extension() == ".json" || is_stream(path))
    trade::write_ledger(path, ledger);
  else
    io::write_file_atomically(path, trade::to_html(ledger));
}

void print_ledger(const TradeArguments& a, const trade::Ledger& ledger) {
  if (a.json) {
    std::cout << io::to_text(trade::to_json(ledger)) << '\n';
    return;
  }
  const bool streams = std::ranges::any_of(a.outputs, is_stream);
  if (!streams) std::cout << trade::to_terminal(ledger);
  if (streams && !is_quiet()) std::cerr << trade::to_terminal(ledger);
  for (const std::string& path : a.outputs)
    if (path.ends_with(".html"))
      print_next_step({open_page(path)}, streams ? TextStream::error : TextStream::out);
}

Exit run_comparison(const TradeArguments& a) {
  const trade::Comparison c =
      trade::compare(trade::read_ledger(a.compared[0]), trade::read_ledger(a.compared[1]));
  if (c.compared.empty()) throw InputError("the two ledgers have no row above 1 ns in common");
  if (a.json)
    std::cout << io::to_text(trade::to_json(c)) << '\n';
  else
    std::cout << trade::to_terminal(c);
  return c.apart() == 0 ? Exit::good : Exit::failed;
}

}  // namespace

void add_trade(CLI::App& app) {
  auto arguments = std::make_shared<TradeArguments>();
  CLI::App* verb =
      add_verb(app, Purpose::judge, "trade", "Measure the speed and the error of every approximation");
  verb->add_flag("--quick", arguments->options.quick, "Measure fewer points and rounds: about a minute");
  verb->add_option("--only", arguments->options.only,
                   "Measure only kernels, batches, families, fits, frames, or the questions with this text "
                   "in their names");
  verb->add_flag("--json", arguments->json, "Ledger as JSON on stdout");
  verb->add_option("-o,--output", arguments->outputs,
                   "File to write: .json (the ledger; - for standard output), .csv, .html; may be repeated");
  verb->add_option("--compare", arguments->compared,
                   "Measure nothing; test whether the cost ratios of two ledgers agree within 25 %, for rows "
                   "above 1 ns")
      ->expected(2)
      ->excludes(verb->get_option("--quick"))
      ->excludes(verb->get_option("--only"));
  verb->footer(
      "Examples: brdf trade --quick -o ledger.json -o ledger.html\n"
      "          brdf trade --compare ledger.json another.json\n"
      "          brdf trade --only masking --json\n"
      "Exit code 1: --compare found a row that differs by more.");
  on_run(*verb, [arguments] {
    check_outputs(*arguments);
    if (!arguments->compared.empty()) return run_comparison(*arguments);
    arguments->options.progress = percent_line();
    const trade::Ledger ledger = trade::measure_ledger(arguments->options);
    if (ledger.rows.empty())
      throw InputError("--only " + arguments->options.only +
                       ": is neither a group of questions nor part of the name of a question");
    if (!ledger.left_out.empty()) Warning() << ledger.left_out;
    for (const std::string& path : arguments->outputs) write_ledger_as(path, ledger);
    print_ledger(*arguments, ledger);
    return Exit::good;
  });
}

}  // namespace brdf::cli
