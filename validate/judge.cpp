#include <algorithm>
#include <cmath>
#include <sstream>

#include "validate/checks.h"
#include "validate/parallel.h"

namespace brdf::validate {
namespace {

struct NamedCheck {
  const char* name;
  Finding (*run)(const Subject&, const CheckOptions&);
};

constexpr NamedCheck kChecks[] = {
    {"finite", check_finite},
    {"non_negative", check_non_negative},
    {"reciprocity", check_reciprocity},
    {"energy", check_energy},
    {"albedo", check_albedo},
    {"normalisation", check_normalisation},
    {"white_furnace", check_white_furnace},
    {"isotropy", check_isotropy},
    {"continuity", check_continuity},
    {"sampling", check_sampling},
    {"derivatives", check_derivatives},
};

// A witness that the search could not meet proves nothing: its angle lies beyond the limit.
bool inside(const Violation& v, const CheckOptions& options) {
  return v.check != "energy" || v.theta <= options.max_theta;
}

void judge(Finding& finding, const Subject& subject, const CheckOptions& options) {
  if (!subject.of_form() || finding.verdict == Verdict::not_applicable) return;
  const auto declared = subject.declared();
  const auto found = std::find_if(declared.begin(), declared.end(),
                                  [&](const Violation& v) { return v.check == finding.check; });
  if (found == declared.end()) return;
  if (finding.verdict == Verdict::fail) {
    finding.verdict = Verdict::known_violation;
  } else if (inside(*found, options)) {
    finding.verdict = Verdict::fail;
    finding.statement = "declared, but not found: " + std::string(found->statement);
  }
}

}  // namespace

std::string verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::known_violation:
      return "known_violation";
    case Verdict::fail:
      return "fail";
    case Verdict::not_applicable:
      break;
  }
  return "not_applicable";
}

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const NamedCheck& check : kChecks) names.push_back(check.name);
  return names;
}

std::vector<Finding> run_checks(const std::vector<Subject>& subjects, const CheckOptions& options) {
  constexpr std::size_t kCount = std::size(kChecks);
  std::vector<Finding> findings(subjects.size() * kCount);
  // The dear ones first, so that no processor is left alone with one at the end.
  std::vector<std::size_t> order;
  for (const bool dear : {true, false})
    for (std::size_t k = 0; k < findings.size(); ++k)
      if ((kChecks[k % kCount].run == check_energy) == dear) order.push_back(k);
  parallel_for(order.size(), [&](std::size_t j) {
    const std::size_t k = order[j];
    const Subject& subject = subjects[k / kCount];
    findings[k] = kChecks[k % kCount].run(subject, options);
    judge(findings[k], subject, options);
  });
  return findings;
}

}  // namespace brdf::validate
