// Maps of parameters from a stack: every texel's fit, unit by unit.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/files/parallel.h"
#include "maps/texel_fit.h"
#include "texel/planes.h"

namespace brdf::maps {

// Texels of a tile of kTile x kTile know nothing of another's: it does not matter who fits them, with which
// others, and when. A unit, what one process does at a time, is of whole tiles.
inline constexpr std::size_t kTile = 8;
inline constexpr std::size_t kUnit = 64;  // texels to a side, where nothing else is asked for

struct Resources {
  std::size_t memory = std::size_t{1} << 29;  // bytes of pixels at a time, of all threads together
  unsigned threads = 1;
};

// The surface's normals where they are given: planes normal.x, normal.y and normal.z of the stack's size.
using Normals = texel::Planes;
Normals read_normals(const std::filesystem::path& path, const texel::Stack& stack);

// The planes of a region, over its own texels: every parameter under the name that a fit reports it by
// (kd.r), its standard error (standard_error.kd.r; half of the 95 % interval over 1.96, so that few images
// that decide count as few; NaN where it is not identified, 0 where it is held or at a bound), normal.x, .y
// and .z, `error`, the root mean square of the residuals, `images`, how many were used, `verdict`, the number
// of the verdict in fit::Verdict, and `grid`, 1 where the fit came from the grid of starts. NaN where there
// is no sample, and where no pixel of a texel is above 0. `normals` may be null.
texel::Planes fit_unit(const texel::Stack& stack, const Settings& settings, const Normals* normals,
                       const texel::Region& region, std::size_t memory);

// The fits of a region's texels, one after another, as fit_unit() has them. `before` a texel is fitted it may
// be told what the fitter holds; `visit` hears of each that says anything. Texels by their number in the
// region.
using BeforeTexel = std::function<void(std::size_t texel)>;
using VisitTexel = std::function<void(std::size_t texel, const TexelPixels& pixels, const TexelFit& fit)>;
void fit_texels(TexelFitter& fitter, const texel::Stack& stack, const Settings& settings,
                const Normals* normals, const texel::Region& region, std::size_t memory,
                const BeforeTexel& before, const VisitTexel& visit);

// The planes that a fit has, in order, NaN everywhere; and their values in a texel.
texel::Planes unknown_maps(const fit::Model& model, std::size_t width, std::size_t height);
std::vector<double> plane_values(const TexelFit& fit, bool fits_normal, std::size_t channels);
void put_texel(const std::vector<double>& values, std::size_t texel, texel::Planes& maps);
// The surface's normal in a texel of the stack: z without any planes.
Vec3<double> normal_at(const Normals* normals, std::size_t texel);

// The planes of the whole stack, put together from units.
texel::Planes empty_maps(const texel::Stack& stack, const Settings& settings);
void put(const texel::Planes& unit, const texel::Region& region, texel::Planes& maps);

texel::Planes fit_stack(const texel::Stack& stack, const Settings& settings, const Normals* normals,
                        const Resources& resources, const io::Progress& progress = {});

// The metric for all texels where none is asked for: the one that `auto` chooses most often of nine across
// the stack's middle row; log where the noise of none is known.
fit::Metric choose_metric(const texel::Stack& stack, const Settings& settings, const Normals* normals);

// What maps are worth.
struct Summary {
  std::size_t texels = 0, fitted = 0, from_grid = 0;
  std::vector<std::size_t> verdicts;  // by fit::Verdict
  double median_error = 0;

  std::size_t usable() const;
};
Summary summary_of(const texel::Planes& maps);

}  // namespace brdf::maps
