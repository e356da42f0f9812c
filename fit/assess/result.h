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
#include "fit/assess/half_angles.h"
#include "fit/assess/metric_choice.h"
#include "fit/model/row_groups.h"
#include "sheet/data_sheet.h"

namespace brdf::fit {

enum class Verdict {
  converged,
  at_bound,
  determined,
  not_identifiable,
  misfit,
  breaks_energy,  // reflects more than it receives at an angle of the light that was measured
  diverged,
  interrupted
};
// Where intervals come from: the curvature of the cost at its minimum, clipped to the ranges, which is
// approximate, or the cost's profile within the bounds.
enum class IntervalsBy { curvature, profile };
enum class Status { free, fixed, at_bound, unidentified };  // of one parameter

}  // namespace brdf::fit

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 8> kNames<fit::Verdict>{
    "converged", "at_bound",      "determined", "not_identifiable",
    "misfit",    "breaks_energy", "diverged",   "interrupted"};
template <>
inline constexpr std::array<std::string_view, 2> kNames<fit::IntervalsBy>{"curvature", "profile"};
template <>
inline constexpr std::array<std::string_view, 4> kNames<fit::Status>{"free", "fixed", "at_bound",
                                                                     "unidentified"};

}  // namespace brdf

namespace brdf::fit {

// Whether the material may be used (exit code 0): converged, at_bound with its warning, or determined, where
// weights share what the samples do not divide between them, and every prediction is known.
inline bool usable(Verdict verdict) {
  return verdict == Verdict::converged || verdict == Verdict::at_bound || verdict == Verdict::determined;
}

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Extent {
  double low = kUnknown, high = kUnknown;
};

// How one reported parameter is known.
struct Estimate {
  Status status = Status::free;
  std::string name;     // as in the material: alpha_x, kd; terms[1].ks in a sum
  std::string channel;  // empty: shared by all channels
  double value = 0;     // tangent_phi in degrees
  double standard_error = 0;
  double freedom = 0;  // degrees of freedom of its variance
  double deciding =
      kUnknown;  // how many values decide it: 1 over the sum of their squared shares of its variance
  double low = kUnknown, high = kUnknown;  // 95 %: of the values' scatter, the model taken as right
  // An end where only the range of the parameter stops the interval, or where the samples never speak against
  // what lies beyond: low and high are the range's limits then.
  bool low_open = true, high_open = true;
  // The others are of free parameters. 95 %, whatever the model's lack of fit: from how far the parameter
  // moves as folds of incidences are left out; never inside the first.
  Extent with_lack_of_fit;
  Extent left_out, other_metrics;  // where it is without each fold, and under each of the other metrics
  // Of bootstrap replicates, where there are any: their 95 %, and their standard deviation.
  Extent bootstrap;
  double bootstrap_error = kUnknown;
};

// Root mean square of the four residuals in use, each over the values it is defined for.
struct Metrics {
  double log = kUnknown, cosine_l2 = kUnknown, log_relative = kUnknown;
  double cube_root = kUnknown;  // mean of (((f - g) c_i)^2)^(1/3)
};

// Relative, over the measured values above 0.
struct RelativeErrors {
  double median = kUnknown, ninth_decile = kUnknown;  // of |model - value|/value
  double off_by_two = kUnknown;  // share of the light that is off by more than a factor of two
};

// What a form predicts of rows that it was not fitted to.
struct LeftOut {
  double value = kUnknown;       // mean of the loss that was minimised, rho(r^2), over the values left out
  std::vector<double> by_group;  // the same for every group of rows
  RelativeErrors errors;
  double median_standard_error = 0;            // of errors.median, over the folds
  std::vector<std::vector<double>> solutions;  // [fold] the solver's parameters, without that fold's rows
};

// A cell of half angles where the residual is large.
struct WorstRegion {
  HalfAngleRange range;
  std::size_t rows = 0;
  double ratio = 1;  // measured over modelled, in the middle
  double share = 0;  // of what was minimised
};

struct LackOfFit {
  static constexpr std::size_t kMostOthers = 3;
  // Normalised median deviation of ln(measured/model) over the noise.
  std::optional<double> residual_over_scatter;
  std::optional<WorstRegion> worst;
  std::vector<WorstRegion> others;  // that are off beyond the scatter too, by their share
  bool beyond_scatter = false;      // the residual is 1.3 times the scatter, or some cell is off beyond it
  bool exact = false;               // the residual is rounding

  // Whether anything says how good is good enough.
  bool judged() const { return exact || residual_over_scatter.has_value(); }
};

// A shape over wavelength: the scale of a parameter as a polynomial in x = 1000 nm / wavelength.
struct SmoothCurve {
  std::string parameter;  // alpha, terms[1].alpha
  std::string scale;      // of what it is a polynomial: "ln", "ln1p", "square", "identity"
  std::vector<double> coefficients, standard_errors;  // by powers of x
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

// Of what a fit determines of a material's parameters, identified or not, as a sum over components that vary
// independently of each other; what is held, at a bound and without effect is not in it.
struct ParameterCovariance {
  std::vector<std::string> names;  // as options name them: alpha, kd[r], terms[1].f0; tangent_phi in degrees
  Matrix components;               // [component][parameter]: the covariance is their transpose times them
  std::vector<double> freedom;     // [component]: degrees of freedom of its variance
};

// The largest directional albedo over the angles of the light.
struct LargestAlbedo {
  double value, theta;  // degrees
  std::string channel;

  // More than all of the light, beyond the integral's own error.
  static constexpr double kMost = 1 + 2e-3;
  bool breaks_energy() const { return value > kMost; }
};

// The material at an end of a parameter's interval: as good a description of the samples as the interval
// says. Where the end is open, so are materials beyond.
struct MaterialAtEnd {
  Material material;
  bool open = false;
};

// What the samples let a fit say, whatever its form.
struct Context {
  std::optional<double> scatter;  // relative
  bool interpolated = false;      // that scatter is an instrument's software's: rows were interpolated
  HeldOut held_out = HeldOut::many;
  std::size_t lights = 0;  // or viewers, or cells of directions: what was left out one by one
  std::string side;        // "incidences"
  // Width of the narrowest highlight (Ward's alpha) that a sample would show: a narrower one may lie between
  // them; none: no highlight may.
  std::optional<double> hidden_width;
};

struct FormFit {
  Context about;
  std::string form;  // "ward", "oren_nayar+ward"
  Verdict verdict = Verdict::diverged;
  std::vector<std::string> findings;  // sentences, the verdict's reason first
  Material material;
  double median_relative_error = kUnknown;
  RelativeErrors errors;
  LackOfFit lack_of_fit;
  Metrics metrics;
  std::optional<LeftOut> left_out;  // none: not asked for, interrupted, or a single direction
  std::size_t replicates = 0;       // of the bootstrap
  double bic = kUnknown;            // of the chosen residual: n ln(mean r^2) + p ln n
  std::size_t parameters = 0;
  std::vector<Estimate> estimates;
  bool light_is_off = false;    // a misfit by the share of the light that is in the wrong place
  std::string few_rows_decide;  // which parameters few rows decide, and which rows; empty: none
  bool has_free_scale = false;  // the samples are uncalibrated: nothing is known of energy
  IntervalsBy intervals = IntervalsBy::curvature;
  std::vector<MaterialAtEnd> ends;  // of profiles
  std::vector<SmoothCurve> smooth;  // of --shape smooth
  Correlations correlations;
  std::optional<ParameterCovariance> covariance;  // none where some direction has no effect at all
  std::optional<double> prediction_error;  // relative standard error of what the model gives at the samples
  std::optional<LargestAlbedo> largest_albedo;
  std::optional<LargestAlbedo> largest_measured_albedo;  // over the angles of the light that were measured
  double condition = 0;                                  // of the scaled normal matrix
  double loss_scale = 0;
  std::vector<MinimumReport> minima;
  int starts = 0, iterations = 0, passes = 0;
  std::string solver_status;   // the optimiser's own: converged, iteration_limit, failed, interrupted
  std::string solver_message;  // and its words

  // Some start gave a finite cost. Otherwise the material is the form's defaults, and no error is known.
  bool solved() const { return !minima.empty(); }
};

// What --form auto added, or tried to add, to the model of the step before.
struct Step {
  std::string added;          // "a second lobe"
  std::string model;          // the one tried
  double left_out = 0;        // its value
  double difference = 0;      // by which that is below the one of the model so far
  double standard_error = 0;  // of the difference, from the scatter between groups
  double p = 1;               // one-sided, of a fall like this by chance, for all that were tried together
  std::size_t tried = 1;
  bool kept = false;
  // Not kept though it would halve the error: the incidences cannot tell that from chance.
  bool refused_halving() const { return !kept && difference > left_out; }
};

struct FitResult {
  std::size_t rows = 0, beyond_max_theta = 0, outside_domain = 0;
  std::vector<std::string> channels;
  sheet::DataSheet sheet;  // of the samples as they were read; empty of a table that a program made
  MetricChoice metric;     // the residual in use
  std::optional<double> noise_floor;  // relative, from the table itself (io/samples/noise.h)
  std::vector<std::optional<double>> channel_noise;
  RowGroups groups;              // what was left out together
  double left_out_rounding = 0;  // left-out values below are 0 but for rounding
  std::vector<Step> steps;       // of --form auto; empty otherwise
  std::vector<FormFit> ranking;  // best first: by the left-out value (else the median error)
  std::size_t recommended = 0;   // the simplest usable one that is not worse than the best; else the best
  bool interrupted = false;
};

}  // namespace brdf::fit
