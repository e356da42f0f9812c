// Certificates: what `brdf prove -o` writes, and the check of it, which searches nothing.
//
// {"format": "brdf-proof", "version": 1, "seal": fingerprint of the bytes from "results" on, "results": [{form, property, scalar,
// arithmetic, low, high, domain: {variable: [low, high]}, cover}]}. A cover is a tree of cuts in the order root, first half,
// second half: [variable, where] for a cut, [low, high] for a leaf and the bounds that were enclosed there. Reciprocity has no
// cover: both orders are recorded again. "growth" of an albedo that is not bounded has its factor's upper end from the cover and its
// lower end from one `width`.
#pragma once

#include <string>
#include <vector>

#include "io/content.h"
#include "io/json.h"

namespace brdf::prove {

// The text of a certificate with these results.
std::string sealed(const io::Json& results);

struct Checked {
  long results = 0, leaves = 0;
  std::vector<std::string> faults;  // one sentence each; empty: every result holds
};

// Encloses every leaf again and asks whether it settles the property, whether its bounds are those of the certificate, and
// whether the tree covers the domain of the form as this program has it; a broken seal ends the check. Throws InputError where
// it is no certificate.
Checked check(const io::Content& certificate);

}  // namespace brdf::prove
