#include "validate/data_sheet.h"

#include <algorithm>
#include <set>

#include "io/numbers.h"
#include "io/text.h"
#include "validate/sheet_checks.h"

namespace brdf::validate {
namespace {

std::vector<std::pair<std::string, std::string>> facts_of(const io::SampleTable& t) {
  const std::set<double> lights(t.theta_i.begin(), t.theta_i.end()), turns(t.phi_i.begin(), t.phi_i.end());
  std::vector<std::pair<std::string, std::string>> facts{{"rows", std::to_string(t.rows())}};
  facts.emplace_back("channels", io::joined(t.channels));
  facts.emplace_back("angles of the light", std::to_string(lights.size()) + " from " +
                                                io::to_text(*lights.begin()) + " to " +
                                                io::to_text(*lights.rbegin()) + " degrees");
  facts.emplace_back("turns of the sample", std::to_string(turns.size()));
  facts.emplace_back("largest angle of the viewer",
                     io::to_text(*std::max_element(t.theta_o.begin(), t.theta_o.end())) + " degrees");
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    const auto [low, high] = std::minmax_element(t.values[c].begin(), t.values[c].end());
    facts.emplace_back("f_r of " + t.channels[c], io::to_text(*low) + " to " + io::to_text(*high) + " /sr");
  }
  for (const char* key : {"sample", "instrument", "source", "licence"})
    if (const auto value = t.find_metadata(key)) facts.emplace_back(key, *value);
  return facts;
}

}  // namespace

DataSheet data_sheet(const io::SampleTable& t) {
  DataSheet sheet;
  if (t.rows() == 0) {
    sheet.findings.push_back(not_applicable(t.source, "missing", "the table has no rows"));
    sheet.findings.back().outcome = Outcome::fail;
    return sheet;
  }
  sheet.facts = facts_of(t);
  const auto pairs = interpolated_pairs(t);
  const Finding cosine = cosine_factor(t, pairs);
  Finding noise = noise_floor(t, pairs), reciprocity = exact_reciprocity(t);
  if (cosine.outcome == Outcome::fail)  // one fault, one name
    for (Finding* f : {&noise, &reciprocity})
      if (f->outcome != Outcome::not_applicable)
        *f = not_applicable(t.source, f->check,
                            "light and viewer cannot be exchanged while a cosine is left in the values");
  // Integrals at up to 60 angles of the light: a large table has thousands.
  const auto groups = by_light(t);
  const std::size_t stride = (groups.size() + 59) / 60;
  std::size_t index = 0;
  for (const auto& [light, rows] : groups)
    if (index++ % stride == 0)
      sheet.albedo.push_back(
          integrate(t, rows, noise.outcome == Outcome::not_applicable ? 0.1 : noise.value));
  sheet.findings = {negative(t),
                    missing(t),
                    duplicates(t),
                    directions(t),
                    outliers(t),
                    reciprocity,
                    noise,
                    cosine,
                    isotropy(t),
                    coverage(t, sheet.albedo),
                    energy(t, sheet.albedo)};
  return sheet;
}

std::vector<std::string> data_sheet_names() {
  return {"negative",    "missing",       "duplicates", "directions", "outliers", "reciprocity",
          "noise_floor", "cosine_factor", "isotropy",   "coverage",   "energy"};
}

DataSheet exchanged_columns(const io::SampleTable& t, const std::string& why) {
  DataSheet sheet;
  sheet.findings.push_back(start(t, "directions"));
  sheet.findings.back().outcome = Outcome::fail;
  sheet.findings.back().statement = why;
  return sheet;
}

}  // namespace brdf::validate
