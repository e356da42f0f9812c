// Statements about forms over their whole domain, and the search for them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brdf/material.h"
#include "prove/check/claim.h"
#include "prove/growth_proof.h"
#include "prove/scalar/rounding.h"
#include "prove/scalar/views.h"
#include "prove/search.h"

namespace brdf::prove {

// Where the property fails, as the program's other verbs show it.
struct Witness {
  std::vector<std::pair<std::string, double>> parameters;  // of one channel, by name
  std::vector<std::pair<std::string, double>> angles;      // degrees, by name
  double value = 0;                                        // what `command` prints there
  std::string command;
  int violation = -1;  // of a form of the catalogue: which of those that it declares
};

struct Proof {
  Claim claim{};
  std::string form{};
  std::string material{}, channel{};  // the file, of a material's proof
  Verdict verdict = Verdict::no_method;
  std::string arithmetic{};  // in which numbers it holds
  std::string statement{};   // one sentence
  double low = 0, high = 0;
  std::optional<Domain> domain{};
  Cover cover{};
  std::optional<Witness> witness{};
  std::vector<LobeRounding> lobes{};  // of rounding
  std::optional<Growth> growth{};     // of a refuted energy
  std::vector<Proof> terms{};         // of a material: each term alone
  std::optional<Views> low_at{};      // of a material's energy: the view that has `low`
  double seconds = 0;
};

struct Options {
  SearchOptions search;
  double gap = 1e-5;  // between a witness of energy and the bound that is searched for
  std::vector<Property> properties{kAll.begin(), kAll.end()};
  static constexpr std::array kAll{Property::finite, Property::non_negative, Property::reciprocity,
                                   Property::energy, Property::rounding};
};

// All that is asked for of a form of the catalogue; finite, non_negative and rounding in float and in double.
std::vector<Proof> prove(const Reflectance& form, const Options& options);

// The same of a material's channels at their parameters; energy: its largest directional albedo to 1e-3,
// where the integral is known. `file` is named in what is said.
std::vector<Proof> prove(const Material& material, const std::string& file, const Options& options);

// Where a declared violation shows: a direction in which f is negative, an albedo above 1 by more than the
// integral's error bound. None where none is declared or found.
std::optional<Witness> find_negative(const Reflectance& form);
std::optional<Witness> find_gain(const Reflectance& form);

}  // namespace brdf::prove

template <>
inline constexpr std::array<std::string_view, 3> brdf::kNames<brdf::prove::LobeRounding::Beside>{
    "value", "peak", "nothing"};
