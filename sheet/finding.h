#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brdf/names.h"
#include "io/files/json.h"

namespace brdf::sheet {

// undecided: the check applies, and the data could not have shown the fault, or suggest it without proving
// it.
enum class Outcome { pass, known_violation, fail, not_applicable, undecided };

// Where the worst value was found, so that `brdf eval` or `brdf albedo` reproduces it.
struct Witness {
  std::vector<std::pair<std::string, double>> parameters;  // empty for a material: its own
  std::vector<std::pair<std::string, double>>
      angles;  // degrees: theta_i, phi_i, theta_o, phi_o or theta, phi
  std::string channel;
  std::string command;  // empty where no command knows the subject
};

// The worst of a search that was restricted to part of the parameters.
struct Restricted {
  double value;
  Witness witness;
};

// A row of a table that a finding is about.
struct NamedRow {
  std::size_t row;                        // from 0
  std::uint32_t line = 0;                 // in the file, from 1; 0 where the format has none
  double theta_i, phi_i, theta_o, phi_o;  // degrees
  std::string channel;                    // empty: the row as a whole
  double value = 0, expected = 0;         // 1/sr, of that channel
  bool apart = false;                     // beyond --max-theta: named, and no fault
};

// What one check found out about one subject.
struct Finding {
  std::string subject, check;
  Outcome outcome = Outcome::pass;
  double value = 0;  // the worst found
  double bound = 0;  // what it may be
  std::string statement;
  std::optional<Witness> witness = {};
  std::optional<Restricted> tied = {};                        // of an anisotropic form's energy: equal widths
  long evaluations = 0;                                       // of the subject's f
  std::vector<NamedRow> rows = {};                            // of a table: all of them
  std::vector<std::pair<std::string, double>> channels = {};  // the value of each, judged by channels
  std::string proof = {};  // "proved" or "sampled", where somebody who can prove has looked
  // Of the pairs inside the hemisphere: at how many a shader's value has the fault, from 0 to 1.
  double share = 0;
  bool is_suspicion = false;  // of an undecided one: it names the fault that the data suggest

  // Passes or fails, and says why.
  void conclude(bool good, const std::string& if_good, const std::string& if_not) {
    outcome = good ? Outcome::pass : Outcome::fail;
    statement = good ? if_good : if_not;
  }
};

// Whether a report shows where it was found: of what does not hold.
inline bool shows_witness(const Finding& f) {
  return f.witness && (f.outcome == Outcome::fail || f.outcome == Outcome::known_violation);
}

// The statement, and whether it is proved.
inline std::string said(const Finding& f) {
  return f.proof.empty() ? f.statement : f.statement + (f.proof == "proved" ? "; proved" : "; sampled");
}

// Whether this value is worse than the worst so far; one that is no number is the worst of all, and stays.
inline bool is_worst(double value, double worst) {
  return !std::isnan(worst) && !(value < worst);
}

io::Json to_json(const Finding& finding);
io::Json to_json(const std::vector<Finding>& findings);

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
