// Shapes that all texels of a region have in common: one width for a varnish, whatever lies under it.
//
// The fit is a least-squares fit over all texels of a region at once. Each texel's own parameters are
// eliminated separately, and the parameters of the region are found by Gauss-Newton steps on sums over
// texels (fit/solve/profile.h). No data of the texels is kept between steps: each step reads the stack once.
#pragma once

#include <filesystem>

#include "maps/stack_fit.h"

namespace brdf::maps {

// The shared shapes, and the regions of texels that share them.
struct Sharing {
  std::vector<std::string> names;    // names of shapes, as in options
  std::vector<std::size_t> regions;  // [texel of the stack]: numbers from 1; 0: the texel shares nothing
  std::size_t count = 0;             // number of regions
};

// Reads the regions from a one-channel image of the stack's size. Texels with the same number above 0 form a
// region; texels with 0 share nothing. Without a file, the whole stack is one region. Throws InputError.
Sharing read_sharing(const std::vector<std::string>& names, const std::filesystem::path& file,
                     const texel::Stack& stack);

// Fits a stack like fit_stack(), with shared shapes. A shared shape has one value per region, with the
// standard error of this value; the standard errors of the other parameters include the uncertainty of the
// shared shapes. Throws InputError if a name does not denote a free shape.
texel::Planes fit_shared(const texel::Stack& stack, const Settings& settings, const Normals* normals,
                         const Sharing& sharing, const Resources& resources,
                         const io::Progress& progress = {});

}  // namespace brdf::maps
