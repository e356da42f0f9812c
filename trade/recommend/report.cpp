#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/content.h"
#include "io/html_report.h"
#include "io/material_json.h"
#include "io/numbers.h"
#include "io/output.h"
#include "trade/measure/timing.h"
#include "trade/recommend/recommend.h"

namespace brdf::trade {
namespace {

io::Json candidate_json(const Candidate& c) {
  return {{"form", c.form()},
          {"choice", c.choice().empty() ? io::Json(nullptr) : io::Json(c.choice())},
          {"anisotropic", c.anisotropic},
          {"cost_ns", c.cost_ns},
          {"cost_measured", c.cost_measured},
          {"image_error", c.image_error},
          {"brdf_error", c.brdf_error},
          {"reason", c.reason}};
}

std::string number(double x) {
  return io::short_number(x, 3);
}

std::vector<std::string> sentences_of(const Recommendation& r) {
  std::vector<std::string> sentences = r.unneeded;
  sentences.insert(sentences.end(), r.warnings.begin(), r.warnings.end());
  if (!r.measured_now.empty()) sentences.push_back(r.measured_now);
  return sentences;
}

// Stops that bring all but the brightest hundredth of the lit pixels below white; never brighter than it is.
float exposure_of(const render::Picture& picture) {
  std::vector<double> brightest;
  for (const glm::vec4& p : picture.pixels)
    if (p.a > 0.5f && std::max({p.r, p.g, p.b}) > 0) brightest.push_back(double(std::max({p.r, p.g, p.b})));
  if (brightest.empty()) return 0;
  std::sort(brightest.begin(), brightest.end());
  return float(std::min(0.0, -std::log2(timing::quantile(brightest, 0.99))));
}

std::string verdict_of(const Recommendation& r) {
  if (r.chosen)
    return shown(r).label() + ": image error " + number(*shown(r).rendered_error) + ", " +
           number(shown(r).cost_ns) + " ns per evaluation";
  const Candidate& best = r.candidates[r.best];
  return "none meets the tolerance " + number(r.tolerance) + "; the best is " + best.label() +
         " with error " + number(r.metric == "image" ? best.image_error : best.brdf_error);
}

}  // namespace

io::Json to_json(const Recommendation& r) {
  io::Json candidates = io::Json::array();
  for (const Candidate& c : r.candidates) candidates.push_back(candidate_json(c));
  io::Json chosen = nullptr;
  if (r.chosen) {
    chosen = candidate_json(r.candidates[*r.chosen]);
    const Candidate& c = r.candidates[*r.chosen];
    chosen["material"] = io::to_json(material_for_file(c).value_or(c.material));
  }
  return {{"made", io::to_json(io::provenance())},
          {"tolerance", r.tolerance},
          {"metric", r.metric},
          {"chosen", std::move(chosen)},
          {"rendered_image_error", *shown(r).rendered_error},
          {"best", candidate_json(r.candidates[r.best])},
          {"candidates", std::move(candidates)},
          {"unneeded", r.unneeded},
          {"warnings", r.warnings},
          {"coverage",
           {{"pixels", r.coverage.pixels},
            {"most_theta_i", r.coverage.most_theta_i},
            {"most_theta_o", r.coverage.most_theta_o},
            {"most_theta_d", r.coverage.most_theta_d},
            {"least_theta_h", r.coverage.least_theta_h},
            {"most_theta_h", r.coverage.most_theta_h},
            {"azimuth_spread", r.coverage.azimuth_spread}}},
          {"costs_from", r.costs_from},
          {"measured_now", r.measured_now}};
}

std::string to_text(const Recommendation& r) {
  std::string text = verdict_of(r) + "\n";
  for (const std::string& sentence : sentences_of(r)) text += "  " + sentence + "\n";
  char line[256];
  std::snprintf(line, sizeof line, "\n  %-48s %8s %10s %10s\n", "candidate", "ns", "image", "brdf");
  text += line;
  for (std::size_t k = 0; k < r.candidates.size(); ++k) {
    const Candidate& c = r.candidates[k];
    std::snprintf(line, sizeof line, "%s %-48s %8.3g %10.3g %10.3g  %s\n", r.chosen == k ? "*" : " ",
                  c.label().c_str(), c.cost_ns, c.image_error, c.brdf_error, c.reason.c_str());
    text += line;
  }
  return text;
}

std::vector<std::string> recommendation_files() {
  return {"material.json", "model.png", "reference.png", "difference.png", "report.html"};
}

void write_recommendation(const std::filesystem::path& folder, const Recommendation& r) {
  io::make_folder(folder);
  const Candidate& candidate = shown(r);
  io::Json fit = {{"made", io::to_json(io::provenance())}, {"image_error", candidate.image_error}};
  if (!candidate.choice().empty()) fit["choice"] = candidate.choice();
  const std::optional<Material> material = material_for_file(candidate);
  if (material) io::write_material_file(folder / "material.json", {*material, fit});
  const float exposure = exposure_of(r.reference_picture);
  const auto tone = [exposure](const render::Picture& p) {
    return render::displayed(p, render::ToneMap::srgb, exposure);
  };
  render::write_png(folder / "model.png", tone(r.picture));
  render::write_png(folder / "reference.png", tone(r.reference_picture));
  render::write_png(folder / "difference.png", render::difference_picture(r.picture, r.reference_picture));
  io::HtmlReport report("What this scene requires");
  report.verdict(r.chosen ? io::Mark::good : io::Mark::bad, verdict_of(r));
  for (const std::string& sentence : sentences_of(r)) report.paragraph(sentence);
  if (!material) report.paragraph(candidate.label() + " is not in the catalogue: there is no material.json.");
  report.heading("Pictures");
  const std::string exposed = ", exposure " + number(double(exposure)) + " stops";
  report.picture(io::read_content(folder / "model.png").bytes, candidate.label() + exposed);
  report.picture(io::read_content(folder / "reference.png").bytes, "The reference" + exposed);
  report.picture(io::read_content(folder / "difference.png").bytes,
                 "Relative difference: blue 1e-6 to red 1");
  report.heading("Candidates, cheapest first");
  std::vector<std::vector<io::Cell>> rows;
  io::Plot plot{
      "Error against cost", "ns per evaluation (" + r.costs_from + ")", "image error", {}, true, true};
  for (std::size_t k = 0; k < r.candidates.size(); ++k) {
    const Candidate& c = r.candidates[k];
    rows.push_back({{c.label(), r.chosen == k ? io::Mark::good : io::Mark::none},
                    {number(c.cost_ns)},
                    {number(c.image_error)},
                    {number(c.brdf_error)},
                    {c.reason}});
    plot.series.push_back({c.label(), {c.cost_ns}, {c.image_error}, io::Series::Style::points});
  }
  report.plot(plot);
  report.table({"candidate", "ns", "image error", "brdf error", "why"}, rows);
  io::write_file_atomically(folder / "report.html", report.document(io::provenance()));
}

}  // namespace brdf::trade
