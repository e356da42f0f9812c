// Rows that belong together because one direction stood still while they were taken: what is left out
// together.
#pragma once

#include <cstdint>
#include <vector>

#include "brdf/directions.h"

namespace brdf::fit {

// At most so many groups are left out one by one; more are dealt out to as many folds by a hash of their
// directions: at random, as the error of a parameter by folds supposes, but always the same.
inline constexpr std::size_t kMostFolds = 11;

struct RowRange {
  std::size_t first = 0, rows = 0;
};

// Rows of one direction of the stepped side, or of a cell of directions.
struct RowGroup {
  double theta = 0, phi = 0;  // of that direction, or of the cell's centre; degrees, phi in [0, 360)
  RowRange range;             // in the order below
  std::size_t fold = 0;
};

// What leaving groups out speaks of.
enum class HeldOut {
  many,           // whole lights (or viewers), of which there are many
  few,            // the same, of which there are fewer than five
  interpolation,  // one direction alone stood still, or none: neighbours of what is left out stay in the fit
};

struct RowGroups {
  bool by_viewer = false;  // the viewer was stepped and the light scanned
  bool by_pair = false;    // every pair of directions is its own group: theta and phi are the light's
  std::vector<RowGroup> groups;
  std::vector<std::uint32_t> group_of;  // [row], as given
  std::size_t folds = 0;
  HeldOut held_out = HeldOut::many;

  // What the groups are of: "incidences".
  const char* name() const { return by_pair ? "pairs of directions" : by_viewer ? "viewers" : "incidences"; }
};

// All rows of a fold, which lie together.
RowRange rows_of_fold(const RowGroups& groups, std::size_t fold);

// The stepped side is the one with fewer distinct directions (to a thousandth of a degree), as long as it has
// two. Above 1,000 directions on either side the light's cells of 1 degree by 30 are the groups; below two on
// both, the pairs. Where one side has a single direction, so that those of the other are all that can be left
// out, what is left out lies between what is fitted. Folds depend on the directions alone, not on the order
// of rows, and not on a turn of all of them about the normal.
RowGroups group_rows(const Directions<double>& directions, std::size_t rows);

}  // namespace brdf::fit
