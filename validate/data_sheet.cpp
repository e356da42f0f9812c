#include "validate/data_sheet.h"

#include <algorithm>
#include <set>

#include "io/numbers.h"
#include "io/text.h"
#include "validate/sheet_checks.h"

namespace brdf::validate {
namespace {

std::vector<std::pair<std::string, std::string>> facts_of(const io::SampleTable& t) {
  std::vector<std::pair<std::string, std::string>> facts{{"rows", std::to_string(t.rows())}};
  facts.emplace_back("channels", io::joined(t.channels));
  std::set<double> lights, turns;
  if (!is_of_cells(t)) {  // which have no common lights
    lights.insert(t.theta_i.begin(), t.theta_i.end());
    turns.insert(t.phi_i.begin(), t.phi_i.end());
  }
  if (!lights.empty())
    facts.emplace_back("angles of the light", std::to_string(lights.size()) + " from " +
                                                  io::to_text(*lights.begin()) + " to " +
                                                  io::to_text(*lights.rbegin()) + " degrees");
  if (!turns.empty()) facts.emplace_back("turns of the sample", std::to_string(turns.size()));
  facts.emplace_back("largest angle of the viewer",
                     io::to_text(*std::max_element(t.theta_o.begin(), t.theta_o.end())) + " degrees");
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    const auto [low, high] = std::minmax_element(t.values[c].begin(), t.values[c].end());
    facts.emplace_back("f_r of " + t.channels[c],
                       io::short_number(*low) + " to " + io::short_number(*high) + " /sr");
  }
  for (const char* key : {"sample", "instrument", "source", "licence"})
    if (const auto value = t.find_metadata(key)) facts.emplace_back(key, *value);
  return facts;
}

// A check that another fault misleads; what was not applicable keeps its own reason.
void mislead(std::vector<Finding>& findings, const std::vector<std::string_view>& checks,
             const std::string& why) {
  for (Finding& f : findings)
    if (std::find(checks.begin(), checks.end(), f.check) != checks.end() &&
        f.outcome != Outcome::not_applicable)
      f = not_applicable(f.subject, f.check, why);
}

// One fault, one name: what follows from it is not judged.
void name_once(std::vector<Finding>& findings) {
  const auto failed = [&](std::string_view check) {
    return std::any_of(findings.begin(), findings.end(),
                       [&](const Finding& f) { return f.check == check && f.outcome == Outcome::fail; });
  };
  if (failed("cosine_factor"))
    mislead(findings, {"reciprocity", "quantity", "energy"},
            "light and viewer cannot be exchanged while a cosine is left in the values");
  if (failed("quantity")) mislead(findings, {"energy"}, "the values are no f_r");
  if (failed("azimuth"))
    mislead(findings, {"outliers", "cosine_factor"}, "the azimuths are not those of the format");
  const std::vector<std::string_view> of_directions{"azimuth",     "directions",    "outliers", "reciprocity",
                                                    "noise_floor", "cosine_factor", "quantity", "isotropy",
                                                    "coverage",    "energy"};
  if (failed("angle_unit")) mislead(findings, {"polar_angle"}, "the angles are no degrees");
  if (failed("angle_unit")) mislead(findings, of_directions, "the angles are no degrees");
  if (failed("polar_angle")) mislead(findings, of_directions, "the angles are not from the normal");
}

void add_scan_findings(const io::SampleTable& t, double max_theta, DataSheet& sheet) {
  const auto pairs = io::interpolated_pairs(t);
  const io::CosineFactor cosine = io::cosine_factor(t, pairs);
  const Finding noise =
      noise_floor(t, cosine.found == io::Cosine::none ? pairs : std::vector<io::ReciprocalPair>{});
  constexpr double kUnknownNoise = 0.1;
  const double scatter = noise.outcome == Outcome::not_applicable
                             ? exchanged_difference(pairs).value_or(kUnknownNoise)
                             : noise.value;
  // Integrals at up to 60 angles of the light: a large table has thousands.
  const auto groups = by_light(t);
  const std::size_t stride = (groups.size() + 59) / 60;
  std::size_t index = 0;
  for (const auto& [light, rows] : groups)
    if (index++ % stride == 0) sheet.albedo.push_back(integrate(t, rows, scatter));
  for (Finding& f : std::vector<Finding>{
           duplicates(t), angle_unit(t), polar_angle(t, cosine), azimuth(t), directions(t),
           outliers(t, max_theta), saturation(t), exact_reciprocity(t), noise, cosine_factor(t, cosine),
           quantity(t, sheet.albedo), isotropy(t), coverage(t, sheet.albedo), energy(t, sheet.albedo)})
    sheet.findings.push_back(std::move(f));
}

}  // namespace

DataSheet data_sheet(const io::SampleTable& t, double max_theta) {
  DataSheet sheet;
  if (t.rows() == 0) {
    sheet.findings.push_back(not_applicable(t.source, "missing", "the table has no rows"));
    sheet.findings.back().outcome = Outcome::fail;
    return sheet;
  }
  sheet.facts = facts_of(t);
  sheet.findings = {negative(t), missing(t)};
  is_of_cells(t) ? add_cell_findings(t, max_theta, sheet) : add_scan_findings(t, max_theta, sheet);
  name_once(sheet.findings);
  return sheet;
}

std::vector<std::string> data_sheet_names() {
  return {"negative",   "missing",  "duplicates", "angle_unit",  "polar_angle", "azimuth",
          "directions", "outliers", "saturation", "reciprocity", "noise_floor", "cosine_factor",
          "quantity",   "isotropy", "coverage",   "energy"};
}

DataSheet exchanged_columns(const io::SampleTable& t, const std::string& why) {
  DataSheet sheet;
  sheet.findings.push_back(start(t, "directions"));
  sheet.findings.back().outcome = Outcome::fail;
  sheet.findings.back().statement = why;
  return sheet;
}

}  // namespace brdf::validate
