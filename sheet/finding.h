// The result of one check of a subject: outcome, numbers, statement, and the place of the worst value.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brdf/names.h"
#include "io/files/json.h"

namespace brdf::sheet {

// undecided: the check applies, but the data could not have shown the fault, or suggest the fault without
// proving it.
enum class Outcome { pass, known_violation, fail, not_applicable, undecided };

// The place of the worst value, with which `brdf eval` or `brdf albedo` reproduces the value. The angles
// are in degrees: theta_i, phi_i, theta_o, phi_o or theta, phi.
struct Witness {
  std::vector<std::pair<std::string, double>> parameters;  // empty for a material, which has its own
  std::vector<std::pair<std::string, double>> angles;      // degrees
  std::string channel;
  std::string command;  // empty if no command knows the subject
};

// The worst value of a search that was restricted to part of the parameters.
struct Restricted {
  double value;
  Witness witness;
};

// A row of a table that a finding is about.
struct NamedRow {
  std::size_t row;                        // from 0
  std::uint32_t line = 0;                 // in the file, from 1; 0 if the format has no lines
  double theta_i, phi_i, theta_o, phi_o;  // degrees
  std::string channel;                    // empty: the row as a whole
  double value = 0, expected = 0;         // 1/sr, of that channel
  bool apart = false;                     // beyond --max-theta: the row is named, but is no fault
};

// The result of one check of one subject.
struct Finding {
  std::string subject, check;
  Outcome outcome = Outcome::pass;
  double value = 0;  // the worst value found
  double bound = 0;  // the limit of the value
  std::string statement;
  std::optional<Witness> witness = {};
  std::optional<Restricted> tied = {};  // for the energy of an anisotropic form: with equal roughnesses
  long evaluations = 0;                 // evaluations of the subject's f
  std::vector<NamedRow> rows = {};      // for a table: all rows concerned
  // The value of each channel, if channels are judged separately.
  std::vector<std::pair<std::string, double>> channels = {};
  std::string proof = {};  // "proved" or "sampled", if the caller can prove; else empty
  // The share of the pairs inside the hemisphere at which a shader's value has the fault, from 0 to 1.
  double share = 0;
  bool is_suspicion = false;  // for an undecided finding: names the fault that the data suggest

  // Sets the outcome to pass or fail, and the statement that belongs to it.
  void conclude(bool good, const std::string& if_good, const std::string& if_not) {
    outcome = good ? Outcome::pass : Outcome::fail;
    statement = good ? if_good : if_not;
  }
};

// Returns whether a report shows the place of the worst value: only if the property does not hold.
inline bool shows_witness(const Finding& f) {
  return f.witness && (f.outcome == Outcome::fail || f.outcome == Outcome::known_violation);
}

// The end of a statement about sampled pairs of directions.
inline constexpr std::string_view kAtPairsTried = ", at the pairs tried";

// Returns the statement, followed by "proved" or "sampled" if that is known. The statement of a proved
// property loses kAtPairsTried, which would contradict "proved".
inline std::string said(const Finding& f) {
  if (f.proof.empty()) return f.statement;
  std::string text = f.statement;
  if (const std::size_t at = text.find(kAtPairsTried); f.proof == "proved" && at != text.npos)
    text.erase(at, kAtPairsTried.size());
  return text + (f.proof == "proved" ? "; proved" : "; sampled");
}

// Returns whether this value is worse than the worst so far. NaN is the worst of all and is never replaced.
inline bool is_worst(double value, double worst) {
  return !std::isnan(worst) && !(value < worst);
}

// Returns findings as JSON.
io::Json to_json(const Finding& finding);
io::Json to_json(const std::vector<Finding>& findings);

// Returns the finding of a check that does not apply, with the reason `why`.
inline Finding not_applicable(std::string subject, std::string check, std::string why) {
  return {.subject = std::move(subject),
          .check = std::move(check),
          .outcome = Outcome::not_applicable,
          .statement = std::move(why)};
}

}  // namespace brdf::sheet

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 5> kNames<sheet::Outcome>{"pass", "known_violation", "fail",
                                                                        "not_applicable", "undecided"};

}  // namespace brdf
