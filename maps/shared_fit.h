// Shapes that all texels of a region have in common: one width for a varnish, whatever lies under it.
//
// Least squares over all texels of a region at once. Each texel's own parameters are eliminated by
// themselves, so that the region's are Gauss and Newton's steps on sums over texels (fit/solve/profile.h). Of
// the texels nothing is kept from one step to the next: each step reads the stack once.
#pragma once

#include <filesystem>

#include "maps/stack_fit.h"

namespace brdf::maps {

struct Sharing {
  std::vector<std::string> names;    // of shapes, as options name them
  std::vector<std::size_t> regions;  // [texel of the stack]: from 1 on; 0 shares nothing
  std::size_t count = 0;             // of regions
};

// The regions of a one-channel image of the stack's size: texels with the same number above 0 are one, 0
// shares nothing. Without a file the whole stack is one. Throws InputError.
Sharing read_sharing(const std::vector<std::string>& names, const std::filesystem::path& file,
                     const texel::Stack& stack);

// As fit_stack(). What is shared has one value in a region, with the standard error of that; the others'
// standard errors contain what its uncertainty adds. Throws InputError where a name is not that of a free
// shape.
texel::Planes fit_shared(const texel::Stack& stack, const Settings& settings, const Normals* normals,
                         const Sharing& sharing, const Resources& resources,
                         const io::Progress& progress = {});

}  // namespace brdf::maps
