// What a solution is worth: errors, noise, uncertainty, identifiability.
#pragma once

#include <optional>

#include "fit/assess/result.h"
#include "fit/model/data.h"
#include "fit/solve/minima.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// The four metrics of the model's values [channel][row].
Metrics measure(const FitData& data, const std::vector<std::vector<double>>& model);

// Relative standard error up to which what a model gives counts as determined, whatever its parameters are.
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
  bool sum_at_bound = false;  // what --physical bounds together
  bool split_only = false;    // weights alone are not identified: what they give together may still be
  std::optional<ParameterCovariance> covariance;
  // Relative standard error that 95 % of the model's values, and of the light, keep to; of more rows than are
  // looked at one by one only where it decides the verdict. Not in estimates alone.
  std::optional<double> prediction_error;
  bool predictable = false;           // it is known, and at most kDetermined
  std::vector<std::string> findings;  // about bounds and identifiability
  std::string few_rows_decide;        // which parameters few rows decide, and which rows; empty: none
  bool profiled = false;              // the intervals are those of profiles
  std::vector<Estimate> products;     // of weights that are not known apart
  std::vector<EndOfInterval> ends;    // of profiles, in the parameters' order, the lower before the upper

  // What the model gives is known, and only how weights share it is not.
  bool determined() const { return split_only && predictable; }
};

// `estimates`: what a verdict and standard errors need, without correlations, the parameters' covariance, and
// sentences. `profiles`: intervals are those of the cost's profile within the bounds
// (fit/assess/profile_search.h), not of its curvature.
enum class Detail { everything, estimates, profiles };

// What profiles need besides the minimum.
struct ProfileOptions {
  std::vector<std::vector<double>> other_minima;  // the solver's parameters
  unsigned threads = 1;                           // no result depends on it
  const std::atomic<bool>* interrupted = nullptr;
};

// Of a stream at a solution, where they are known already.
struct KnownMatrices {
  const Matrix &bread, &expected_meat;
};

// What the curvature at a solution says (fit/assess/curvature.h). The variance of a parameter is the larger
// of the heteroscedasticity-consistent one and of the working noise's; estimates alone have the former. `low`
// and `high` are those of the curvature, within the range: fit/assess/profiles.h has better ones.
Uncertainty uncertainty(const SampleStream& stream, const Minimum& solution,
                        Detail detail = Detail::everything, const KnownMatrices* known = nullptr,
                        const ProfileOptions& profiles = {});

// Whether some configuration (both polar angles and the azimuth between them) was measured at two azimuths of
// the sample: only that tells two widths from an error of the form that depends on the azimuth between light
// and viewer.
bool sample_was_turned(const FitData& data);

// Polar angles of the light, degrees.
struct AngleRange {
  double low = 0, high = 85;
};
AngleRange measured_lights(const FitData& data);

// The largest of the channels' at one angle of the light, degrees, to a relative error of 1e-3.
LargestAlbedo albedo_at(const Material& material, double theta);
// The largest over the light's polar angles, ten from 0 to 85 degrees and the ends of the measured ones; and
// over those that were measured.
struct LargestAlbedos {
  LargestAlbedo anywhere, measured;
};
LargestAlbedos largest_albedos(const Material& material, AngleRange measured);

// The residual far above the noise: enough of the reflected light is in the wrong place.
struct Misfit {
  bool misfit = false;
  std::string finding;
  bool light_is_off = false;  // the reason is the share of the light
};
Misfit judge_misfit(const FitData& data, const std::vector<std::vector<double>>& model,
                    std::optional<double> noise);

}  // namespace brdf::fit
