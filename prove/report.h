// Writes proofs as text, as JSON and as certificates.
#pragma once

#include <ostream>
#include <span>

#include "io/files/json.h"
#include "prove/check/certificate.h"
#include "prove/proof.h"

namespace brdf::prove {

// Prints the proofs for people.
void print(std::ostream& out, std::span<const Proof> proofs);
// Returns the proofs as docs/prove.schema.json defines them.
io::Json to_json(std::span<const Proof> proofs);
// Returns the certificate that `brdf prove --check` and brdf_check read (prove/check/certificate.h). The
// certificate has no times, so that the same proofs give the same bytes on every machine. It holds the
// proved properties, the properties refuted by a witness that the check can repeat, and the bound above
// that witness. `materials`: the materials of all proofs that concern one.
std::string to_certificate(std::span<const Proof> proofs, std::span<const NamedMaterial> materials = {});

}  // namespace brdf::prove
