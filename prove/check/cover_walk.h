// Covers as certificates hold them, walked and enclosed again.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "io/files/json.h"
#include "prove/scalar/enclosed.h"

namespace brdf::prove {

// What is walked: the cover at `cover`, a tree over `domain`. `enclose` gives the bounds on a box, of a leaf
// whose row is `leaf`; none: the row says of them what cannot be. `settles` says whether bounds suffice.
struct WalkedCover {
  const Domain& domain;
  const io::JsonPlace& cover;
  std::function<std::optional<Bounds>(std::span<const Bounds> box, const io::JsonPlace& leaf)> enclose;
  std::function<bool(Bounds)> settles;
  std::size_t leaf_size = 2;  // members of a leaf's row
};

struct Walked {
  Bounds range{};     // of all leaves
  std::string fault;  // empty: the leaves hold, and cover the domain
};

// Every leaf's box follows from the cuts above it, so that nothing is left out. Adds to `leaves`.
Walked walk(const WalkedCover& what, long& leaves);

// Whether the domain that is stated is this one; empty: it is.
std::string other_domain(const Domain& domain, const io::JsonPlace& row);

}  // namespace brdf::prove
