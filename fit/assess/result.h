// What a fit found: for every model its material, and how well it is known.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "brdf/names.h"
#include "fit/algebra/matrix.h"

namespace brdf::fit {

enum class Verdict { converged, at_bound, not_identifiable, misfit, diverged, interrupted };
enum class Status { free, fixed, at_bound, unidentified };  // of one parameter

}  // namespace brdf::fit

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 6> kNames<fit::Verdict>{
    "converged", "at_bound", "not_identifiable", "misfit", "diverged", "interrupted"};
template <>
inline constexpr std::array<std::string_view, 4> kNames<fit::Status>{"free", "fixed", "at_bound",
                                                                     "unidentified"};

}  // namespace brdf

namespace brdf::fit {

// Whether parameters may be used (exit code 0): converged, or at_bound with its warning.
inline bool usable(Verdict verdict) {
  return verdict == Verdict::converged || verdict == Verdict::at_bound;
}

// How one reported parameter is known.
struct Estimate {
  Status status = Status::free;
  std::string name;     // as in the material: alpha_x, kd; terms[1].ks in a sum
  std::string channel;  // empty: shared by all channels
  double value = 0;     // tangent_phi in degrees
  double standard_error = 0;
  double low = 0, high = 0;  // 95 %
};

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// Root mean square of the four residuals in use, each over the values it is defined for.
struct Metrics {
  double log = kUnknown, cosine_l2 = kUnknown, log_relative = kUnknown;
  double cube_root = kUnknown;  // mean of (((f - g) c_i)^2)^(1/3)
};

struct MinimumReport {
  double cost;
  int basin;
  Material material;
};

struct Correlations {
  std::vector<std::string> names;  // free parameters
  Matrix matrix;
};

struct FormFit {
  std::string form;  // "ward", "oren_nayar+ward"
  Verdict verdict = Verdict::diverged;
  std::vector<std::string> findings;  // sentences, the verdict's reason first
  Material material;
  double median_relative_error = kUnknown;
  Metrics metrics;
  std::optional<double> cross_validated_error;           // median relative error of rows left out
  std::optional<double> cross_validated_standard_error;  // over the folds
  double bic = kUnknown;                                 // of the chosen residual: n ln(mean r^2) + p ln n
  std::size_t parameters = 0;
  std::vector<Estimate> estimates;
  Correlations correlations;
  double condition = 0;  // of the scaled normal matrix
  double loss_scale = 0;
  std::vector<MinimumReport> minima;
  int starts = 0, iterations = 0, passes = 0;
  std::string solver_message;

  // Some start gave a finite cost. Otherwise the material is the form's defaults, and no error is known.
  bool solved() const { return !minima.empty(); }
};

struct FitResult {
  std::size_t rows = 0, beyond_max_theta = 0, outside_domain = 0;
  std::vector<std::string> channels;
  std::optional<double> noise_floor;  // relative, from neighbouring rows
  std::vector<FormFit> ranking;       // best first: by cross-validated (else median) error
  std::size_t recommended = 0;        // the simplest usable one within the noise of the best
  bool interrupted = false;
};

}  // namespace brdf::fit
