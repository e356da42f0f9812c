#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace brdf::validate {

enum class Verdict { pass, known_violation, fail, not_applicable };

// Where the worst value was found, so that `brdf eval` or `brdf albedo` reproduces it.
struct Witness {
  std::vector<std::pair<std::string, double>> parameters;  // empty for a material: its own
  std::vector<std::pair<std::string, double>>
      angles;  // degrees: theta_i, phi_i, theta_o, phi_o or theta, phi
  std::string channel;
  std::string command;
};

// The worst of a search that was restricted to part of the parameters.
struct Restricted {
  double value;
  Witness witness;
};

// What one check found out about one subject.
struct Finding {
  std::string subject, check;
  Verdict verdict = Verdict::pass;
  double value = 0;  // the worst found
  double bound = 0;  // what it may be
  std::string statement;
  std::optional<Witness> witness;
  std::optional<Restricted> tied;  // of an anisotropic form's energy: equal widths
  long evaluations = 0;            // of the subject's f
};

std::string verdict_name(Verdict verdict);

}  // namespace brdf::validate
