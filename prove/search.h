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
    Bounds bounds{};      // of a leaf: what was enclosed there
    bool open = false;    // a leaf that is not decided
    double accuracy = 0;  // of a material's albedo: that of the cells its bounds are from
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

// `enclose` bounds the quantity on a box; `decided` says whether those bounds settle the question there.
Cover cover(const Domain& domain, const std::function<Bounds(const Box&)>& enclose,
            const std::function<bool(Bounds)>& decided, const SearchOptions& options);

Box whole(const Domain& domain);

}  // namespace brdf::prove
