#include "fit/report/html.h"

#include "fit/report/budget.h"
#include "fit/report/first_screen.h"
#include "fit/report/page.h"
#include "io/page/html_report.h"

namespace brdf::fit {

std::string html_report(const FitResult& result, const io::SampleTable& table, const FitOptions& options,
                        bool sphere, std::optional<double> tolerance) {
  io::HtmlReport report("Fit of " + io::file_name(table.name()));
  const FormFit& best = result.ranking.front();
  add_first_screen(report, result, table, options, tolerance);
  if (best.solved()) {
    if (sphere) add_sphere(report, best, table);
    add_slices(report, best, table, aperture_of(table, options));
    add_deviation(report, best, table, aperture_of(table, options));
    add_spectra(report, best);
    add_parameters(report, best);
    add_budget(report, best, table);
  }
  add_ranking(report, result);
  add_samples(report, result, table, options);
  if (best.solved()) add_workings(report, result);
  report.footnote("samples", table.name());
  return report.document(io::provenance(options.seed));
}

}  // namespace brdf::fit
