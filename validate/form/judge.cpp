#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/parallel.h"
#include "validate/form/checks.h"
#include "validate/joint/judge_sampler.h"
#include "validate/outside/outside_checks.h"
#include "validate/outside/rare_branches.h"

namespace brdf::validate {
namespace {

// Throws InputError if outside code declares that it violates an unknown check.
void require_known(const Subject& subject) {
  for (const Violation& v : subject.declared())
    if (std::ranges::find(kChecks, v.check, &Check::name) == std::end(kChecks))
      throw InputError(subject.name() + ": //: violates " + std::string(v.check) + ": must be one of " +
                       io::joined(check_names()));
}

bool concerns(const Check& check, const Subject& subject) {
  if (check.of == Check::Of::sampled) return subject.sampler() != nullptr;
  return check.of == Check::Of::all || subject.outside_facts() != nullptr;
}

void cut_short(Finding& finding, const Budget& budget) {
  finding.outcome = Outcome::undecided;
  finding.statement = "the search ended after " + io::short_number(budget.seconds(), 3) + " s with " +
                      std::to_string(budget.looked_at()) + " of at least " +
                      std::to_string(budget.looked_at() + budget.left_out()) +
                      " points examined; a larger --seconds examines more (so far: " + finding.statement +
                      ")";
}

std::size_t place_of(std::string_view check) {
  return std::size_t(std::ranges::find(kChecks, check, &Check::name) - std::begin(kChecks));
}

// The findings of a sampler. If the time ends, the checks that passed at the cases that were examined are
// undecided.
std::vector<Finding> sampler_findings(const Subject& subject, CheckOptions options) {
  Budget budget(options.seconds);
  options.budget = &budget;
  std::vector<Finding> findings = judge_sampler(subject, *subject.sampler(), options);
  for (Finding& f : findings)
    if (budget.left_out() > 0 && f.outcome == Outcome::pass) cut_short(f, budget);
  return findings;
}

// A declared witness with an angle beyond the limit is outside the search, so its absence proves nothing.
bool inside(const Violation& v, const CheckOptions& options) {
  return v.check != "energy" || v.theta <= options.max_theta;
}

// Returns whether the found value is a worse violation than the declared one. A declaration without a value,
// and the catalogue's, whose value belongs to one witness, permit any.
bool is_worse(const Finding& finding, const Violation& declared, const Subject& subject) {
  constexpr double kRounded = 1e-3;  // declared values have few digits
  if (!subject.is_outside() || declared.value == 0) return false;
  const double beyond = declared.value < 0 ? declared.value - finding.value : finding.value - declared.value;
  return !(beyond <= kRounded * std::abs(declared.value));
}

// Returns whether energy is conserved up to the angle at which outside code declares the violation.
bool is_later(const Finding& finding, const Violation& declared, const Subject& subject,
              const CheckOptions& options) {
  if (!subject.is_outside() || finding.check != "energy" || !(declared.theta > 0)) return false;
  CheckOptions up_to = options;
  up_to.max_theta = declared.theta;
  if (declared.theta >= options.max_theta) return false;
  const auto check = [&](const CheckOptions& own) { return check_energy(subject, own); };
  return within_seconds(up_to, check).outcome == Outcome::pass;
}

// The sentence on a violation that outside code declares.
std::string declared_text(const Violation& v) {
  return "declared" + (v.value != 0 ? " up to " + io::short_number(v.value) : "") +
         (v.theta > 0 ? " at " + io::short_number(v.theta) + " degrees" : "") +
         (v.statement.empty() ? "" : ": " + std::string(v.statement)) +
         (v.value != 0 ? "" : " (without a value, so that any violation is a known one)");
}

void judge_found(Finding& finding, const Violation& declared, const Subject& subject,
                 const CheckOptions& options) {
  finding.outcome = Outcome::known_violation;
  if (!subject.is_outside()) return;
  const bool worse = is_worse(finding, declared, subject),
             later = is_later(finding, declared, subject, options);
  if (worse || later) finding.outcome = Outcome::fail;
  finding.statement += (worse   ? "; worse than "
                        : later ? "; but not up to the angle that is "
                                : "; ") +
                       declared_text(declared);
}

void judge(Finding& finding, const Subject& subject, const CheckOptions& options) {
  if (!subject.of_form() || finding.outcome == Outcome::not_applicable ||
      finding.outcome == Outcome::undecided)
    return;
  const auto declared = subject.declared();
  const auto found =
      std::ranges::find_if(declared, [&](const Violation& v) { return v.check == finding.check; });
  if (found == declared.end()) return;
  if (finding.outcome == Outcome::fail) {
    judge_found(finding, *found, subject, options);
  } else if (inside(*found, options)) {
    finding.outcome = Outcome::fail;
    finding.statement = "a declared violation was not found: " + std::string(found->statement);
  }
}

}  // namespace

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const Check& check : kChecks) names.emplace_back(check.name);
  return names;
}

// A search that was cut short can find violations, but cannot exclude violations at the points that were
// not evaluated.
Finding within_seconds(CheckOptions options, const std::function<Finding(const CheckOptions&)>& check) {
  Budget budget(options.seconds);
  options.budget = &budget;
  Finding finding = check(options);
  if (budget.left_out() > 0 && finding.outcome == Outcome::pass) cut_short(finding, budget);
  return finding;
}

std::vector<Finding> run_checks(const std::vector<Subject>& subjects, const CheckOptions& options,
                                const io::Progress& progress) {
  for (const Subject& subject : subjects)
    if (subject.is_outside()) require_known(subject);
  constexpr std::size_t kCount = std::size(kChecks);
  const auto applies = [&](std::size_t k) { return concerns(kChecks[k % kCount], subjects[k / kCount]); };
  std::vector<Finding> findings(subjects.size() * kCount);
  // The most expensive checks run first, so that no processor is left with a long one at the end.
  const auto cost = [&](std::size_t k) {
    return kChecks[k % kCount].cost * (subjects[k / kCount].anisotropic() ? 5 : 1);
  };
  std::vector<std::size_t> order(findings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // The checks of a sampler are one job, in the place of the first.
  std::erase_if(order, [&](std::size_t k) {
    return !applies(k) || (kChecks[k % kCount].run == nullptr && k % kCount != place_of(kSamplerChecks[0]));
  });
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return cost(a) > cost(b); });
  const auto run = [&](int j) {
    const std::size_t k = order[std::size_t(j)];
    const Subject& subject = subjects[k / kCount];
    const std::size_t first = k - k % kCount;
    const auto finish = [&](std::size_t check, Finding finding) {
      finding.subject = subject.name();
      finding.check = kChecks[check].name;
      judge(finding, subject, options);
      findings[first + check] = std::move(finding);
    };
    if (kChecks[k % kCount].run != nullptr) {
      finish(k % kCount, within_seconds(options, [&](const CheckOptions& own) {
               return kChecks[k % kCount].run(subject, own);
             }));
      return k;
    }
    std::vector<Finding> together = sampler_findings(subject, options);
    for (std::size_t n = 0; n < together.size(); ++n)
      finish(place_of(kSamplerChecks[n]), std::move(together[n]));
    return k;
  };
  io::parallel_in_order(int(order.size()), int(io::all_processors()), progress, run, [](std::size_t) {});
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    if (!subjects[s].is_outside()) continue;
    const std::span own = std::span(findings).subspan(s * kCount, kCount);
    apply_voids(subjects[s], own);
    Budget budget(options.seconds);
    CheckOptions within = options;
    within.budget = &budget;
    apply_rare_branches(subjects[s], within, own);
  }
  std::vector<Finding> out;
  for (std::size_t k = 0; k < findings.size(); ++k)
    if (applies(k)) out.push_back(std::move(findings[k]));
  return out;
}

}  // namespace brdf::validate
