// Maps of parameters from a stack: a fit of every texel, unit by unit.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "io/files/parallel.h"
#include "maps/texel_fit.h"
#include "texel/planes.h"

namespace brdf::maps {

// Fits in a tile of kTile x kTile texels do not depend on texels of other tiles. The result is therefore
// independent of the division into units, of the process and of the order. A unit, the work that one process
// does at a time, consists of whole tiles.
inline constexpr std::size_t kTile = 8;
inline constexpr std::size_t kUnit = 64;  // texels per side, by default

// Limits of memory and threads.
struct Resources {
  std::size_t memory = std::size_t{1} << 29;  // bytes of pixels in memory at a time, for all threads together
  unsigned threads = 1;
};

// Given normals of the surface: planes normal.x, normal.y and normal.z of the stack's size.
using Normals = texel::Planes;
Normals read_normals(const std::filesystem::path& path, const texel::Stack& stack);

// Returns the planes of a region, over its own texels:
// - every parameter, under the name that a fit reports (kd.r);
// - its standard error (standard_error.kd.r): half of the 95 % interval divided by 1.96, which accounts for
//   a small number of decisive images. NaN if the parameter is not identified, 0 if it is held or at a
//   bound;
// - normal.x, normal.y and normal.z;
// - `error`, the root mean square of the residuals;
// - `images`, the number of images used;
// - `verdict`, the number of the verdict in fit::Verdict;
// - `grid`, 1 if the fit came from the grid of starting points.
// Values are NaN if there is no sample, or if no pixel of a texel is above 0. `normals` may be null.
texel::Planes fit_unit(const texel::Stack& stack, const Settings& settings, const Normals* normals,
                       const texel::Region& region, std::size_t memory);

// Fits the texels of a region one after another, with the same results as fit_unit(). `before` is called
// before each fit and may set the parameters that the fitter holds. `visit` is called with each fit that is
// not empty. Texels are numbered within the region.
using BeforeTexel = std::function<void(std::size_t texel)>;
using VisitTexel = std::function<void(std::size_t texel, const TexelPixels& pixels, const TexelFit& fit)>;
void fit_texels(TexelFitter& fitter, const texel::Stack& stack, const Settings& settings,
                const Normals* normals, const texel::Region& region, std::size_t memory,
                const BeforeTexel& before, const VisitTexel& visit);

// Returns the planes of a fit in order, NaN everywhere. plane_values() returns their values in a texel.
texel::Planes unknown_maps(const fit::Model& model, std::size_t width, std::size_t height);
std::vector<double> plane_values(const TexelFit& fit, bool fits_normal, std::size_t channels);
// Stores such values for one texel.
void put_texel(const std::vector<double>& values, std::size_t texel, texel::Planes& maps);
// Returns the surface's normal in a texel of the stack: z if there are no planes.
Vec3<double> normal_at(const Normals* normals, std::size_t texel);

// Returns the planes of the whole stack, in which put() assembles the units.
texel::Planes empty_maps(const texel::Stack& stack, const Settings& settings);
void put(const texel::Planes& unit, const texel::Region& region, texel::Planes& maps);

// Fits all units of the stack and returns the planes of the whole stack.
texel::Planes fit_stack(const texel::Stack& stack, const Settings& settings, const Normals* normals,
                        const Resources& resources, const io::Progress& progress = {});

// Chooses the metric for all texels if the user did not choose one: the metric that `auto` chooses most
// often for nine texels across the stack's middle row. The result is log if the noise of all nine is
// unknown.
fit::Metric choose_metric(const texel::Stack& stack, const Settings& settings, const Normals* normals);

// Quality of the maps.
struct Summary {
  std::size_t texels = 0, fitted = 0, from_grid = 0;
  std::vector<std::size_t> verdicts;   // by fit::Verdict
  std::optional<double> median_error;  // std::nullopt: no texel was fitted

  std::size_t usable() const;
};
// Returns the summary of the maps of a whole stack.
Summary summary_of(const texel::Planes& maps);

}  // namespace brdf::maps
