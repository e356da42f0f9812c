// Checks rows about forms over their whole domain.
#include <algorithm>

#include "io/files/numbers.h"
#include "io/material/settings.h"
#include "io/samples/degrees.h"
#include "prove/check/channel.h"
#include "prove/check/cover_walk.h"
#include "prove/check/rows.h"
#include "prove/energy/energy.h"
#include "prove/energy/growth.h"
#include "prove/scalar/swapped.h"

namespace brdf::prove {
namespace {

using io::JsonPlace;

int catalogue_place(const JsonPlace& place) {
  const auto form = find_form(place.text());
  const int index = form ? catalogue_index(*form) : -1;
  if (index < 0) place.fail("is not a form of the catalogue");
  return index;
}

// Checks a row with a cover; low and high must agree with the leaves.
std::string covers(const Claim& claim, const JsonPlace& row, long& leaves) {
  const auto domain = domain_of(claim);
  if (!domain) return "is not a property that boxes can prove";
  if (std::string fault = other_domain(*domain, row); !fault.empty()) return fault;
  const JsonPlace cover = row.at("cover");
  const double low = row.at("low").number(), high = row.at("high").number();
  const Walked walked = walk(
      {*domain, cover, [&](std::span<const Bounds> box, const JsonPlace&) { return enclose(claim, box); },
       [&](Bounds b) { return settles(claim.property, b, high); }},
      leaves);
  if (!walked.fault.empty()) return walked.fault;
  return walked.range.lo == low && walked.range.hi == high ? "" : "low and high do not match the leaves";
}

// Checks the growth of an albedo: `high` over all widths and cosines by the cover, `low` at one width.
void check_growth(CheckedResult& r, int form, const JsonPlace& row, long& leaves) {
  row.allow_keys({"form", "property", "scalar", "arithmetic", "low", "high", "width", "domain", "cover"});
  const GrowthMethod* method = growth_method(form);
  r.fault = method == nullptr ? "has no known growth" : other_domain(method->domain, row);
  if (r.fault.empty()) r.fault = other_words(row, {form, Property::energy, Precision::double_type}, kExact);
  if (!r.fault.empty()) return;
  const JsonPlace cover = row.at("cover");
  const double low = row.at("low").number(), high = row.at("high").number(), width = row.at("width").number();
  const Walked walked =
      walk({method->domain, cover,
            [&](std::span<const Bounds> box, const JsonPlace&) { return method->most(box); },
            [&](Bounds b) { return b.hi <= high; }},
           leaves);
  const Variable& widths = method->domain.variables[0];
  if (!walked.fault.empty())
    r.fault = walked.fault;
  else if (walked.range.hi != high)
    r.fault = "high does not match the leaves";
  else if (!(widths.low <= width && width <= widths.high))
    r.fault = "the width is outside the range of the form";
  else if (reached_at(*method, width).least != low)
    r.fault = "low is not the value reached at this width";
  r.verdict = Verdict::proved;
  r.statement = "beyond an angle of incidence of " + io::short_number(method->from, 3) +
                " degrees the largest albedo is K/" +
                (method->power == 1 ? "cos" : "cos^" + io::short_number(method->power, 2)) + ", K in [" +
                io::short_number(low, 3) + ", " + io::short_number(high, 3) + "]";
}

void check_reciprocity(CheckedResult& r, const Claim& claim, const JsonPlace& row) {
  row.allow_keys({"form", "property", "scalar", "arithmetic"});
  const bool bits = record_both_orders(claim.form, Rules::bits).same;
  if (!bits && !record_both_orders(claim.form, Rules::exact).same)
    r.fault = "the formulas for both orders differ";
  else
    r.fault = other_words(row, claim, arithmetic_of(claim, bits));
  r.verdict = Verdict::proved;
  r.statement = bits ? "f(wi, wo) and f(wo, wi) are the same operations"
                     : "f(wi, wo) and f(wo, wi) are the same sums and products in another order";
}

// Measures a violation that the form declares again, at the angles of the witness. Returns an empty text if
// the property is not violated there.
std::string violation_at(const Claim& claim, const JsonPlace& witness) {
  const Reflectance& form = catalogue()[std::size_t(claim.form)];
  const auto declared = form.info().violations;
  const auto k = witness.at("violation").whole(-1, 1e6);
  if (k < 0 || k >= double(declared.size()) || declared[std::size_t(k)].check != name_of(claim.property))
    return "";
  const Material material = declared_material(form, declared[std::size_t(k)]);
  if (claim.property == Property::energy) {
    witness.allow_keys({"violation", "theta", "phi"});
    const double theta = witness.at("theta").number(0, 90), phi = witness.at("phi").number(-360, 360);
    const MeasuredAlbedo found = measured_albedo(channels_of(material, 0), theta, phi);
    return found.least > 1 ? "the albedo is " + io::short_number(found.value, 6) + " at " +
                                 io::short_number(theta, 6) + " degrees, above 1"
                           : "";
  }
  witness.allow_keys({"violation", "theta_i", "phi_i", "theta_o", "phi_o"});
  const auto direction = [&](const std::string& of) {
    return io::unit_vector(witness.at("theta_" + of).number(0, 90),
                           witness.at("phi_" + of).number(-360, 360));
  };
  double f = 0;
  eval(material, direction("i"), direction("o"), {&f, 1});
  return f < 0 ? "f is " + io::short_number(f, 6) + " there, below 0" : "";
}

void check_boxes(CheckedResult& r, const Claim& claim, const JsonPlace& row, long& leaves) {
  row.allow_keys({"form", "property", "scalar", "arithmetic", "low", "high", "domain", "cover", "witness"});
  const bool has_witness = row.has("witness"), has_cover = row.has("cover");
  if (!has_cover && !has_witness) row.at("cover");
  if (!has_cover)
    for (const char* key : {"low", "high", "domain"})
      if (row.has(key)) row.at(key).fail("is allowed only with a cover");
  r.fault = other_words(row, claim, arithmetic_of(claim));
  if (r.fault.empty() && has_cover) r.fault = covers(claim, row, leaves);
  if (!r.fault.empty()) return;
  r.verdict = Verdict::proved;
  const double high = has_cover ? row.at("high").number() : 0;
  if (claim.property == Property::energy && has_cover) {
    r.statement = "the albedo is at most " + io::short_number(high, 8);
    const bool tied =
        std::ranges::any_of(domain_of(claim)->variables, [](const Variable& v) { return v.tied; });
    if (tied)
      r.statement += " for equal widths; nothing is shown for unequal widths";
    else if (high > 1 + kRoundedConstants)
      r.statement += ", which may be above 1";
    if (tied || high > 1 + kRoundedConstants) r.verdict = Verdict::bounded;
  } else if (claim.property == Property::rounding) {
    r.statement =
        "the lobes' errors are at most " + io::short_number(high, 3) + ", relative or of their peaks";
  } else {
    r.statement = statement_of(claim.property);
  }
  if (!has_witness) return;
  const std::string violation = violation_at(claim, row.at("witness"));
  if (violation.empty()) {
    r.fault = "the witness shows no declared violation of the form";
    return;
  }
  r.verdict = Verdict::refuted;
  r.statement = violation + (has_cover && claim.property == Property::energy ? "; " + r.statement : "");
}

}  // namespace

Claim claim_of_row(const JsonPlace& row, int form) {
  const auto property = row.at("property").named<Property>();
  return {form, property,
          is_of_a_precision(property) ? row.at("scalar").named<Precision>() : Precision::double_type};
}

std::string other_words(const JsonPlace& row, const Claim& claim, std::string_view arithmetic) {
  if (row.at("scalar").text() != scalar_of(claim))
    return "the scalar must be " + std::string(scalar_of(claim));
  if (row.at("arithmetic").text() != arithmetic)
    return "the arithmetic must be \"" + std::string(arithmetic) + "\"";
  return "";
}

CheckedResult check_form_row(const JsonPlace& row, long& leaves) {
  const int form = catalogue_place(row.at("form"));
  CheckedResult r{.subject = row.at("form").text(), .property = row.at("property").text()};
  if (r.property == kGrowth) {
    check_growth(r, form, row, leaves);
    return r;
  }
  const Claim claim = claim_of_row(row, form);
  r.precision = claim.precision;
  if (claim.property == Property::reciprocity)
    check_reciprocity(r, claim, row);
  else
    check_boxes(r, claim, row, leaves);
  return r;
}

}  // namespace brdf::prove
