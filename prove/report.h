// Proofs as text, as JSON and as certificates.
#pragma once

#include <ostream>
#include <span>

#include "io/files/json.h"
#include "prove/check/certificate.h"
#include "prove/proof.h"

namespace brdf::prove {

void print(std::ostream& out, std::span<const Proof> proofs);
// docs/prove.schema.json.
io::Json to_json(std::span<const Proof> proofs);
// What `brdf prove --check` and brdf_check read (prove/check/certificate.h): no times, so that the same
// proofs give the same bytes on every machine. In it is what is proved, what is refuted by a witness that the
// check can repeat, and the bound above that. `materials`: of all proofs that are of one.
std::string to_certificate(std::span<const Proof> proofs, std::span<const NamedMaterial> materials = {});

}  // namespace brdf::prove
