// Walks the covers of certificates and encloses their leaves again.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "io/files/json.h"
#include "prove/scalar/enclosed.h"

namespace brdf::prove {

// The input of a walk: the cover at `cover`, a tree over `domain`. `enclose` returns the bounds on a box
// for a leaf with the row `leaf`, or std::nullopt if the row is impossible. `settles` returns whether
// bounds suffice.
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

// Walks the cover. The box of every leaf follows from the cuts above the leaf, so that no part of the
// domain is left out. Adds the number of leaves to `leaves`.
Walked walk(const WalkedCover& what, long& leaves);

// Returns the difference of the domain in the row from this domain; empty if they are equal.
std::string other_domain(const Domain& domain, const io::JsonPlace& row);

}  // namespace brdf::prove
