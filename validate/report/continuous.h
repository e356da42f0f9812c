// Findings for continuous integration: a list of accepted findings, and the formats JUnit and SARIF.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/files/json.h"
#include "validate/search/finding.h"

namespace brdf::validate {

// The check of a file that cannot be judged: its finding fails, with the reason as its statement.
inline constexpr std::string_view kReadable = "readable";

// Findings that a project has accepted, by file and check. The other parts of a finding, such as its value,
// may change.
class Baseline {
 public:
  using Entry = std::pair<std::string, std::string>;  // file and check
  Baseline() = default;
  // Throws InputError, with the place in the file, if `json` was not written by to_json().
  explicit Baseline(const io::Json& json, const std::string& name);
  // Returns the list with the failed findings of these files, and with its own entries of other files and of
  // checks that could not decide.
  Baseline updated(const std::vector<Finding>& findings) const;

  bool accepts(const Finding& finding) const { return entries_.contains({finding.subject, finding.check}); }
  // Returns the accepted findings of these files that no longer fail.
  std::vector<Entry> obsolete(const std::vector<Finding>& findings) const;
  io::Json to_json() const;

 private:
  std::set<Entry> entries_;
};

// Returns whether a finding fails and is not accepted.
bool is_new(const Finding& finding, const Baseline& accepted);

// Returns the findings as JUnit's XML: a suite per file, a case per check that applies. An accepted or
// undecided case is skipped, with the reason.
std::string to_junit(const std::vector<Finding>& findings, const Baseline& accepted);

// Returns the findings as a log of SARIF 2.1.0 (OASIS 2020): the failed and the undecided ones, with the
// source line if a finding names one, and whether they are new.
io::Json to_sarif(const std::vector<Finding>& findings, const Baseline& accepted);

}  // namespace brdf::validate
