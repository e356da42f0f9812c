// Groups of rows that share one direction which was kept fixed while they were measured. The rows of a
// group are held out together.
#pragma once

#include <cstdint>
#include <vector>

#include "brdf/directions.h"

namespace brdf::fit {

// Up to this many groups are held out one by one. More groups are distributed over this many folds by a
// hash of their directions. The distribution is random, as the error of a parameter by folds assumes, but
// reproducible.
inline constexpr std::size_t kMostFolds = 11;

struct RowRange {
  std::size_t first = 0, rows = 0;
};

// The rows of one direction of the stepped side, or of a cell of directions.
struct RowGroup {
  double theta = 0, phi = 0;  // of that direction, or of the centre of the cell; degrees, phi in [0, 360)
  RowRange range;             // in the order of the groups
  std::size_t fold = 0;
};

// The kind of prediction that holding out groups tests.
enum class HeldOut {
  many,           // whole incidences (or viewing directions), of which there are many
  few,            // whole incidences (or viewing directions), fewer than five
  interpolation,  // one or no direction was kept fixed: neighbours of held-out rows stay in the fit
};

struct RowGroups {
  bool by_viewer = false;  // the viewer was stepped and the light scanned
  bool by_pair = false;    // every pair of directions is a group; theta and phi belong to the light
  std::vector<RowGroup> groups;
  std::vector<std::uint32_t> group_of;  // [row], in the given order
  std::size_t folds = 0;
  HeldOut held_out = HeldOut::many;

  // Returns the kind of the groups: "incidences".
  const char* name() const { return by_pair ? "pairs of directions" : by_viewer ? "viewers" : "incidences"; }
};

// Returns the rows of a fold, which are contiguous.
RowRange rows_of_fold(const RowGroups& groups, std::size_t fold);

// Groups the rows by the stepped side. This is the side with fewer distinct directions (to a thousandth of
// a degree), provided it has 2 to 1,000 of them; otherwise the other side, under the same condition. If
// neither side qualifies, the groups are cells, 1 degree by 30 degrees, of the directions of a side with
// more than 1,000 (of the light if both have more). If this gives fewer than two groups, or no side has so
// many directions, the groups are pairs of directions.
// If one side has a single direction, only directions of the other side can be held out; they lie between
// the fitted directions. Folds depend on the directions alone, not on the order of the rows, and not on a
// rotation of all directions about the normal.
RowGroups group_rows(const Directions<double>& directions, std::size_t rows);

}  // namespace brdf::fit
