// An upper bound of a shader's directional albedo over a box of its parameters and of the light.
#pragma once

#include <functional>

#include "prove/search.h"
#include "prove/shader/on_box.h"

namespace brdf::prove {

// The largest of f in a box of viewers, 1/sr, the parameters and the light being those of a box; not finite
// where f may be no number.
using ViewerBounds = std::function<Bounds(Bounds cos_o, Bounds turn_o)>;

// At most this is reflected: the sum over cells of viewers of the largest f times the cell's projected solid
// angle. The cell that leaves most open is halved until the sum is at most `enough`, until halving gains
// little, or until `most_cells` have been asked for. Infinite where f may be no number on some cell.
double albedo_at_most(const ViewerBounds& f, double enough, int most_cells);

// Bounds the albedo over a domain: the box whose bound is largest is asked for with more cells as long as
// that brings it a good part of the way to `enough`, and else halved along the variable that gains most,
// until all are at most `enough` or the options' limits are reached. Of the result `range.hi` is the bound,
// `open` counts the boxes above `enough`, of which `left` holds some; there is no tree.
Cover bound_albedo(const Domain& domain, const std::function<ViewerBounds(const Box&)>& of, double enough,
                   const SearchOptions& options);

}  // namespace brdf::prove
