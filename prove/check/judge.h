// What is asked of a certificate, and whether it shows that: shared by `brdf prove --check` and brdf_check.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "io/files/content.h"
#include "prove/check/certificate.h"

namespace brdf::prove {

struct Asked {
  std::vector<Property>
      required;  // each must be there and proved, of every form and channel that is asked about
  std::vector<Property> properties;  // the same, and of no others is anything said; empty: of all
  std::vector<std::string>
      forms;  // that are asked about; with `materials` empty: all that are in the certificate
  std::vector<NamedMaterial> materials;  // as they are read from their own files
};

// Properties by their names. Throws InputError that begins with `option`.
std::vector<Property> properties_named(const std::string& option, const std::vector<std::string>& names);

struct Judged {
  Checked checked;                    // its results are those that are asked about
  std::vector<std::string> short_of;  // what is asked for and is not shown, one sentence each
  bool good = false;                  // every row holds and is a proof, and all that is asked for is there
};

Judged judge(const io::Content& certificate, const Asked& asked);

void print(std::ostream& out, const Judged& judged);
// The member `checked` of docs/prove.schema.json.
io::Json to_json(const Judged& judged);

}  // namespace brdf::prove
