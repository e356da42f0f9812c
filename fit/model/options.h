// Options of a fit.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brdf/names.h"
#include "io/columns/supplied.h"
#include "io/formats/budget.h"
#include "io/formats/optical_constants.h"
#include "io/samples/arrange.h"

namespace brdf::fit {

// The residual of one value, with f the model, g the measurement, c_i and c_o the cosines
// (docs/fitting.md).
enum class Metric {
  log,           // ln(1 + f c_i) - ln(1 + g c_i)
  cosine_l2,     // (f - g) c_i
  cube_root,     // the sum of (((f - g) c_i)^2)^(1/3)
  log_relative,  // ln((f c_i c_o + e)/(g c_i c_o + e)), e = 1e-3
  automatic      // the metric with the most uniform noise on the data (fit/assess/metric_choice.h)
};
inline constexpr std::array kResiduals{Metric::log, Metric::cosine_l2, Metric::cube_root,
                                       Metric::log_relative};
inline constexpr double kLogRelativeFloor = 1e-3;

enum class Loss { none, huber, cauchy };
// Bounds of the weights of one channel.
enum class Physical {
  off,
  bounded,     // their sum is at most 1
  dielectric,  // the weight divided by f0 is 1; f0 and the other weights sum to at most 1
  either       // dielectric unless the samples contradict it, otherwise bounded
};
enum class Weighting { automatic, uniform, sigma, solid_angle };

}  // namespace brdf::fit

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 5> kNames<fit::Metric>{"log", "cosine_l2", "cube_root",
                                                                     "log_relative", "auto"};
template <>
inline constexpr std::array<std::string_view, 3> kNames<fit::Loss>{"none", "huber", "cauchy"};
template <>
inline constexpr std::array<std::string_view, 4> kNames<fit::Weighting>{"auto", "uniform", "sigma",
                                                                        "solid_angle"};

}  // namespace brdf

namespace brdf::fit {

// The values of a parameter: one for all channels or one per channel. Alternatively a table of refractive
// indices, which gives a value for every channel: the reflectance at normal incidence for f0, otherwise n
// or k (by the role of the parameter).
struct NamedValues {
  std::string name;
  std::vector<double> values;
  std::shared_ptr<const io::OpticalConstants> constants = nullptr;
};
struct NamedRange {
  std::string name;
  double low, high;
};

// Called with a description of each model or step before it is tried.
using Progress = std::function<void(const std::string&)>;

struct FitOptions {
  Metric metric = Metric::log;
  Loss loss = Loss::none;
  double loss_scale = 0;                       // in units of the residual; 0: estimated from the residuals
  Weighting weighting = Weighting::automatic;  // automatic: by the sigma columns if there are any
  double max_theta = 80;                       // degrees; rows beyond are excluded
  bool anisotropic = false;
  bool per_channel = false;     // applies to shapes too
  int smooth = 0;               // shapes follow a polynomial of this degree in 1/wavelength; 0: they do not
  bool free_scale = false;      // the samples are uncalibrated: arranged() divides out their scale
  bool keep_fill = false;       // arranged() keeps rows with a value that means "not measured"
  io::Arrangement arrangement;  // treatment of polarisations and repeats by arranged()
  io::Supplied supplied;        // information missing from the samples' files, for the readers of the files
  // Returns whether a shape may differ between channels.
  bool shapes_differ() const { return per_channel || smooth > 0; }
  std::vector<NamedValues> fix, start;
  std::vector<NamedRange> bounds;
  // Parameters with one value for all channels: weights, f0, and shapes under per_channel.
  std::vector<std::string> tie;
  Physical physical = Physical::off;
  bool grid_starts = true;
  int random_starts = 0;
  std::uint64_t seed = 1;
  int bootstrap = 0;  // number of replicates, drawn from the groups of rows by the seed
  // Full width of the detector's field in degrees, 0 for a point. std::nullopt: the width that the samples'
  // file states; prepared() replaces it by this width.
  std::optional<double> aperture;
  // Returns the width after prepared(). Throws std::logic_error if no width is set: aperture_of() needs a
  // table.
  double resolved_aperture() const;
  // The uncertainty budget of the instrument. Null: the budget that the samples' file names, which
  // arranged() reads, or no budget, if it names none.
  std::shared_ptr<const io::Budget> budget;
  // If set, the surface's normal is fitted too, starting from these components along the x and y of the
  // directions. The values are then interpreted as f_r cos_i of the surface divided by the cos_i of the
  // directions' own frame.
  std::optional<std::array<double, 2>> normal;
  bool cross_validation = true;
  bool profiles = true;  // compute intervals by profiles, which takes longer than the fit
  // Number of models, and of starts of each model, that are solved in parallel. No result depends on it.
  unsigned threads = 1;
  const std::atomic<bool>* interrupted = nullptr;  // set from outside: return the best solution so far

  bool stop() const { return interrupted && interrupted->load(std::memory_order_relaxed); }
};

// Returns the full width of the detector's field, in degrees, with which a table is fitted: that of the
// options or, if the options leave it open, the width in the table's metadata, otherwise 0.
double aperture_of(const io::SampleTable& table, const FitOptions& options);

// Returns the contents of the tables of refractive indices and of the layout that the options name, for
// fingerprints. Empty if the options name no such file.
std::string constants_text(const FitOptions& options);

}  // namespace brdf::fit
