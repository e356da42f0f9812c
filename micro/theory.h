// Theory against simulation: what the forms and their
// derivations say about surfaces, and what rays find on them.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "micro/goniometer.h"

namespace brdf::micro {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// One comparison. A quantity that has no error or no model value holds NaN there, and no z.
struct TheoryRow {
  std::string surface;
  std::string quantity;
  double simulated = kNone;
  double standard_error = kNone;
  double model = kNone;
  double z = kNone;  // (simulated - model) / standard_error
  // The model is exact for this surface (or the law holds for any): a large z is a fault, not a finding.
  bool exact = false;
  // Why the model is only an approximation of this surface; empty where it is exact or nothing is compared.
  std::string cause;
};

TheoryRow theory_row(std::string surface, std::string quantity, const Estimate& simulated, double model,
                     bool exact);

struct TheoryOptions {
  std::uint64_t seed = 1;
  int threads = int(io::all_processors());
  // Multiplies the number of independent surfaces; 1 takes about half a minute on two cores.
  int effort = 1;
};

// All comparisons. Progress counts the parts.
std::vector<TheoryRow> compare_with_theory(const TheoryOptions& options, const Progress& progress = {});

// |z| that an exact row may reach: with some 100 rows from 16 surfaces, a fair run stays below it.
constexpr double kExactZ = 5;
// Absolute difference that an exact row without scatter may have (an albedo of 1; the share of rays lost).
constexpr double kExactShare = 1e-5;
// False where a statement that is exact fails; true for every row of an approximation.
bool holds(const TheoryRow& row);

// The parts, each a few seconds.
std::vector<TheoryRow> compare_slopes(const TheoryOptions& options);
std::vector<TheoryRow> compare_masking(const TheoryOptions& options);
// Single reflection of a perfectly reflecting Gaussian surface of slope width alpha, against the form of such
// mirrors with Smith's masking.
std::vector<TheoryRow> compare_single_bounce(const TheoryOptions& options, double alpha, Angle theta_i);
// Single reflection of dielectric V-grooves, against the form of V-cavities.
std::vector<TheoryRow> compare_mirror_grooves(const TheoryOptions& options, Angle theta_i);
// All reflections of Lambertian V-grooves, against both of Oren and Nayar's forms.
std::vector<TheoryRow> compare_lambert_grooves(const TheoryOptions& options, Angle sigma);
std::vector<TheoryRow> compare_reciprocity(const TheoryOptions& options);
// Perfect reflectors, up to 64 reflections.
std::vector<TheoryRow> compare_energy(const TheoryOptions& options);

// What compare_single_bounce says of all cells that hold at least 1e-4 of the incident power.
struct CellAgreement {
  int cells = 0, apart = 0;  // away from the retro direction; differing by more than 5 % beyond 2 errors
  int retro_cells = 0, retro_apart = 0;  // within 20 degrees of it
  double power = 0, power_apart = 0;     // the same, weighted by projected solid angle
  double mean_error = 0;                 // mean relative standard error of the cells counted
  double worst_retro = 0;                // largest relative excess within 20 degrees of the retro direction
  double worst_apart = 0;    // largest relative difference, with its sign, of a cell that is apart,
  Incidence worst_apart_at;  // and where that cell is
};
CellAgreement agreement(const Scatter& scatter, const Cells& cells, const Material& model);

}  // namespace brdf::micro
