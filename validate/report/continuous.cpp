#include "validate/report/continuous.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "io/files/address.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"
#include "io/files/text.h"
#include "io/page/html_report.h"
#include "validate/report/report.h"

namespace brdf::validate {
namespace {

using io::Json;

constexpr const char* kFormat = "brdf-accepted-findings";
constexpr int kVersion = 1;

std::string meaning_of_rule(std::string_view check) {
  return check == kReadable ? "The file can be read as a reflectance." : std::string(check_meaning(check));
}

// Finds the source line that a statement names: "...; line 12, `x / y`: ...".
std::optional<int> line_in(const std::string& statement) {
  constexpr std::string_view kLine = "line ";
  const std::size_t at = statement.find(kLine);
  if (at == statement.npos || (at > 0 && statement[at - 1] != ' ')) return std::nullopt;
  const int line = std::atoi(statement.c_str() + at + kLine.size());
  return line > 0 ? std::optional(line) : std::nullopt;
}

// The statement and the command that reproduces the worst value.
std::string text_of(const Finding& f) {
  return said(f) + (f.witness && !f.witness->command.empty() ? "\n$ " + f.witness->command : "");
}

// Control characters, which XML does not allow, become question marks.
std::string xml(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') c = '?';
  return io::html_escaped(text);
}

std::string case_of(const Finding& f, const Baseline& accepted) {
  const std::string head = "    <testcase classname=\"" + xml(f.subject) + "\" name=\"" + xml(f.check) + "\"";
  const auto skipped = [&](const std::string& why) {
    return head + "><skipped message=\"" + xml(why) + "\"/></testcase>\n";
  };
  if (f.outcome == Outcome::undecided) return skipped("undecided: " + f.statement);
  if (f.outcome == Outcome::known_violation) return skipped("declared by the file: " + f.statement);
  if (f.outcome != Outcome::fail) return head + "/>\n";
  if (accepted.accepts(f)) return skipped("accepted: " + f.statement);
  return head + "><failure message=\"" + xml(f.statement) + "\">" + xml(text_of(f)) +
         "</failure></testcase>\n";
}

std::string address(const std::string& file) {
  std::string out;
  for (const std::filesystem::path& part : std::filesystem::path(file)) {
    if (part == "/") {
      out = "/";
      continue;
    }
    if (!out.empty() && out.back() != '/') out += '/';
    out += io::address_of(part.string());
  }
  return out;
}

Json result_of(const Finding& f, const Baseline& accepted) {
  Json place = {{"artifactLocation", {{"uri", address(f.subject)}}}};
  if (const std::optional<int> line = line_in(f.statement)) place["region"] = {{"startLine", *line}};
  const bool fails = f.outcome == Outcome::fail;
  Json result = {{"ruleId", f.check},
                 {"kind", fails ? "fail" : "open"},
                 {"level", fails ? "error" : "none"},
                 {"message", {{"text", text_of(f)}}},
                 {"locations", Json::array({{{"physicalLocation", place}}})},
                 {"partialFingerprints", {{"fileAndCheck/v1", f.subject + ":" + f.check}}}};
  if (fails) result["baselineState"] = accepted.accepts(f) ? "unchanged" : "new";
  return result;
}

}  // namespace

Baseline::Baseline(const Json& json, const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(name + ": " + what + "; --update-baseline writes such a file");
  };
  if (!json.is_object() || json.value("format", "") != kFormat)
    refuse(std::string("$.format: must be \"") + kFormat + "\"");
  if (json.value("version", Json()) != kVersion) refuse("$.version: must be " + std::to_string(kVersion));
  if (!json.contains("accepted") || !json["accepted"].is_array()) refuse("$.accepted: must be a list");
  for (std::size_t k = 0; k < json["accepted"].size(); ++k) {
    const Json& entry = json["accepted"][k];
    if (!entry.is_object() || !entry.contains("file") || !entry["file"].is_string() ||
        !entry.contains("check") || !entry["check"].is_string())
      refuse("$.accepted[" + std::to_string(k) + "]: must have a file and a check");
    entries_.emplace(entry["file"], entry["check"]);
  }
}

Baseline Baseline::updated(const std::vector<Finding>& findings) const {
  Baseline out = *this;
  for (const Entry& entry : obsolete(findings)) out.entries_.erase(entry);
  for (const Finding& f : findings)
    if (f.outcome == Outcome::fail) out.entries_.emplace(f.subject, f.check);
  return out;
}

std::vector<Baseline::Entry> Baseline::obsolete(const std::vector<Finding>& findings) const {
  std::set<std::string> files;
  std::set<Entry> still;
  for (const Finding& f : findings) {
    files.insert(f.subject);
    // An undecided check could not look, and an unreadable file could not be judged.
    if (f.outcome == Outcome::fail || f.outcome == Outcome::undecided) still.emplace(f.subject, f.check);
    if (f.outcome == Outcome::fail && f.check == kReadable) files.erase(f.subject);
  }
  std::vector<Entry> out;
  for (const Entry& entry : entries_)
    if (files.contains(entry.first) && !still.contains(entry)) out.push_back(entry);
  return out;
}

Json Baseline::to_json() const {
  Json json = io::to_json(io::provenance());
  json["format"] = kFormat;
  json["version"] = kVersion;
  json["accepted"] = Json::array();
  for (const auto& [file, check] : entries_) json["accepted"].push_back({{"file", file}, {"check", check}});
  return json;
}

bool is_new(const Finding& finding, const Baseline& accepted) {
  return finding.outcome == Outcome::fail && !accepted.accepts(finding);
}

std::string to_junit(const std::vector<Finding>& findings, const Baseline& accepted) {
  struct Suite {
    std::string cases;
    int tests = 0, failures = 0, skipped = 0;
  };
  std::map<std::string, Suite> suites;
  Suite all;
  for (const Finding& f : findings) {
    Suite& suite = suites[f.subject];
    if (f.outcome == Outcome::not_applicable) continue;
    const bool fails = is_new(f, accepted), passes = f.outcome == Outcome::pass;
    suite.cases += case_of(f, accepted);
    for (Suite* s : {&suite, &all}) ++s->tests, s->failures += fails, s->skipped += !fails && !passes;
  }
  const auto counts = [](const Suite& s) {
    return " tests=\"" + std::to_string(s.tests) + "\" failures=\"" + std::to_string(s.failures) +
           "\" errors=\"0\" skipped=\"" + std::to_string(s.skipped) + "\">\n";
  };
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"brdf check-shader\"" + counts(all);
  for (const auto& [file, suite] : suites)
    out += "  <testsuite name=\"" + xml(file) + "\"" + counts(suite) + suite.cases + "  </testsuite>\n";
  return out + "</testsuites>\n";
}

Json to_sarif(const std::vector<Finding>& findings, const Baseline& accepted) {
  Json rules = Json::array(), results = Json::array();
  std::vector<std::string> names = check_names();
  names.insert(names.begin(), std::string(kReadable));
  for (const std::string& name : names)
    rules.push_back({{"id", name}, {"shortDescription", {{"text", meaning_of_rule(name)}}}});
  for (const Finding& f : findings)
    if (f.outcome == Outcome::fail || f.outcome == Outcome::undecided)
      results.push_back(result_of(f, accepted));
  const Json driver = {{"name", "brdf"}, {"version", io::provenance().version}, {"rules", rules}};
  Json run = {{"tool", {{"driver", driver}}}, {"results", results}, {"columnKind", "utf16CodeUnits"}};
  return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
          {"version", "2.1.0"},
          {"runs", Json::array({run})}};
}

}  // namespace brdf::validate
