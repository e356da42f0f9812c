// Statements about forms over their whole domain, and the search for their proofs.
#pragma once

#include <array>
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

// A place at which the property fails, with the command of this program that shows the failure.
struct Witness {
  std::vector<std::pair<std::string, double>> parameters;  // of one channel, by name
  std::vector<std::pair<std::string, double>> angles;      // degrees, by name
  double value = 0;                                        // the value that `command` prints there
  std::string command;
  int violation = -1;  // for a form of the catalogue: the index of the declared violation
};

struct Proof {
  Claim claim{};
  std::string form{};
  std::string material{}, channel{};  // for the proof of a material: its file
  Verdict verdict = Verdict::no_method;
  std::string arithmetic{};  // the kind of numbers for which the property holds
  std::string statement{};   // one sentence
  double low = 0, high = 0;
  std::optional<Domain> domain{};
  Cover cover{};
  std::optional<Witness> witness{};
  std::vector<LobeRounding> lobes{};  // for rounding
  std::optional<Growth> growth{};     // for a refuted energy
  std::vector<Proof> terms{};         // for a material: each term alone
  std::optional<Views> low_at{};      // for the energy of a material: the view that reaches `low`
  double seconds = 0;
};

struct Options {
  SearchOptions search;
  // The gap between a witness of energy and the bound that is searched for.
  double gap = 1e-5;
  std::vector<Property> properties{kAll.begin(), kAll.end()};
  static constexpr std::array kAll{Property::finite, Property::non_negative, Property::reciprocity,
                                   Property::energy, Property::rounding};
};

// Proves all requested properties of a form of the catalogue: finite, non_negative and rounding in float
// and in double, the others once.
std::vector<Proof> prove(const Reflectance& form, const Options& options);

// Proves the properties of the channels of a material at their parameters. For energy, this is the largest
// directional albedo to 1e-3, if the integral is known. `file` is named in the statements.
std::vector<Proof> prove(const Material& material, const std::string& file, const Options& options);

// The properties of single values, which need neither an integral nor rounding errors.
inline constexpr std::array kPropertiesOfValues{Property::finite, Property::non_negative,
                                                Property::reciprocity};

// Proves the properties of single values of a material. A program that calls this function alone, such as
// the page for browsers, contains no other method of proof.
std::vector<Proof> prove_values(const Material& material, const std::string& file,
                                const SearchOptions& search);

// Proves that the formula of a form is symmetric in its directions.
Proof prove_reciprocity(const Reflectance& form);

// Returns a place that shows a declared violation: a direction in which f is negative, or an albedo that
// exceeds 1 by more than the error bound of the integral. Returns std::nullopt if no violation is declared
// or found.
std::optional<Witness> find_negative(const Reflectance& form);
std::optional<Witness> find_gain(const Reflectance& form);

}  // namespace brdf::prove

template <>
inline constexpr std::array<std::string_view, 3> brdf::kNames<brdf::prove::LobeRounding::Beside>{
    "value", "peak", "nothing"};
