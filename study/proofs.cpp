#include "study/proofs.h"

#include <limits>

#include "prove/proof.h"

namespace brdf::study {
namespace {

const prove::SearchOptions kBrief{60, std::numeric_limits<double>::infinity()};

std::vector<prove::Proof> proofs_of_form(const Reflectance& form) {
  prove::Options brief;
  brief.search = kBrief;
  brief.properties.assign(prove::kPropertiesOfValues.begin(), prove::kPropertiesOfValues.end());
  brief.properties.push_back(prove::Property::energy);
  return prove::prove(form, brief);
}

std::vector<prove::Proof> proofs_of_material(const validate::Subject& subject) {
  return prove::prove_values(subject.own(), subject.name(), kBrief);
}

void mark(const validate::Subject& subject, const std::vector<prove::Proof>& proofs,
          std::vector<validate::Finding>& findings) {
  for (validate::Finding& f : findings) {
    const auto property = find_named<prove::Property>(f.check);
    if (!property || f.subject != subject.name() || f.outcome != validate::Outcome::pass) continue;
    bool any = false, all = true;
    for (const prove::Proof& p : proofs) {
      if (p.claim.property != *property) continue;
      any = true;
      all = all && p.verdict == prove::Verdict::proved;
    }
    f.proof = any && all ? "proved" : "sampled";
  }
}

}  // namespace

void mark_proofs_of_material(const validate::Subject& material, std::vector<validate::Finding>& findings) {
  mark(material, proofs_of_material(material), findings);
}

void mark_proofs(const std::vector<validate::Subject>& subjects, std::vector<validate::Finding>& findings) {
  for (const validate::Subject& subject : subjects) {
    std::vector<prove::Proof> proofs;  // empty for outside code, which has no place in the catalogue
    if (!subject.is_outside())
      proofs = subject.of_form() ? proofs_of_form(*subject.of_form()) : proofs_of_material(subject);
    mark(subject, proofs, findings);
  }
}

}  // namespace brdf::study
