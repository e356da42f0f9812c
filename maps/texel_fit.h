// Fits one texel after another. Everything that the texels share is set up once.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fit/assess/assess.h"
#include "fit/model/data.h"
#include "fit/model/model.h"
#include "fit/solve/profile.h"
#include "fit/solve/sample_stream.h"
#include "fit/solve/solve.h"
#include "io/samples/samples.h"
#include "texel/stack.h"

namespace brdf::maps {

// Settings that all texels of a stack share.
struct Settings {
  std::vector<Reflectance> forms;  // one form, or several that are summed
  fit::FitOptions options;         // the metric must be chosen already
  bool fits_normal = false;
};

// Throws InputError for settings that a fit of texels does not support, such as the automatic choice of a
// form, a robust loss without a scale, a free scale, starting points, or --bootstrap.
void check(const Settings& settings);

// The fit of one texel.
struct TexelFit {
  std::vector<double> p;  // the solver's parameters; empty if no pixel has information
  Vec3<double> normal{0, 0, 1};
  double cost = 0;
  std::size_t rows = 0;  // number of images used
  bool from_grid = false;
  fit::Verdict verdict = fit::Verdict::diverged;
  std::vector<fit::Estimate> estimates;  // in the order of fit/assess/reported.h

  bool empty() const { return p.empty(); }
  // Returns the root mean square of the residuals of `channels` channels.
  double error(std::size_t channels) const;
};

// The pixels of one texel.
struct TexelPixels {
  std::span<const float> pixels;  // [channel][image]
  std::size_t x = 0, y = 0;       // position in the stack
};

// Returns the texel's pixels as samples of f_r in the frame of its normal, as `brdf fit` accepts them.
// Images with directions below the horizon of this normal, and images without a value, are left out.
io::SampleTable texel_table(const texel::Stack& stack, const TexelPixels& texel, const Vec3<double>& normal);

// Not thread-safe: each thread needs a fitter of its own.
class TexelFitter {
 public:
  TexelFitter(const texel::Stack& stack, const Settings& settings);

  const fit::Model& model() const { return model_; }

  // Fits a texel, starting at the solution of a neighbour. A grid of shapes (and normals) is used if there
  // is no neighbour, or if the cost exceeds the neighbour's cost by more than noise explains. The minimum is
  // that of fit::fit() on the texel's table. `normal` is the surface's normal; if the normal is fitted, it
  // is the initial guess.
  TexelFit fit(const TexelPixels& texel, const Vec3<double>& normal, const TexelFit* neighbour);

  // Holds these parameters of the solver at these values from now on. With empty spans all parameters are
  // free again.
  void hold(std::span<const std::size_t> slots, std::span<const double> values);

  // The contribution of a texel to parameters that it shares with other texels. `last` must be the most
  // recent fit and must not be empty.
  struct SharedTerms {
    fit::Profile profile;
    // For the shared parameters: the sum over rows of the outer product of each row's effect on these
    // parameters.
    fit::Matrix meat;
    double cost = 0;
  };
  SharedTerms shared_terms(const TexelFit& last, std::span<const std::size_t> slots) const;

 private:
  void select_rows(const Vec3<double>& normal);
  fit::Solution solve_from(const fit::FitData& data, std::span<const double> start, double tolerance,
                           int iterations) const;
  fit::Solution solve_from_neighbour(const TexelFit& neighbour);
  fit::Solution solve_from_grid();
  fit::Solution solve_at_length(std::span<const double> start) const;
  fit::Solution settle_rows(fit::Solution s);
  std::vector<Vec3<double>> likely_normals() const;
  bool jumps(const fit::Solution& s, const TexelFit& neighbour) const;
  void assess(const fit::Solution& s, TexelFit& out);
  void turn_rows(const Vec3<double>& normal, fit::FitData& data,
                 std::vector<std::vector<double>>& values) const;
  fit::Misfit judged(std::vector<std::vector<double>>& values, const Vec3<double>& normal) const;
  fit::SampleStream stream_of(const fit::FitData& data) const;

  const texel::Stack& stack_;
  const Settings& settings_;
  fit::Model model_;
  fit::Residual residual_;
  DirectionArrays<double> arrays_;  // of this texel; of all texels if lights and viewers are far away
  DirectionArrays<double> turned_;  // the same in the frame of the surface's normal
  std::vector<double> low_, high_;
  bool holds_ = false;
  std::vector<std::vector<double>> starts_;
  TexelPixels texel_;
  Vec3<double> normal_{0, 0, 1};
  fit::FitData data_;
  fit::Besides besides_;  // at the solution
  std::shared_ptr<fit::SampleStream::Spare> spare_ = std::make_shared<fit::SampleStream::Spare>();
};

}  // namespace brdf::maps
