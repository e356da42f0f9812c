#include "sheet/data_sheet.h"

#include <algorithm>

#include "io/files/numbers.h"
#include "io/files/text.h"
#include "sheet/checks.h"
#include "sheet/integral.h"

namespace brdf::sheet {
namespace {

std::vector<double> each_once(std::vector<double> angles) {
  std::ranges::sort(angles);
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
  return angles;
}

std::vector<std::pair<std::string, std::string>> facts_of(const io::SampleTable& t) {
  std::vector<std::pair<std::string, std::string>> facts{{"rows", std::to_string(t.rows())}};
  facts.emplace_back("channels", io::joined(t.channels));
  if (!is_of_cells(t)) {  // cells have no common lights
    const std::vector<double> lights = each_once(t.theta_i);
    facts.emplace_back("angles of incidence", std::to_string(lights.size()) + " from " +
                                                  io::to_text(lights.front()) + " to " +
                                                  io::to_text(lights.back()) + " degrees");
    facts.emplace_back("rotations of the sample", std::to_string(each_once(t.phi_i).size()));
  }
  facts.emplace_back("largest viewing angle", io::to_text(*std::ranges::max_element(t.theta_o)) + " degrees");
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    const auto [low, high] = std::minmax_element(t.values[c].begin(), t.values[c].end());
    facts.emplace_back("f_r of " + t.channels[c],
                       io::short_number(*low) + " to " + io::short_number(*high) + " /sr");
  }
  for (const char* key : {"sample", "instrument", "source", "licence"})
    if (const auto value = t.find_metadata(key)) facts.emplace_back(key, *value);
  return facts;
}

// A fault that makes the results of other checks false.
struct Misleading {
  std::string_view fault;
  std::vector<std::string_view> misled;
  std::string_view why;
};

const std::vector<Misleading>& misleading() {
  static const std::vector<std::string_view> of_directions{
      "azimuth",       "directions", "mirror",   "outliers",   "reciprocity",
      "cosine_factor", "light_gain", "drift",    "dark_level", "invented",
      "noise_floor",   "quantity",   "isotropy", "coverage",   "energy"};
  static const std::vector<Misleading> all{
      {"angle_unit", {"polar_angle"}, "the angles are not in degrees"},
      {"angle_unit", of_directions, "the angles are not in degrees"},
      {"polar_angle", of_directions, "the polar angles are not measured from the normal"},
      {"azimuth",
       {"outliers", "cosine_factor", "mirror", "light_gain", "drift", "dark_level"},
       "the azimuths do not follow the convention of the format"},
      {"cosine_factor",
       {"reciprocity", "quantity", "energy", "dark_level", "light_gain", "drift", "mirror"},
       "the values include a cosine"},
      {"saturation", {"mirror"}, "the highlights are saturated"},
      {"mirror",
       {"outliers", "light_gain", "drift", "reciprocity", "dark_level"},
       "the angles have a systematic error"},
      {"light_gain", {"reciprocity", "energy"}, "the incidences are not on the same scale"},
      {"drift", {"reciprocity", "energy"}, "the scale drifts through the file"},
      {"dark_level", {"reciprocity"}, "the values include a dark level"},
      {"quantity", {"energy"}, "the values are not f_r"},
  };
  return all;
}

// Makes the named checks not_applicable with this reason. A check that already did not apply keeps its own
// reason.
void mislead(std::vector<Finding>& findings, const std::vector<std::string_view>& checks,
             const std::string& why) {
  for (Finding& f : findings)
    if (f.outcome != Outcome::not_applicable && std::ranges::find(checks, f.check) != checks.end())
      f = not_applicable(f.subject, f.check, why);
}

// Reports each fault once: its consequences are not judged, and do not mislead further checks.
void name_once(std::vector<Finding>& findings) {
  for (const Misleading& m : misleading()) {
    const bool failed = std::ranges::any_of(
        findings, [&](const Finding& f) { return f.check == m.fault && f.outcome == Outcome::fail; });
    if (failed) mislead(findings, m.misled, std::string(m.why));
  }
}

// Returns the rows within max_theta; all rows if there are no such rows.
std::vector<bool> rows_to_judge(const io::SampleTable& t, double max_theta) {
  std::vector<bool> inside = within(t, max_theta);
  if (std::ranges::find(inside, true) == inside.end()) inside.assign(t.rows(), true);
  return inside;
}

// Returns for each row of the file whether it holds a fill value; empty if no row does.
std::vector<bool> marked(const View& view, const std::vector<FillValue>& fill, std::size_t rows) {
  std::vector<bool> out;
  for (const FillValue& f : fill) {
    out.resize(rows);
    for (const Row k : f.rows) out[view.origin(k)] = true;
  }
  return out;
}

DataSheet sheet_of_scans(const io::SampleTable& t, const SheetOptions& options) {
  DataSheet sheet;
  const std::vector<bool> inside = rows_to_judge(t, options.max_theta);
  const View all(t, inside);
  std::vector<FillValue> fill = fill_values(all);
  std::vector<bool> keep = inside;
  if (!options.keep_fill) sheet.not_measured = marked(all, fill, t.rows());
  for (std::size_t k = 0; k < sheet.not_measured.size(); ++k) keep[k] = keep[k] && !sheet.not_measured[k];
  if (std::ranges::find(keep, true) == keep.end()) keep = inside;
  const View view(t, keep);
  const bool nothing_beyond = std::ranges::find(inside, false) == inside.end();
  std::vector<bool> measured = sheet.not_measured;
  measured.flip();
  std::optional<View> to_grazing;
  if (!nothing_beyond) to_grazing.emplace(t, measured);
  Evidence evidence{t,
                    options.max_theta,
                    all,
                    std::move(fill),
                    view,
                    nothing_beyond ? view : *to_grazing,
                    io::relative_noise(view.table()),
                    {},
                    {},
                    {},
                    {},
                    {}};
  evidence.turns = turns_of(view, evidence.neighbours.value);
  evidence.pairs = reciprocal_pairs(view);
  if (evidence.turns.is_anisotropic())
    std::erase_if(evidence.pairs, [](const Pair& p) { return !p.is_in_plane(); });
  evidence.causes = causes_of(view, evidence.pairs);
  evidence.scatter =
      scatter_of(view, evidence.neighbours, evidence.causes.found ? std::vector<Pair>{} : evidence.pairs,
                 evidence.turns.isotropy());
  evidence.albedo = albedos(view, evidence.scatter.value());
  for (const Check& check : checks()) sheet.findings.push_back(check.run(evidence));
  sheet.scatter = std::move(evidence.scatter);
  sheet.albedo = std::move(evidence.albedo);
  sheet.is_anisotropic = evidence.turns.is_anisotropic();
  return sheet;
}

}  // namespace

bool DataSheet::has_failed(std::string_view check) const {
  return std::ranges::any_of(
      findings, [&](const Finding& f) { return f.check == check && f.outcome == Outcome::fail; });
}

std::vector<const Finding*> DataSheet::faults() const {
  std::vector<const Finding*> found;
  for (const Finding& f : findings)
    if (f.outcome == Outcome::fail) found.push_back(&f);
  for (const Finding& f : findings)
    if (f.outcome == Outcome::undecided && f.is_suspicion) found.push_back(&f);
  return found;
}

DataSheet data_sheet(const io::SampleTable& t, const SheetOptions& options) {
  DataSheet sheet;
  if (t.rows() == 0) {
    sheet.findings.push_back(not_applicable(t.source, "missing", "the table has no rows"));
    sheet.findings.back().outcome = Outcome::fail;
    return sheet;
  }
  sheet = is_of_cells(t) ? sheet_of_cells(t, options.max_theta) : sheet_of_scans(t, options);
  sheet.facts = facts_of(t);
  name_once(sheet.findings);
  return sheet;
}

void set_apart(DataSheet& sheet, const std::vector<std::string_view>& checks, const std::string& why) {
  mislead(sheet.findings, checks, why);
}

std::vector<bool> not_measured(const io::SampleTable& t, double max_theta) {
  if (t.rows() == 0 || is_of_cells(t)) return {};
  const View view(t, rows_to_judge(t, max_theta));
  return marked(view, fill_values(view), t.rows());
}

void leave_out(const std::vector<bool>& rows, io::SampleTable& t) {
  const auto count = std::size_t(std::ranges::count(rows, true));
  if (count == 0) return;
  const auto thin = [&](auto& column) {
    if (column.empty()) return;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (!rows[k]) column[kept++] = column[k];
    column.resize(kept);
  };
  for (auto* column : {&t.theta_i, &t.phi_i, &t.theta_o, &t.phi_o}) thin(*column);
  for (auto* columns : {&t.values, &t.sigma})
    for (auto& column : *columns) thin(column);
  thin(t.lines);
  t.skipped += count;
  t.warnings.push_back(plural(count, "row") +
                       " with fill values left out: these directions were not measured");
}

DataSheet exchanged_columns(const io::SampleTable& t, const std::string& why) {
  DataSheet sheet;
  sheet.findings.push_back(start(t, "directions"));
  sheet.findings.back().outcome = Outcome::fail;
  sheet.findings.back().statement = why;
  return sheet;
}

}  // namespace brdf::sheet
