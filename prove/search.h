// Branch and bound: boxes are cut in two until each is decided.
#pragma once

#include <functional>
#include <vector>

#include "prove/scalar/enclosed.h"

namespace brdf::prove {

using Box = std::vector<Bounds>;

// A tree of cuts in the order root, first half, second half. A leaf has variable -1.
struct Cover {
  struct Node {
    int variable = -1;
    double cut = 0;
    Bounds bounds{};      // of a leaf: the enclosure
    bool open = false;    // a leaf that is not decided
    double accuracy = 0;  // for the albedo of a material: the accuracy of the cells that gave the bounds
  };
  std::vector<Node> nodes;
  long boxes = 0;  // evaluated
  long open = 0;
  Bounds range{};         // of all leaves
  std::vector<Box> left;  // the open boxes, at most kListed of them
  static constexpr std::size_t kListed = 8;
};

struct SearchOptions {
  long leaves = 20000;
  double seconds = 20;
};

// Cuts the domain until every box is decided or a limit of the options is reached. `enclose` bounds the
// quantity on a box; `decided` returns whether these bounds settle the question there.
Cover cover(const Domain& domain, const std::function<Bounds(const Box&)>& enclose,
            const std::function<bool(Bounds)>& decided, const SearchOptions& options);

// Returns the box of the whole domain.
Box whole(const Domain& domain);

}  // namespace brdf::prove
