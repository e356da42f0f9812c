// An upper bound of a shader's directional albedo over a box of its parameters and of the light.
#pragma once

#include <functional>

#include "prove/search.h"
#include "prove/shader/on_box.h"

namespace brdf::prove {

// Bounds f (1/sr) in a box of viewers, with the parameters and the light in a fixed box. Not finite if f
// may be NaN.
using ViewerBounds = std::function<Bounds(Bounds cos_o, Bounds turn_o)>;

// Returns an upper bound of the albedo: the sum over cells of viewers of the largest f times the projected
// solid angle of the cell. The cell with the largest uncertainty is halved until the sum is at most
// `enough`, until halving gains little, or until `most_cells` cells have been evaluated. Infinite if f may
// be NaN in some cell.
double albedo_at_most(const ViewerBounds& f, double enough, int most_cells);

// Bounds the albedo over a domain. The box with the largest bound is evaluated with more cells as long as
// that brings the bound a good part of the way to `enough`; otherwise the box is halved along the variable
// that gains most. The search ends when all bounds are at most `enough`, or at the limits of the options.
// In the result, `range.hi` is the bound, `open` counts the boxes above `enough`, and `left` holds some of
// them; there is no tree.
Cover bound_albedo(const Domain& domain, const std::function<ViewerBounds(const Box&)>& of, double enough,
                   const SearchOptions& options);

}  // namespace brdf::prove
