// The fit of one texel after another: what all of them share is set up once.
#pragma once

#include <memory>
#include <optional>
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

struct Settings {
  std::vector<Reflectance> forms;  // one, or several that are summed
  fit::FitOptions options;         // the metric is chosen already
  bool fits_normal = false;
};

// Throws InputError for what a fit of texels cannot do: choose a metric or a form, estimate a robust loss's
// scale.
void check(const Settings& settings);

struct TexelFit {
  std::vector<double> p;  // the solver's parameters; empty: no pixel says anything
  Vec3<double> normal{0, 0, 1};
  double cost = 0;
  std::size_t rows = 0;  // images that were used
  bool from_grid = false;
  fit::Verdict verdict = fit::Verdict::diverged;
  std::vector<fit::Estimate> estimates;  // in the order of fit/assess/reported.h

  bool empty() const { return p.empty(); }
  // Root mean square of the residuals of `channels` channels.
  double error(std::size_t channels) const;
};

struct TexelPixels {
  std::span<const float> pixels;  // [channel][image]
  std::size_t x = 0, y = 0;       // in the stack
};

// The texel's pixels as samples of f_r in the frame of its normal: what `brdf fit` takes. Images below
// that horizon, and those without a value, are left out.
io::SampleTable texel_table(const texel::Stack& stack, const TexelPixels& texel, const Vec3<double>& normal);

// Not for several threads at once: each has its own.
class TexelFitter {
 public:
  TexelFitter(const texel::Stack& stack, const Settings& settings);

  const fit::Model& model() const { return model_; }

  // From the solution of a neighbour, and from a grid of shapes (and normals) where there is none or what it
  // leads to costs more than the neighbour by more than noise explains. The minimum is that of fit::fit() on
  // the texel's table. `normal` is the surface's, or where it is fitted a guess.
  TexelFit fit(const TexelPixels& texel, const Vec3<double>& normal, const TexelFit* neighbour);

  // From now on these of the solver's parameters have these values; none: all are free again.
  void hold(std::span<const std::size_t> slots, std::span<const double> values);

  // What the texel says of parameters that it shares with others, in the fit that was the last and is not
  // empty.
  struct SharedTerms {
    fit::Profile profile;
    fit::Matrix meat;  // of the shared ones: the sum over rows of the outer product of what they feel of each
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
  DirectionArrays<double> arrays_;  // in this texel; in all of them where lights and viewers are far
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
