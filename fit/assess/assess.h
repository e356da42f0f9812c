// Assessment of a solution: errors, noise, uncertainty, identifiability.
#pragma once

#include <optional>

#include "fit/assess/result.h"
#include "fit/model/data.h"
#include "fit/solve/minima.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// Computes the four metrics of the model's values, which are indexed [channel][row].
Metrics measure(const FitData& data, const std::vector<std::vector<double>>& model);

// The largest relative standard error at which the values of a model count as determined, whatever its
// parameters are.
inline constexpr double kDetermined = 0.05;

// The solver's parameters at an end of an interval.
struct EndOfInterval {
  std::vector<double> p;
  bool open = false;
};

struct Uncertainty {
  std::vector<Estimate> estimates;
  Correlations correlations;
  std::vector<SmoothCurve> smooth;
  double condition = 1;
  bool singular = false;      // some parameter has no effect, or only together with others
  bool sum_at_bound = false;  // the weights that --physical bounds together are at their bound
  bool split_only = false;    // only weights are unidentifiable; their sum may still be determined
  std::optional<ParameterCovariance> covariance;
  std::optional<RowBudget> budget;  // std::nullopt: intervals contain the scatter only
  // The relative standard error that 95 % of the model's values, and of the light, do not exceed. If there
  // are more rows than can be checked one by one, computed only if the verdict depends on it. Not set by
  // Detail::estimates.
  std::optional<double> prediction_error;
  bool predictable = false;           // the error is known and at most kDetermined
  std::vector<std::string> findings;  // about bounds and identifiability
  std::string few_rows_decide;        // the parameters that few rows decide, and these rows; may be empty
  bool profiled = false;              // the intervals come from profiles
  std::vector<Estimate> products;     // products of weights that cannot be separated
  std::vector<EndOfInterval> ends;    // of profiles, in the order of the parameters, lower end first

  // Returns whether the values of the model are determined and only their division among the weights is
  // not.
  bool determined() const { return split_only && predictable; }
};

// The extent of the analysis. `estimates`: the data for a verdict and standard errors only, without
// correlations, without the covariance of the parameters, and without sentences. `profiles`: as
// `everything`, but intervals come from the profile of the cost within the bounds
// (fit/assess/profile_search.h), not from its curvature.
enum class Detail { everything, estimates, profiles };

// Inputs of profiles in addition to the minimum.
struct ProfileOptions {
  std::vector<std::vector<double>> other_minima;  // in the solver's parameters
  unsigned threads = 1;                           // no result depends on it
  const std::atomic<bool>* interrupted = nullptr;
};

// Matrices of a stream at a solution, if they have already been computed.
struct KnownMatrices {
  const Matrix &bread, &expected_meat;
};

// Computes the uncertainty from the curvature of the cost at a solution (fit/assess/curvature.h). The
// variance of a parameter is the larger of the heteroscedasticity-consistent variance and the variance
// under the working noise; the excess of the former counts less if few values decide the parameter
// (Grounds::error_of). Detail::estimates uses only the former. `low` and `high` come from the curvature and
// are clipped to the range; fit/assess/profiles.h computes better ones.
Uncertainty uncertainty(const SampleStream& stream, const Minimum& solution,
                        Detail detail = Detail::everything, const KnownMatrices* known = nullptr,
                        const ProfileOptions& profiles = {});

// Returns whether some configuration (both polar angles and the azimuth between them) was measured at two
// azimuths of the sample. Only such data distinguish two widths from an error of the form that depends on
// the azimuth between light and viewer.
bool sample_was_turned(const FitData& data);

// The range of polar angles of incidence, degrees.
struct AngleRange {
  double low = 0, high = 85;
};
// Returns the range of the measured polar angles of incidence.
AngleRange measured_lights(const FitData& data);

// Returns the largest albedo of the channels at angle of incidence `theta`, degrees, to a relative error of
// 1e-3.
LargestAlbedo albedo_at(const Material& material, double theta);
// The largest albedo over ten polar angles of incidence from 0 to 85 degrees and the ends of the measured
// range, and the largest albedo over the measured angles.
struct LargestAlbedos {
  LargestAlbedo anywhere, measured;
};
// Returns both for a material. `measured` is the range of the measured angles.
LargestAlbedos largest_albedos(const Material& material, AngleRange measured);

// The result of a test for a residual far above the noise. A model fails if enough of the reflected light
// is in the wrong place.
struct Misfit {
  bool misfit = false;
  std::string finding;
  bool light_is_off = false;  // the reason is the share of misplaced light
};
// Judges the model's values, [channel][row]. `noise` is relative; std::nullopt if unknown.
Misfit judge_misfit(const FitData& data, const std::vector<std::vector<double>>& model,
                    std::optional<double> noise);

}  // namespace brdf::fit
