#include "validate/report/report.h"

#include <algorithm>
#include <array>
#include <iomanip>

#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::validate {
namespace {

std::string readable(const Witness& w) {
  std::string text;
  for (const auto* list : {&w.parameters, &w.angles})
    for (const auto& [name, value] : *list)
      text += (text.empty() ? "" : " ") + name + "=" + io::short_number(value, 6);
  return text;
}

std::string plain(Outcome outcome) {
  std::string name(name_of(outcome));
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::size_t count(const std::vector<Finding>& findings, Outcome outcome) {
  return std::size_t(std::ranges::count_if(findings, [&](const Finding& f) { return f.outcome == outcome; }));
}

}  // namespace

std::string summary(const std::vector<Finding>& findings) {
  const std::size_t failed = count(findings, Outcome::fail),
                    known = count(findings, Outcome::known_violation),
                    passed = count(findings, Outcome::pass);
  std::string text = std::to_string(passed) + " passed";
  if (known > 0) text += ", " + std::to_string(known) + " known violation" + (known > 1 ? "s" : "");
  text += ", " + std::to_string(failed) + " failed";
  if (const std::size_t open = count(findings, Outcome::undecided); open > 0)
    text += ", " + std::to_string(open) + " undecided";
  if (const std::size_t none = count(findings, Outcome::not_applicable); none > 0)
    text += ", " + std::to_string(none) + " not applicable";
  return text;
}

void print_findings(std::ostream& out, const std::vector<Finding>& findings, bool colour) {
  constexpr std::array colours{"\033[32m", "\033[33m", "\033[31m", "\033[2m", "\033[33m"};
  std::string subject;
  for (const Finding& f : findings) {
    if (f.subject != subject) out << (subject.empty() ? "" : "\n") << io::printable(f.subject) << '\n';
    subject = f.subject;
    out << "  " << std::left << std::setw(15) << f.check << (f.check.size() < 15 ? "" : " ");
    if (colour) out << colours[std::size_t(f.outcome)];
    out << std::setw(16) << plain(f.outcome);
    if (colour) out << "\033[0m";
    out << std::right << io::printable(said(f)) << '\n';
    if (!shows_witness(f)) continue;
    out << "      at " << readable(*f.witness) << '\n';
    if (!f.witness->command.empty()) out << "      $ " << io::printable(f.witness->command) << '\n';
  }
  out << '\n' << summary(findings) << '\n';
}

namespace {

// Escapes arbitrary text for a cell of a Markdown table.
std::string markdown_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>|~&").find(c) != std::string_view::npos) out += '\\';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out;
}

// Formats text as code for a cell of a Markdown table. The fence is longer than any run of backticks
// inside.
std::string markdown_code(std::string_view text) {
  std::string out;
  std::size_t longest = 0, run = 0;
  for (const char c : text) {
    longest = std::max(longest, run = c == '`' ? run + 1 : 0);
    out += c == '|' ? std::string("\\|") : std::string(1, c);
  }
  const std::string fence(longest + 1, '`'), space = longest > 0 ? " " : "";
  return fence + space + out + space + fence;
}

}  // namespace

std::string to_markdown(const std::vector<Finding>& findings) {
  std::string text =
      "**" + summary(findings) + "**\n\n| subject | check | verdict | finding |\n|---|---|---|---|\n";
  for (const Finding& f : findings) {
    constexpr std::array signs{"pass", "known violation", "**fail**", "not applicable", "undecided"};
    text += "| " + markdown_text(f.subject) + " | " + f.check + " | " + signs[std::size_t(f.outcome)] +
            " | " + markdown_text(said(f));
    if (shows_witness(f) && !f.witness->command.empty()) text += "<br>" + markdown_code(f.witness->command);
    text += " |\n";
  }
  return text;
}

}  // namespace brdf::validate
