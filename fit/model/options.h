// What a fit can be told.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brdf/names.h"
#include "io/columns/supplied.h"
#include "io/formats/optical_constants.h"
#include "io/samples/arrange.h"

namespace brdf::fit {

// The residual of one value: f the model, g the measurement, c_i and c_o the cosines (docs/fitting.md).
enum class Metric {
  log,           // ln(1 + f c_i) - ln(1 + g c_i)
  cosine_l2,     // (f - g) c_i
  cube_root,     // the sum of (((f - g) c_i)^2)^(1/3)
  log_relative,  // ln((f c_i c_o + e)/(g c_i c_o + e)), e = 1e-3
  automatic      // the one of them whose noise is the most even on the data (fit/assess/metric_choice.h)
};
inline constexpr std::array kResiduals{Metric::log, Metric::cosine_l2, Metric::cube_root,
                                       Metric::log_relative};
inline constexpr double kLogRelativeFloor = 1e-3;

enum class Loss { none, huber, cauchy };
// Bounds of the weights of one channel.
enum class Physical {
  off,
  bounded,     // their sum is at most 1
  dielectric,  // the weight that f0 divides is 1, and the others and f0 are at most 1 together
  either       // dielectric where the samples do not speak against it, else bounded
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

// One parameter's value for all channels or one per channel; or what a table of refractive indices says of it
// in every channel: the reflectance along the normal of f0, else n or k (by the parameter's role).
struct NamedValues {
  std::string name;
  std::vector<double> values;
  std::shared_ptr<const io::OpticalConstants> constants = nullptr;
};
struct NamedRange {
  std::string name;
  double low, high;
};

// Hears what is tried next, in words.
using Progress = std::function<void(const std::string&)>;

struct FitOptions {
  Metric metric = Metric::log;
  Loss loss = Loss::none;
  double loss_scale = 0;                       // in units of the residual; 0: estimated from the residuals
  Weighting weighting = Weighting::automatic;  // sigma columns where there are any
  double max_theta = 80;                       // degrees; rows beyond are left out
  bool anisotropic = false;
  bool per_channel = false;     // shapes, too
  int smooth = 0;               // shapes follow a polynomial of this degree in 1/wavelength; 0: none
  bool free_scale = false;      // the samples are uncalibrated: arranged() divides them
  bool keep_fill = false;       // arranged() keeps rows whose value stands for "not measured"
  io::Arrangement arrangement;  // what arranged() makes of polarisations and repeats
  io::Supplied supplied;        // what the samples' files do not state; readers of files take it
  // Whether a shape may differ between channels.
  bool shapes_differ() const { return per_channel || smooth > 0; }
  std::vector<NamedValues> fix, start;
  std::vector<NamedRange> bounds;
  std::vector<std::string>
      tie;  // parameters of one value for all channels: weights, f0, shapes under per_channel
  Physical physical = Physical::off;
  bool grid_starts = true;
  int random_starts = 0;
  std::uint64_t seed = 1;
  int bootstrap = 0;    // replicates of groups of rows, drawn by the seed
  double aperture = 0;  // full width of the detector's field, degrees; 0: none
  // The surface's normal is fitted, too, from these components along the directions' x and y. The values are
  // then taken as f_r cos_i of the surface over the cos_i of the directions' own frame.
  std::optional<std::array<double, 2>> normal;
  bool cross_validation = true;
  bool profiles = true;  // intervals by profiles, which take longer than the fit
  unsigned threads =
      1;  // models, and the starts of each, that are solved side by side; no result depends on it
  const std::atomic<bool>* interrupted = nullptr;  // set from outside: return the best so far

  bool stop() const { return interrupted && interrupted->load(std::memory_order_relaxed); }
};

// What the tables of refractive indices hold that the options name, for fingerprints; empty where there are
// none.
std::string constants_text(const FitOptions& options);

}  // namespace brdf::fit
