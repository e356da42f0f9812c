// Certificates, which `brdf prove -o` writes, and their check, which performs no search.
//
// A certificate is {"format": "brdf-proof", "version": 2, "seal": SHA-256 of the file's bytes without the
// seal's own digits, "results": [rows], "materials": [{file, material}]}. The seal shows damage. Anybody
// can compute a new seal, so that the check relies on the rows alone. Version 1, with a checksum as its
// seal and without materials, is read as well.
//
// The row of a form is {form, property, scalar, arithmetic, low, high, domain: {variable: [low, high]},
// cover, witness}. A cover is a tree of cuts in the order root, first half, second half: [variable,
// position] for a cut, and for a leaf [low, high], the bounds that were enclosed there. Reciprocity has no
// cover: both orders are recorded again. A witness {violation, angles in degrees} is one of the violations
// that the form declares, measured again. "growth" of an unbounded albedo takes the upper end of its factor
// from the cover and the lower end from one `width`.
//
// The row of a material is {material, channel, property, scalar, arithmetic} with `terms`, which hold the
// low, high, domain and cover of each term. For energy the row has `low`, which is reached at the view
// `low_at`, high, domain, and a cover with leaves [low, high, accuracy of the cells]. Alternatively the row
// has the angles of a witness.
#pragma once

#include <string>
#include <vector>

#include "io/files/content.h"
#include "io/files/json.h"
#include "io/material/material_json.h"
#include "prove/check/claim.h"

namespace brdf::prove {

inline constexpr std::string_view kGrowth = "growth";

// Returns the text of a certificate with these results.
std::string sealed(const io::Json& results, const io::Json& materials = io::Json::array());
// Returns a domain in the notation of certificates.
io::Json ranges_of(const Domain& domain);

// A material that proofs are about, under the name that the proofs use.
struct NamedMaterial {
  std::string file;
  Material material;
};

// One row and the result of enclosing its numbers again. The row's own statement is compared with that
// result, never believed.
struct CheckedResult {
  std::string subject{}, channel{};  // a form or a material's file; the channel of a material
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

// Encloses every leaf again. Checks that the leaf settles the property, that its bounds equal the bounds in
// the certificate, and that the tree covers the domain which this program has for the form or the material.
// A broken seal ends the check. Throws InputError if the content is not a certificate, or has another
// version.
Checked check(const io::Content& certificate);

}  // namespace brdf::prove
