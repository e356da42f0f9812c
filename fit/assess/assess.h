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

struct Uncertainty {
  std::vector<Estimate> estimates;
  Correlations correlations;
  std::vector<SmoothCurve> smooth;
  double condition = 1;
  bool singular = false;      // some parameter has no effect, or only together with others
  bool sum_at_bound = false;  // what --physical bounds together
  bool split_only = false;    // weights alone are not identified: what they give together may still be
  std::optional<ParameterCovariance> covariance;
  // Relative standard error that 95 % of the model's values, and of the light, keep to; of more rows than are looked at
  // one by one only where it decides the verdict. Not in estimates alone.
  std::optional<double> prediction_error;
  bool predictable = false;           // it is known, and at most kDetermined
  std::vector<std::string> findings;  // about bounds and identifiability

  // What the model gives is known, and only how weights share it is not.
  bool determined() const { return split_only && predictable; }
};

// `estimates`: what a verdict and standard errors need, without intervals, correlations, the parameters' covariance, and
// sentences.
enum class Detail { everything, estimates };

// Of a stream at a solution, where they are known already.
struct KnownMatrices {
  const Matrix &bread, &expected_meat;
};

// Heteroscedasticity-consistent covariance at a solution, rows independent, channels of a row not.
Uncertainty uncertainty(const SampleStream& stream, const Minimum& solution,
                        Detail detail = Detail::everything, const KnownMatrices* known = nullptr);

// Whether some configuration (both polar angles and the azimuth between them) was measured at two azimuths of the
// sample: only that tells two widths from an error of the form that depends on the azimuth between light and viewer.
bool sample_was_turned(const FitData& data);

// Of a material, over the light's polar angles, ten from 0 to 85 degrees, to a relative error of 1e-3.
LargestAlbedo largest_albedo(const Material& material);

// The residual far above the noise: enough of the reflected light is in the wrong place.
struct Misfit {
  bool misfit = false;
  std::string finding;
};
Misfit judge_misfit(const FitData& data, const std::vector<std::vector<double>>& model,
                    std::optional<double> noise);

}  // namespace brdf::fit
