// The Klems bases of LBNL Window: patches that divide the hemisphere of directions.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace brdf::io::klems {

// A ring of patches of equal size. The bounds are polar angles in degrees.
struct Ring {
  double lower, upper;
  std::size_t patches;
};

// A patch. `theta`, `phi` are its centre, which is the pole for a single patch around the normal. All angles
// are in degrees.
struct Patch {
  double theta, phi;
  double lower, upper;  // bounds of the polar angle
  double width;         // in azimuth
  double projected;     // projected solid angle in sr; the sum over a hemisphere is pi
};

struct Basis {
  std::string name;
  std::vector<Ring> rings;
};

// Returns the bases that have a name: LBNL/Klems Full (145 patches), Half (73) and Quarter (41).
const std::vector<Basis>& known_bases();

// Returns the patches ring by ring. Patch j of n is centred at azimuth 360 j / n and extends over half a step
// to both sides. In a matrix, the azimuth of an incident patch counts from the opposite side: light is
// incident from `phi` + 180 degrees, so that the mirror direction is on the diagonal.
std::vector<Patch> patches_of(const std::vector<Ring>& rings);

}  // namespace brdf::io::klems
