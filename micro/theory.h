// Theory compared with simulation: the predictions of the forms and of their derivations, and the
// measurements by ray tracing.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "micro/goniometer.h"

namespace brdf::micro {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// One comparison. A quantity without an error or a model value has NaN there, and NaN as z.
struct TheoryRow {
  std::string surface;
  std::string quantity;
  double simulated = kNone;
  double standard_error = kNone;
  double model = kNone;
  double z = kNone;  // (simulated - model) / standard_error
  // True if the model is exact for this surface (or the law holds for any surface). A large z is then a
  // fault, not a finding.
  bool exact = false;
  // The reason for which the model is only an approximation of this surface. Empty if the model is exact or
  // if there is no comparison.
  std::string cause;
};

TheoryRow theory_row(std::string surface, std::string quantity, const Estimate& simulated, double model,
                     bool exact);

struct TheoryOptions {
  std::uint64_t seed = 1;
  int threads = int(io::all_processors());
  // Factor of the number of independent surfaces. 1 takes about half a minute on two cores.
  int effort = 1;
};

// Runs all comparisons. Progress counts the parts.
std::vector<TheoryRow> compare_with_theory(const TheoryOptions& options, const Progress& progress = {});

// Largest |z| that is permitted in an exact row. With about 100 rows from 16 surfaces, a correct run stays
// below it.
constexpr double kExactZ = 5;
// Largest absolute difference that is permitted in an exact row without a standard error (an albedo of 1;
// the share of rays lost).
constexpr double kExactShare = 1e-5;
// Returns false if an exact statement fails, and true for every row of an approximation.
bool holds(const TheoryRow& row);

// The parts of the comparison. Each takes a few seconds.
std::vector<TheoryRow> compare_slopes(const TheoryOptions& options);
std::vector<TheoryRow> compare_masking(const TheoryOptions& options);
// Compares the single reflection of a perfectly reflecting Gaussian surface of slope width alpha with the
// form of such mirrors with Smith's masking.
std::vector<TheoryRow> compare_single_bounce(const TheoryOptions& options, double alpha, Angle theta_i);
// Compares the single reflection of dielectric V-grooves with the form of V-cavities.
std::vector<TheoryRow> compare_mirror_grooves(const TheoryOptions& options, Angle theta_i);
// Compares all reflections of Lambertian V-grooves with both of Oren and Nayar's forms.
std::vector<TheoryRow> compare_lambert_grooves(const TheoryOptions& options, Angle sigma);
std::vector<TheoryRow> compare_reciprocity(const TheoryOptions& options);
// Compares the albedo of perfect reflectors with 1, for up to 64 reflections.
std::vector<TheoryRow> compare_energy(const TheoryOptions& options);

// Summary of compare_single_bounce over all cells with at least 1e-4 of the incident power.
struct CellAgreement {
  // Cells away from the retro direction. `apart` counts differences of more than 5 % beyond 2 standard
  // errors.
  int cells = 0, apart = 0;
  int retro_cells = 0, retro_apart = 0;  // within 20 degrees of the retro direction
  double power = 0, power_apart = 0;     // power in `cells` and in `apart`
  double mean_error = 0;                 // mean relative standard error of the counted cells
  double worst_retro = 0;                // largest relative excess within 20 degrees of the retro direction
  // Largest relative difference, with its sign, of a cell that is apart, and the position of that cell.
  double worst_apart = 0;
  Incidence worst_apart_at;
};
CellAgreement agreement(const Scatter& scatter, const Cells& cells, const Material& model);

}  // namespace brdf::micro
