#include "study/page.h"

#include <algorithm>

#include "fit/report/budget.h"
#include "fit/report/first_screen.h"
#include "fit/report/page.h"
#include "io/colour/channel_colours.h"
#include "io/files/address.h"
#include "io/files/numbers.h"
#include "io/files/shell.h"
#include "io/page/html_report.h"
#include "io/page/sphere/page.h"
#include "measured/on_sphere.h"
#include "study/lobes.h"
#include "validate/form/checks.h"
#include "validate/report/report.h"
#include "validate/report/report_plots.h"

namespace brdf::study {
namespace {

// Measured and fitted spheres side by side: interactive if a browser can draw the material, otherwise
// pictures.
void add_spheres(io::HtmlReport& report, const Findings& found) {
  const Spheres& spheres = found.spheres;
  const fit::FormFit& best = found.fit.ranking.front();
  if (!spheres.missing.empty()) return report.paragraph("No pictures: " + spheres.missing + ".");
  if (const auto colours = io::channel_colours(best.material.channels); colours && !colours->note.empty())
    report.paragraph(colours->note + ".");
  if (io::sphere::obstacle(best.material).empty())
    return fit::add_sphere(report, best, found.name, spheres.seen, spheres.studio.whole);
  report.pictures(
      {{.png = spheres.studio.whole, .title = "fitted", .text = best.form + ", in the studio"},
       {.png = spheres.whole.measured,
        .title = "measured",
        .text =
            measured::smoothed_words(spheres.seen->scatter()) +
            ", under one light; hatched: no measurements nearby. The measurements themselves deviate from "
            "the fit by " +
            io::percent(best.median_relative_error) + " (median)"},
       {.png = spheres.whole.fitted, .title = "fitted", .text = best.form + ", under the same light"},
       {.png = spheres.whole.difference,
        .title = "difference",
        .text = "fitted minus measured: blue -" + io::percent(spheres.whole.range) + ", white equal, red +" +
                io::percent(spheres.whole.range)}});
}

// A page stays small: with more dots the picture of a lobe does not turn.
constexpr std::size_t kMostDots = 4000;

void add_lobes(io::HtmlReport& report, const Spheres& spheres) {
  std::vector<io::Figure> pictures;
  for (const Lobe& lobe : spheres.lobes)
    pictures.push_back({.png = lobe.png,
                        .title = "incidence at " + io::short_number(lobe.theta_i) + " degrees",
                        .text = "dots: measurements at this incidence, faint behind the lobe",
                        .body = lobe.body.dots.size() > kMostDots ? std::nullopt : std::optional(lobe.body)});
  if (!has_lobes()) report.paragraph("No lobes: this build has no renderer, which draws them.");
  if (pictures.empty()) return;
  report.heading("Lobes: fitted (surface) and measured (dots)");
  report.pictures(pictures);
  const bool turns = std::ranges::any_of(pictures, [](const io::Figure& f) { return f.body.has_value(); });
  report.paragraph(
      "All lobes are drawn on one scale: the radius is the cube root of f_r, and the outer circle is " +
      io::short_number(spheres.lobes.front().outer, 3) + " 1/sr." +
      (turns ? " Drag a lobe, or use the arrow keys while it has the focus: it turns." : ""));
}

// The properties of the fitted material, and its albedo, lobes and reciprocity.
void add_properties(io::HtmlReport& report, const Findings& found) {
  report.heading("Properties of the fitted material");
  validate::add_properties(report, found.properties);
  report.begin_fold("Albedo, lobes and reciprocity");
  validate::add_subject_plots(report, *found.subject, found.properties, validate::CheckOptions{}.max_theta);
  report.end_fold();
}

void add_sheet(io::HtmlReport& report, const Findings& found, const SampleOptions& options) {
  fit::add_samples(report, found.fit, found.table, options.fit);
  report.subheading("Data check");
  validate::add_properties(report, found.sheet.findings);
  report.begin_fold("Rows, angles, values and albedo");
  sheet::add_to_report(report, found.table, found.sheet);
  report.end_fold();
}

// Describes a file of the page's folder for readers.
std::string meaning_of(const std::string& file) {
  const std::pair<const char*, const char*> meanings[] = {
      {kMaterial, "the fitted material, accepted by every verb that takes a material"},
      {kShader, "the fitted material as shader source (GLSL)"},
      {kFit, "the ranking of the forms, with all numbers"},
      {kProperties, "the checks of the material"},
      {kSheet, "the data check of the measurements"},
      {kResults, "the summary of this page, for programs"},
      {kStudio, "the fitted material in the studio"},
      {kSmallStudio, "the fitted material in the studio, small"},
      {kMeasured, "the measured sphere, under one light"},
      {kFitted, "the fitted sphere, under the same light"},
      {kDifference, "their difference"}};
  for (const auto& [name, meaning] : meanings)
    if (file == name) return meaning;
  return "";
}

void add_files(io::HtmlReport& report, const Findings& found, const SampleOptions& options) {
  report.heading("Files and commands");
  std::vector<io::Row> rows;
  for (const std::string& file : found.files)
    rows.push_back({{.text = file, .link = io::address_of(file)}, {.text = meaning_of(file)}});
  report.table({"file", "content"}, rows);
  if (!found.no_shader.empty()) report.paragraph("No shader: " + found.no_shader + ".");
  const std::string samples = io::shell_file(found.table.source), material = kMaterial;
  std::string commands = "brdf validate " + samples + "\n";
  if (!found.properties.empty())
    commands += "brdf fit " + samples + options.fit_words + " -o " + material + "\nbrdf validate " +
                material + "\nbrdf render " + material + " --measured " + samples +
                " -o spheres.png\nbrdf export " + material + " --to glsl -o " + kShader;
  report.command(commands);
}

}  // namespace

std::string sample_page(const Findings& found, const SampleOptions& options) {
  io::HtmlReport report(found.name);
  const fit::FormFit& best = found.fit.ranking.front();
  const std::string look = best.solved() ? "brdf view " + std::string(kMaterial) + " --measured " +
                                               io::shell_file(found.table.source)
                                         : std::string();
  fit::add_first_screen(report, found.fit, found.table, options.fit, options.tolerance, look);
  if (!options.alone) report.raw(std::string("<p><a href=\"../") + kPage + "\">All samples</a></p>\n");
  if (best.solved()) {
    add_spheres(report, found);
    fit::add_slices(report, best, found.table, fit::aperture_of(found.table, options.fit));
    add_lobes(report, found.spheres);
    fit::add_deviation(report, best, found.table, fit::aperture_of(found.table, options.fit));
    fit::add_spectra(report, best);
    fit::add_parameters(report, best);
    fit::add_budget(report, best, found.table);
    add_properties(report, found);
  }
  fit::add_ranking(report, found.fit);
  add_sheet(report, found, options);
  if (best.solved()) fit::add_workings(report, found.fit);
  add_files(report, found, options);
  report.footnote("samples", found.table.source);
  return report.document(io::provenance(options.fit.seed));
}

}  // namespace brdf::study
