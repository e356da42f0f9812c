#include "study/proofs.h"

#include <algorithm>
#include <limits>

#include "prove/proof.h"

namespace brdf::study {
namespace {

constexpr long kBoxes = 60;

std::vector<prove::Property> proved_of(const validate::Subject& subject) {
  prove::Options brief;
  brief.search = {kBoxes, std::numeric_limits<double>::infinity()};
  std::vector<prove::Proof> proofs;
  brief.properties = {prove::Property::finite, prove::Property::non_negative, prove::Property::reciprocity};
  if (subject.of_form()) {
    brief.properties.push_back(prove::Property::energy);
    proofs = prove::prove(*subject.of_form(), brief);
  } else {
    proofs = prove::prove(subject.own(), subject.name(), brief);
  }
  std::vector<prove::Property> proved;
  for (const prove::Property property : brief.properties) {
    const auto holds = [&](const prove::Proof& p) {
      return p.claim.property != property || p.verdict == prove::Verdict::proved;
    };
    if (std::ranges::all_of(proofs, holds)) proved.push_back(property);
  }
  return proved;
}

}  // namespace

void mark_proofs(const std::vector<validate::Subject>& subjects, std::vector<validate::Finding>& findings) {
  for (const validate::Subject& subject : subjects) {
    std::vector<prove::Property> proved;
    if (!subject.is_outside()) proved = proved_of(subject);
    for (validate::Finding& f : findings) {
      const auto property = find_named<prove::Property>(f.check);
      if (!property || f.subject != subject.name() || f.outcome != validate::Outcome::pass) continue;
      f.proof = std::ranges::find(proved, *property) == proved.end() ? "sampled" : "proved";
    }
  }
}

}  // namespace brdf::study
