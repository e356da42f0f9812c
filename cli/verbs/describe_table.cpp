#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options/next_step.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/verb.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/shell.h"
#include "io/files/standard_input.h"
#include "io/formats/describe_table.h"
#include "io/formats/read.h"
#include "sheet/data_sheet.h"

namespace brdf::cli {
namespace {

struct DescribeTableCall {
  std::string table, output;
};

io::SampleTable read_by(const io::Json& layout, const io::Content& content) {
  return io::read_samples(io::Content(content), {.layout = io::to_line(layout)});
}

bool is_same(const io::SampleTable& a, const io::SampleTable& b) {
  return a.theta_i == b.theta_i && a.phi_i == b.phi_i && a.theta_o == b.theta_o && a.phi_o == b.phi_o &&
         a.channels == b.channels && a.values == b.values && a.sigma == b.sigma;
}

// Adds the fill values of a table that is read without a layout, provided that the layout then leaves out
// the same rows as the other verbs do.
void propose_fill(io::TableProposal& proposal, const io::Content& content) {
  io::SampleTable measured = *proposal.alone;
  const std::vector<bool> fill = sheet::not_measured(measured);
  std::vector<std::uint32_t> lines;
  for (std::size_t k = 0; k < fill.size(); ++k)
    if (fill[k] && k < measured.lines.size()) lines.push_back(measured.lines[k]);
  if (lines.empty()) return;
  const io::TableProposal without = proposal;
  io::add_fill(proposal, content, lines);
  sheet::leave_out(fill, measured);
  if (!is_same(read_by(proposal.layout, content), measured)) proposal = without;
}

// Reads a table that is refused without a layout.
Exit check_refused(const io::TableProposal& proposal, const io::Content& content) {
  try {
    const io::SampleTable table = read_by(proposal.layout, content);
    Note() << "brdf describe-table: checked: the proposal reads " << io::plural(table.rows(), "row") << " of "
           << io::plural(table.channels.size(), "channel");
    return Exit::good;
  } catch (const InputError& error) {
    Warning() << "brdf describe-table: the proposal does not read the table, either: " << error.what();
    return Exit::failed;
  }
}

// Compares the table as the proposal reads it with the table as it is read without a layout.
Exit check(const io::TableProposal& proposal, const io::Content& content) {
  if (!proposal.alone) return check_refused(proposal, content);
  io::SampleTable alone = *proposal.alone;
  if (proposal.layout.contains("fill")) sheet::leave_out(sheet::not_measured(alone), alone);
  const io::SampleTable again = read_by(proposal.layout, content);
  if (!is_same(again, alone)) {
    Warning() << "brdf describe-table: the proposal reads other rows than the table has without a layout";
    return Exit::failed;
  }
  Note() << "brdf describe-table: checked: the proposal reads the same " << io::plural(again.rows(), "row")
         << " of " << io::plural(again.channels.size(), "channel") << " as are read without a layout";
  return Exit::good;
}

void print_doubts(const io::TableProposal& proposal) {
  if (!proposal.layout.contains("unsure")) return;
  for (const io::Json& entry : proposal.layout["unsure"])
    Warning() << "brdf describe-table: " << entry["path"].get<std::string>() << ": "
              << entry["reason"].get<std::string>();
}

Exit run_describe_table(const DescribeTableCall& o) {
  io::check_targets({{"-o", o.output}});
  const io::Content content = io::read_content(o.table);
  const std::string name = io::input_name(o.table);
  io::TableProposal proposal = io::propose_layout(content);
  if (proposal.alone) propose_fill(proposal, content);
  const std::string json = io::to_text(proposal.layout);
  if (o.output.empty() || is_stream(o.output))
    std::cout << json;
  else
    io::write_file_atomically(o.output, json);
  print_doubts(proposal);
  if (!proposal.alone)
    Warning() << "brdf describe-table: " << name << " is refused without a layout: " << proposal.refusal;
  if (proposal.open > 0) {
    Warning() << "brdf describe-table: " << io::plural(proposal.open, "place")
              << " of the proposal must be completed: null";
    return Exit::failed;
  }
  if (check(proposal, content) == Exit::failed) return Exit::failed;
  const std::string layout = o.output.empty() || is_stream(o.output) ? "layout.json" : o.output;
  print_next_step({"brdf convert " + io::shell_word(name) + " table.csv --layout " + io::shell_word(layout)},
                  TextStream::error, "read the table with it");
  return Exit::good;
}

}  // namespace

void add_describe_table(CLI::App& app) {
  auto options = std::make_shared<DescribeTableCall>();
  CLI::App* verb = add_verb(app, Purpose::measure, "describe-table",
                            "Propose a layout of a laboratory's table, for --layout");
  verb->add_option("SAMPLES", options->table, "A table of columns of text; - for standard input")->required();
  verb->add_option("-o,--output", options->output, "File of the layout (default: standard output)");
  verb->footer(
      "Places that the table does not decide are null in the layout: replace them, then read the table with\n"
      "--layout. The exit code is 1 if a place is null, or if the proposal does not read the table.\n"
      "Examples: brdf describe-table lab.txt -o lab.json\n"
      "          brdf convert lab.txt lab.csv --layout lab.json");
  on_run(*verb, [options] { return run_describe_table(*options); });
}

}  // namespace brdf::cli
