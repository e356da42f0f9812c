// Certificates: what `brdf prove -o` writes, and the check of it, which searches nothing.
//
// {"format": "brdf-proof", "version": 2, "seal": SHA-256 of the file's bytes without the seal's own digits,
// "results": [rows], "materials": [{file, material}]}. The seal shows damage; anybody can write it anew, so
// the check rests on nothing but the rows. The first version, whose seal is a checksum and which has no
// materials, is read as well. A row of a form: {form, property, scalar, arithmetic, low, high, domain:
// {variable: [low, high]}, cover, witness}. A cover is a tree of cuts in the order root, first half, second
// half: [variable, where] for a cut, [low, high] for a leaf and the bounds that were enclosed there.
// Reciprocity has no cover: both orders are recorded again. A witness {violation, angles in degrees} is one
// of the violations that the form declares, measured again. "growth" of an albedo that is not bounded has its
// factor's upper end from the cover and its lower end from one `width`. A row of a material: {material,
// channel, property, scalar, arithmetic}, and `terms`, the low, high, domain and cover of each; of energy
// `low`, which is reached at the view `low_at`, high, domain, and a cover whose leaves are [low, high,
// accuracy of the cells]; or the angles of a witness.
#pragma once

#include <string>
#include <vector>

#include "io/files/content.h"
#include "io/files/json.h"
#include "io/material/material_json.h"
#include "prove/check/claim.h"

namespace brdf::prove {

inline constexpr std::string_view kGrowth = "growth";

// The text of a certificate with these results.
std::string sealed(const io::Json& results, const io::Json& materials = io::Json::array());
// A domain as certificates hold it.
io::Json ranges_of(const Domain& domain);

// A material that proofs are about, under the name that they have for it.
struct NamedMaterial {
  std::string file;
  Material material;
};

// One row, and what its numbers show once they are enclosed again: what the row calls itself is compared with
// that, never believed.
struct CheckedResult {
  std::string subject{}, channel{};  // a form, or a material's file; the channel of a material
  std::string property{};            // a property's name, or kGrowth
  Precision precision = Precision::double_type;
  Verdict verdict = Verdict::no_method;
  std::string statement{};  // one sentence
  std::string fault{};      // empty: the row holds
};

struct Checked {
  std::vector<CheckedResult> results;
  std::vector<NamedMaterial> materials;
  long leaves = 0;
  std::vector<std::string> faults;  // one sentence each; empty: every result holds
};

// Encloses every leaf again and asks whether it settles the property, whether its bounds are those of the
// certificate, and whether the tree covers the domain of the form or the material as this program has it; a
// broken seal ends the check. Throws InputError where it is no certificate, or one of another version.
Checked check(const io::Content& certificate);

}  // namespace brdf::prove
