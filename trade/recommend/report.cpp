#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/files/content.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/material/material_json.h"
#include "io/page/html_report.h"
#include "trade/ledger/number.h"
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

std::vector<std::string> sentences_of(const Recommendation& r) {
  std::vector<std::string> sentences = r.unneeded;
  sentences.insert(sentences.end(), r.warnings.begin(), r.warnings.end());
  if (!r.measured_now.empty()) sentences.push_back(r.measured_now);
  return sentences;
}

// Returns the exposure in stops at which all but the brightest hundredth of the lit pixels are below white.
// The exposure never brightens the picture.
float exposure_of(const render::Picture& picture) {
  const std::vector<double> brightest = render::surface_brightness(picture);
  if (brightest.empty()) return 0;
  return float(std::min(0.0, -std::log2(timing::quantile(brightest, 0.99))));
}

std::string verdict_of(const Recommendation& r) {
  if (r.chosen)
    return shown(r).label() + ": image error " + number(*shown(r).rendered_error) + ", " +
           number(shown(r).cost_ns) + " ns per evaluation";
  const Candidate& best = r.candidates[r.best];
  return "no candidate meets the tolerance " + number(r.tolerance) + "; the best candidate is " +
         best.label() + " with error " + number(r.metric == "image" ? best.image_error : best.brdf_error);
}

std::string conclusion(const Recommendation& r) {
  if (!r.chosen) {
    const std::string sentence = verdict_of(r);
    return char(std::toupper(static_cast<unsigned char>(sentence[0]))) + sentence.substr(1) + ".";
  }
  const Candidate& c = shown(r);
  return "Sufficient: " + c.label() + ". The mean error of its picture is " +
         io::percent(*c.rendered_error, 2) + ", at " + number(c.cost_ns) +
         " ns per evaluation. Tolerance: " + io::percent(r.tolerance, 2) +
         (r.metric == "image" ? " of the picture." : " of the BRDF.");
}

std::vector<io::Remark> remarks_on(const Recommendation& r) {
  std::vector<io::Remark> remarks;
  for (const std::string& warning : r.warnings) remarks.push_back({io::Mark::warn, warning + "."});
  return remarks;
}

// A sentence of `unneeded` has the form "observation: conclusion". The table shows the conclusion first.
void add_unneeded(io::HtmlReport& report, const Recommendation& r) {
  if (r.unneeded.empty()) return;
  report.heading("Features that this scene does not need");
  std::vector<io::Row> rows;
  for (const std::string& sentence : r.unneeded) {
    const std::size_t colon = sentence.rfind(": ");
    if (colon == sentence.npos)
      rows.push_back({{sentence}, {""}});
    else
      rows.push_back({{sentence.substr(colon + 2)}, {sentence.substr(0, colon)}});
  }
  report.table({"conclusion", "because"}, rows);
}

// Returns true if no other candidate is cheaper and at least as close.
bool on_front(const Recommendation& r, const Candidate& c) {
  return std::ranges::none_of(r.candidates, [&](const Candidate& other) {
    return other.cost_ns < c.cost_ns && other.image_error <= c.image_error;
  });
}

io::Plot cost_plot(const Recommendation& r) {
  constexpr double kSamePicture = 1e-5;  // far below a step of 8 bits
  io::Plot plot;
  plot.title = "Error against cost";
  plot.x_label = "ns per evaluation (" + r.costs_from + ")";
  plot.y_label = "image error";
  plot.log_x = plot.log_y = true;
  plot.bottom_edge = io::BottomEdge{"same", kSamePicture};
  plot.caption =
      "Cheaper candidates are on the left, more accurate candidates are below. Point at a candidate for its "
      "name, or see the table.";
  io::Series chosen{r.chosen ? "chosen" : "best", {}, {}, io::Series::Style::points};
  io::Series front{"no other is cheaper and more accurate", {}, {}, io::Series::Style::points};
  io::Series others{"others", {}, {}, io::Series::Style::faint_points};
  chosen.colour = 1;
  front.colour = 0;
  double least = HUGE_VAL, most = 0;
  for (const Candidate& c : r.candidates) {
    io::Series& series = &c == &shown(r) ? chosen : on_front(r, c) ? front : others;
    series.x.push_back(c.cost_ns);
    series.y.push_back(c.image_error);
    series.names.push_back(c.label());
    least = std::min(least, c.cost_ns);
    most = std::max(most, c.cost_ns);
  }
  for (io::Series* s : {&chosen, &front, &others})
    if (!s->x.empty()) plot.series.push_back(std::move(*s));
  io::Series limit{"tolerance", {least, most}, {r.tolerance, r.tolerance}, io::Series::Style::dashed};
  limit.colour = 5;
  if (r.metric == "image") plot.series.push_back(std::move(limit));
  return plot;
}

// An error above ten times the mean is no longer a useful measure: the values grow without limit in some
// direction, which the scene may never show.
io::Cell brdf_error_cell(const Candidate& c) {
  constexpr double kBeyondMeasure = 10;
  if (c.brdf_error < kBeyondMeasure) return {number(c.brdf_error)};
  return {.text = "above 10", .mark = io::Mark::warn, .note = "unbounded in some direction"};
}

void add_candidates(io::HtmlReport& report, const Recommendation& r) {
  report.heading("Candidates, cheapest first");
  if (!r.measured_now.empty()) report.paragraph(r.measured_now + ".");
  report.plot(cost_plot(r));
  std::vector<io::Row> rows;
  for (std::size_t k = 0; k < r.candidates.size(); ++k) {
    const Candidate& c = r.candidates[k];
    rows.push_back({{c.label(), r.chosen == k ? io::Mark::good : io::Mark::none},
                    {number(c.cost_ns)},
                    {number(c.image_error)},
                    brdf_error_cell(c),
                    {c.reason}});
  }
  report.table({"candidate", "ns", "image error", "brdf error", "why"}, rows, true);
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
    return render::displayed(p, render::ToneMap::srgb, exposure, render::Rounding::dithered);
  };
  render::write_png(folder / "model.png", tone(r.picture));
  render::write_png(folder / "reference.png", tone(r.reference_picture));
  render::write_png(folder / "difference.png", render::difference_picture(r.picture, r.reference_picture));
  io::HtmlReport report("Requirements of this scene");
  report.verdict(r.chosen ? io::Mark::good : io::Mark::bad, conclusion(r));
  report.remarks(remarks_on(r));
  if (!material)
    report.paragraph(candidate.label() + " is not in the catalogue, so material.json was not written.");
  const std::string exposed = "exposure " + number(double(exposure)) + " stops";
  const auto bytes = [&](const char* name) { return io::read_content(folder / name).bytes; };
  report.pictures({{bytes("model.png"), candidate.label(), exposed},
                   {bytes("reference.png"), "The reference", exposed},
                   {bytes("difference.png"), "Relative difference", "blue 1e-6 to red 1"}});
  add_candidates(report, r);
  add_unneeded(report, r);
  io::write_file_atomically(folder / "report.html", report.document(io::provenance()));
}

}  // namespace brdf::trade
