// Compares a certificate with the properties that a user requires: shared by `brdf prove --check` and
// brdf_check.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "io/files/content.h"
#include "prove/check/certificate.h"

namespace brdf::prove {

struct Asked {
  // Properties that must be present and proved, for every form and channel requested.
  std::vector<Property> required;
  // Properties that are also required. Results of properties in neither list are omitted. Empty: all
  // properties.
  std::vector<Property> properties;
  // The forms requested. If `materials` is empty too: all subjects of the certificate.
  std::vector<std::string> forms;
  std::vector<NamedMaterial> materials;  // as read from their own files
};

// Returns the properties with these names. Throws InputError with a message that begins with `option`.
std::vector<Property> properties_named(const std::string& option, const std::vector<std::string>& names);

struct Judged {
  Checked checked;  // only the results requested
  // One sentence for each requirement that is not shown.
  std::vector<std::string> short_of;
  // True if every row holds and is a proof, and everything required is present.
  bool good = false;
};

// Checks the certificate and compares its results with the requirements.
Judged judge(const io::Content& certificate, const Asked& asked);

// Prints the results, the faults and the requirements that are not shown.
void print(std::ostream& out, const Judged& judged);
// Returns the member `checked` of docs/prove.schema.json.
io::Json to_json(const Judged& judged);

}  // namespace brdf::prove
