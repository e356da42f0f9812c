// Checks whether the values of outside code are finite, and whether its language defines them.
#include <algorithm>
#include <cmath>
#include <map>

#include "io/files/numbers.h"
#include "io/files/text.h"
#include "validate/outside/outside_checks.h"
#include "validate/search/special_pairs.h"

namespace brdf::validate {
namespace {

// Counts the faults at pairs of one kind and keeps the first witness.
struct Met {
  long pairs = 0, faults = 0;
  std::optional<Witness> witness;
  std::map<std::string, long> reasons;  // by the source line that causes the fault

  void add(const std::string& reason) {
    ++faults;
    ++reasons[reason];
  }
  double part() const { return pairs == 0 ? 0 : double(faults) / double(pairs); }
  std::string share() const { return io::percent(part(), 3); }
};

// A test that runs at every pair. Returns the reason of a fault in words, or std::nullopt if there is no
// fault.
using Question = std::function<std::optional<std::string>(const Material&, const Pair&)>;

struct Survey {
  std::array<Met, 3> met;  // by Where
  long evaluations = 0;

  Met& at(Where where) { return met[std::size_t(where)]; }
  const Met& at(Where where) const { return met[std::size_t(where)]; }
  long above() const { return at(Where::inside).faults + at(Where::coincident).faults; }
};

// Points at which the parameters are taken: the subject's own, corners, and a cover of the interior.
std::vector<Material> materials_of(const Subject& subject, std::size_t cover, std::uint64_t seed) {
  std::vector<Material> out{subject.own()};
  for (const auto& corner : cube_corners(subject.dimensions(), 5)) out.push_back(subject.at(corner));
  for (std::size_t k = 0; subject.dimensions() > 0 && k < cover; ++k)
    out.push_back(subject.at(cover_point(k, subject.dimensions(), seed)));
  return out;
}

Survey survey(const Subject& subject, const std::vector<Material>& materials,
              const std::vector<PlacedPair>& pairs, Budget* budget, const Question& ask) {
  Survey s;
  for (const Material& m : materials)
    for (const PlacedPair& p : pairs) {
      if (budget && !budget->take()) continue;
      Met& met = s.at(p.where);
      ++met.pairs;
      ++s.evaluations;
      const auto reason = ask(m, p.pair);
      if (!reason) continue;
      met.add(*reason);
      if (!met.witness) met.witness = pair_witness(subject, m, p.pair);
    }
  return s;
}

// The reasons, the most frequent first, each once.
std::string reasons_of(const Met& met) {
  std::vector<std::pair<long, std::string>> by_count;
  for (const auto& [reason, count] : met.reasons)
    if (!reason.empty()) by_count.emplace_back(-count, reason);
  std::ranges::sort(by_count);
  constexpr std::size_t kMost = 3;
  std::vector<std::string> words;
  for (std::size_t k = 0; k < std::min(kMost, by_count.size()); ++k) words.push_back(by_count[k].second);
  if (by_count.size() > kMost) words.push_back(std::to_string(by_count.size() - kMost) + " more lines");
  return words.empty() ? "" : ": " + io::joined(words, "; ");
}

// Describes the faults above the horizon and at the horizon separately.
std::string places(const Survey& s, bool above) {
  std::vector<std::string> parts;
  const Met &inside = s.at(Where::inside), &coincident = s.at(Where::coincident),
            &horizon = s.at(Where::horizon);
  if (inside.faults > 0)
    parts.push_back("at " + inside.share() + " of the pairs inside the hemisphere" + reasons_of(inside));
  if (coincident.faults > 0)
    parts.push_back("at " + coincident.share() +
                    " of the pairs that coincide, are mirror directions or include the normal" +
                    reasons_of(coincident));
  if (horizon.faults > 0 && !above) parts.push_back("at the exact horizon" + reasons_of(horizon));
  return io::joined(parts, "; and ");
}

const std::optional<Witness>& first_witness(const Survey& s) {
  for (const Where where : {Where::inside, Where::coincident})
    if (s.at(where).witness) return s.at(where).witness;
  return s.at(Where::horizon).witness;
}

Finding finding_of(const Subject& subject, std::string check, const Survey& s) {
  Finding finding{subject.name(), std::move(check)};
  finding.value = double(s.above());
  finding.evaluations = s.evaluations;
  finding.witness = first_witness(s);
  return finding;
}

}  // namespace

Finding check_outside_finite(const Subject& subject, const CheckOptions& options) {
  const bool full = options.effort == Effort::full;
  bool all_zero = true;
  const Survey s = survey(subject, materials_of(subject, full ? 96 : 16, options.seed),
                          placed_pairs(full ? 2048 : 256, full ? 1024 : 160, options.seed), options.budget,
                          [&](const Material& m, const Pair& p) -> std::optional<std::string> {
                            std::vector<double> f(m.channels.size()), f_cos(f.size());
                            eval(m, p.wi, p.wo, f);
                            eval_cos(m, p.wi, p.wo, f_cos);
                            bool finite = true;
                            for (std::size_t c = 0; c < f.size(); ++c) {
                              finite = finite && std::isfinite(f[c]) && std::isfinite(f_cos[c]);
                              all_zero = all_zero && f[c] == 0;
                            }
                            if (finite) return std::nullopt;
                            const OutsideFacts& facts = *subject.outside_facts();
                            if (facts.undefined && !facts.undefined(m, p.wi, p.wo).empty())
                              return std::nullopt;  // reported by check_undefined()
                            return facts.explain ? facts.explain("finite", m, p.wi, p.wo) : "";
                          });
  Finding finding = finding_of(subject, "finite", s);
  finding.share = s.at(Where::inside).part();
  finding.conclude(s.above() == 0, "every value inside the hemisphere is finite, at the pairs tried",
                   "f is not finite " + places(s, true));
  if (s.at(Where::horizon).faults > 0)
    finding.statement += "; at the exact horizon f is not finite" + reasons_of(s.at(Where::horizon));
  if (s.above() == 0) finding.witness.reset();
  if (all_zero) {
    finding.outcome = Outcome::undecided;
    finding.statement = std::string(kVacuous) + "f is 0 at all pairs and parameters that were tried";
  }
  return finding;
}

Finding check_undefined(const Subject& subject, const CheckOptions& options) {
  const OutsideFacts* facts = subject.outside_facts();
  if (!facts || !facts->undefined)
    return not_applicable(subject.name(), "undefined", "the subject is not a shader");
  const bool full = options.effort == Effort::full;
  const Survey s = survey(subject, materials_of(subject, full ? 48 : 6, options.seed),
                          placed_pairs(full ? 1024 : 128, full ? 512 : 48, options.seed), options.budget,
                          [&](const Material& m, const Pair& p) -> std::optional<std::string> {
                            std::string text = facts->undefined(m, p.wi, p.wo);
                            return text.empty() ? std::nullopt : std::optional(std::move(text));
                          });
  Finding finding = finding_of(subject, "undefined", s);
  finding.share = s.at(Where::inside).part();
  finding.conclude(s.above() == 0,
                   "no value depends on undefined operations of the language, at the pairs tried",
                   "the value is undefined by the language " + places(s, true));
  if (s.at(Where::horizon).faults > 0)
    finding.statement += "; at the exact horizon the value is undefined" + reasons_of(s.at(Where::horizon));
  return finding;
}

namespace {

bool passes(const Finding& f) {
  return f.outcome == Outcome::pass || f.outcome == Outcome::known_violation;
}

void void_it(Finding& f, const std::string& why) {
  f.outcome = Outcome::undecided;
  f.statement = "undecided: " + why + " (the check reported: " + f.statement + ")";
  f.witness.reset();
}

// The pair that a finding's witness names, if there is one.
std::optional<Pair> pair_of_witness(const Finding& f) {
  if (!f.witness || f.witness->angles.size() != 4) return std::nullopt;
  const auto& a = f.witness->angles;
  return pair_at_angles(a[0].second, a[1].second, a[2].second, a[3].second);
}

// The subject with the witness's parameters.
Material at_witness(const Subject& subject, const Witness& w) {
  Material m = subject.own();
  if (!subject.of_form()) return m;  // a material has only its own parameters
  const ReflectanceInfo& f = info(*subject.of_form());
  for (const auto& [name, value] : w.parameters) {
    const int shape = f.shape_index(name), weight = f.weight_index(name);
    if (shape >= 0) m.terms.front().shape.front()[std::size_t(shape)] = value;
    if (weight >= 0)
      for (auto& weights : m.terms.front().weights) weights[std::size_t(weight)] = value;
  }
  return m;
}

}  // namespace

void apply_voids(const Subject& subject, std::span<Finding> findings) {
  const OutsideFacts* facts = subject.outside_facts();
  const auto find = [&](std::string_view check) -> Finding& {
    return *std::ranges::find_if(findings, [&](const Finding& f) { return f.check == check; });
  };
  Finding &finite = find("finite"), &undefined = find("undefined"), &negative = find("non_negative");
  // A value below 0 that another check has met.
  for (const Finding& f : findings) {
    const auto pair = pair_of_witness(f);
    if (!pair || negative.outcome == Outcome::fail) continue;
    const Material m = at_witness(subject, *f.witness);
    std::vector<double> values(m.channels.size());
    eval(m, pair->wi, pair->wo, values);
    const double least = *std::ranges::min_element(values);
    if (!(least < -1e-12) || !std::isfinite(least)) continue;
    if (facts->in_more_digits && !std::ranges::any_of(facts->in_more_digits(m, pair->wi, pair->wo),
                                                      [](double x) { return x < -1e-12; }))
      continue;
    negative.value = least;
    negative.witness = pair_witness(subject, m, *pair);
    negative.conclude(false, "",
                      "f down to " + io::short_number(least, 3) + " /sr, found by the check of " + f.check +
                          subject.explained("non_negative", m, pair->wi, pair->wo));
  }
  // A failure at an undefined value decides nothing, nor does a pass if a share of the values is undefined.
  if (facts->undefined)
    for (Finding& f : findings) {
      if (&f == &undefined || f.outcome != Outcome::fail) continue;
      const auto pair = pair_of_witness(f);
      if (!pair) continue;
      const std::string text = facts->undefined(at_witness(subject, *f.witness), pair->wi, pair->wo);
      if (!text.empty()) void_it(f, "the value is undefined there: " + text);
    }
  if (undefined.outcome == Outcome::fail && undefined.share > 0)
    for (Finding& f : findings)
      if (&f != &undefined && passes(f)) void_it(f, "some values are undefined, see the check undefined");
  // Integrals lack these values, and a comparison with a value that is not a number finds no difference.
  if (finite.outcome == Outcome::fail && finite.share > 0)
    for (Finding& f : findings)
      if (&f != &undefined && passes(f)) void_it(f, "some values are not finite, see the check finite");
  if (finite.statement.starts_with(kVacuous))
    for (Finding& f : findings)
      if (&f != &finite && passes(f)) f.outcome = Outcome::undecided, f.statement = finite.statement;
}

}  // namespace brdf::validate
