// Checks rows about materials, each channel at its own parameters.
#include <algorithm>

#include "io/files/numbers.h"
#include "prove/check/cover_walk.h"
#include "prove/check/rows.h"
#include "prove/check/sum_of_albedos.h"
#include "prove/scalar/swapped.h"

namespace brdf::prove {
namespace {

using io::JsonPlace;

const NamedMaterial& material_of(const JsonPlace& place, std::span<const NamedMaterial> materials) {
  const std::string file = place.text();
  const auto found = std::ranges::find(materials, file, &NamedMaterial::file);
  if (found == materials.end()) place.fail("is not a material of the certificate");
  return *found;
}

std::size_t channel_of(const JsonPlace& place, const Material& material) {
  const auto found = std::ranges::find(material.channels, place.text());
  if (found == material.channels.end()) place.fail("is not a channel of the material");
  return std::size_t(found - material.channels.begin());
}

void check_both_orders(CheckedResult& r, const Material& material, const JsonPlace& row) {
  row.allow_keys({"material", "property", "scalar", "arithmetic"});
  bool bits = true;
  for (const Term& term : material.terms) {
    const int form = catalogue_index(term.form);
    const bool of_bits = form >= 0 && record_both_orders(form, Rules::bits).same;
    bits = bits && of_bits;
    if (form < 0 || !(of_bits || record_both_orders(form, Rules::exact).same))
      r.fault = "the formulas for both orders differ";
  }
  const Claim claim{-1, Property::reciprocity, Precision::double_type};
  if (r.fault.empty()) r.fault = other_words(row, claim, arithmetic_of(claim, bits));
  r.verdict = Verdict::proved;
  r.statement = "f(wi, wo) and f(wo, wi) are the same for every term";
}

// Checks the cover of one term at the channel's parameters; adds its upper end to `sum`.
std::string term_covers(const Claim& claim, const Channel& c, const JsonPlace& term, double& sum,
                        long& leaves) {
  term.allow_keys({"low", "high", "domain", "cover"});
  const Domain domain = domain_at(c, claim);
  if (std::string fault = other_domain(domain, term); !fault.empty()) return fault;
  const JsonPlace cover = term.at("cover");
  const Walked walked =
      walk({domain, cover, [&](std::span<const Bounds> box, const JsonPlace&) { return enclose(claim, box); },
            [&](Bounds b) { return settles(claim.property, b, 0); }},
           leaves);
  if (!walked.fault.empty()) return walked.fault;
  if (walked.range.lo != term.at("low").number() || walked.range.hi != term.at("high").number())
    return "low and high do not match the leaves";
  sum += walked.range.hi;
  return "";
}

void check_terms(CheckedResult& r, const Channels& channels, const JsonPlace& row, Claim claim,
                 long& leaves) {
  row.allow_keys({"material", "channel", "property", "scalar", "arithmetic", "terms"});
  const JsonPlace terms = row.at("terms");
  if (terms.size() != channels.size()) terms.fail("must have one member for each term of the material");
  if (claim.property == Property::rounding && channels.size() > 1)
    row.at("property").fail("can be proved for single terms only");
  r.fault = other_words(row, claim, arithmetic_of(claim));
  double high = 0;
  for (std::size_t k = 0; k < channels.size() && r.fault.empty(); ++k) {
    claim.form = catalogue_index(channels[k].term.form);
    r.fault = claim.form < 0 ? "is a model of another program, for which the prover has no method"
                             : term_covers(claim, channels[k], terms.at(k), high, leaves);
  }
  if (r.fault.empty() && claim.property == Property::finite && channels.size() > 1 &&
      may_overflow(high, claim.precision))
    r.fault = "an overflow of the sum is not excluded";
  r.verdict = Verdict::proved;
  r.statement =
      claim.property == Property::rounding
          ? "the lobes' errors are at most " + io::short_number(high, 3) + ", relative or of their peaks"
          : std::string(statement_of(claim.property));
}

// Checks the cover of the largest albedo, and that `low` is reached.
std::string albedo_covers(const SumOfAlbedos& albedo, const JsonPlace& row, long& leaves) {
  const Domain domain = albedo.domain();
  if (std::string fault = other_domain(domain, row); !fault.empty()) return fault;
  const JsonPlace at = row.at("low_at"), cover = row.at("cover");
  if (at.size() != domain.variables.size()) at.fail("must have one member for each variable of the domain");
  std::vector<Bounds> view;
  for (std::size_t k = 0; k < at.size(); ++k) view.push_back({at.at(k).number(0, 1), at.at(k).number(0, 1)});
  const double low = row.at("low").number(), high = row.at("high").number();
  const auto& accuracies = SumOfAlbedos::kAccuracies;
  if (albedo(SumOfAlbedos::views_of(view), accuracies.back()).value.lo != low)
    return "low is not the value reached at this direction";
  const auto enclose_leaf = [&](std::span<const Bounds> box, const JsonPlace& leaf) -> std::optional<Bounds> {
    const double accuracy = leaf.at(2).number();
    if (std::ranges::find(accuracies, accuracy) == accuracies.end()) return std::nullopt;
    return SumOfAlbedos::within_range(albedo(SumOfAlbedos::views_of(box), accuracy).value);
  };
  const Walked walked = walk({domain, cover, enclose_leaf, [](Bounds) { return true; }, 3}, leaves);
  if (!walked.fault.empty()) return walked.fault;
  return std::max(walked.range.hi, low) == high ? "" : "high does not match the leaves";
}

void check_albedo(CheckedResult& r, const Channels& channels, const JsonPlace& row, const Claim& claim,
                  long& leaves) {
  row.allow_keys({"material", "channel", "property", "scalar", "arithmetic", "low", "low_at", "high",
                  "domain", "cover", "witness"});
  const bool has_witness = row.has("witness"), has_cover = row.has("cover");
  if (!has_cover && !has_witness) row.at("cover");
  if (!has_cover)
    for (const char* key : {"low", "low_at", "high", "domain"})
      if (row.has(key)) row.at(key).fail("is allowed only with a cover");
  r.fault = other_words(row, claim, kExact);
  if (r.fault.empty() && has_cover) {
    const SumOfAlbedos albedo(channels);
    r.fault = albedo.known() ? albedo_covers(albedo, row, leaves)
                             : "the prover has neither a closed form nor cells for the albedo";
  }
  if (!r.fault.empty()) return;
  if (has_cover) {
    const double low = row.at("low").number(), high = row.at("high").number();
    r.statement =
        "the largest albedo is in [" + io::short_number(low, 6) + ", " + io::short_number(high, 6) + "]";
    r.verdict = high <= 1 + kRoundedConstants ? Verdict::proved
                : low > 1 + kRoundedConstants ? Verdict::refuted
                                              : Verdict::bounded;
  }
  if (!has_witness) return;
  const JsonPlace witness = row.at("witness");
  witness.allow_keys({"theta", "phi"});
  const double theta = witness.at("theta").number(0, 90), phi = witness.at("phi").number(-360, 360);
  const MeasuredAlbedo found = measured_albedo(channels, theta, phi);
  if (!(found.least > 1)) {
    r.fault = "the witness shows no albedo above 1";
    return;
  }
  r.verdict = Verdict::refuted;
  r.statement = "the albedo is " + io::short_number(found.value, 6) + " at " + io::short_number(theta, 6) +
                " degrees, above 1" + (r.statement.empty() ? "" : "; " + r.statement);
}

}  // namespace

CheckedResult check_material_row(const JsonPlace& row, std::span<const NamedMaterial> materials,
                                 long& leaves) {
  const NamedMaterial& named = material_of(row.at("material"), materials);
  const Claim claim = claim_of_row(row, -1);
  CheckedResult r{.subject = named.file, .property = row.at("property").text(), .precision = claim.precision};
  if (claim.property == Property::reciprocity) {
    check_both_orders(r, named.material, row);
    return r;
  }
  r.channel = row.at("channel").text();
  const Channels channels = channels_of(named.material, channel_of(row.at("channel"), named.material));
  if (claim.property == Property::energy)
    check_albedo(r, channels, row, claim, leaves);
  else
    check_terms(r, channels, row, claim, leaves);
  return r;
}

}  // namespace brdf::prove
