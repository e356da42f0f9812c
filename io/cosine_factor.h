// Whether a table's values are f_r, or a cosine is left in them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/reciprocal_pairs.h"
#include "io/samples.h"

namespace brdf::io {

enum class Cosine { none, cos_i, cos_o, both };

struct CosineFactor {
  Cosine found = Cosine::none;
  // Of reciprocal pairs: the power p in f(a,b)/f(b,a) = (cos_a/cos_b)^p, median; +1 for f_r cos_i, -1 for f_r cos_o.
  std::optional<double> exchanged;
  // The power of the cosines that the values fall with towards grazing while the half vector keeps its angle, median:
  // reciprocity says nothing of f_r cos_i cos_o. At most 0 for lobes of facets and for diffuse surfaces.
  std::optional<double> grazing;
  // One clause: what the values behave as, or that no cosine is left.
  std::string statement;
};

// Both powers where the table allows them: at least 8 pairs whose cosines differ by a third, at least 30 values along
// half vectors. A cosine is found where the first is beyond 0.5 either way or the second above 0.75.
CosineFactor cosine_factor(const SampleTable& table, const std::vector<ReciprocalPair>& pairs);
CosineFactor cosine_factor(const SampleTable& table);  // of its interpolated pairs

}  // namespace brdf::io
