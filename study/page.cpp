#include "study/page.h"

#include "io/html_report.h"
#include "validate/report.h"

namespace brdf::study {

std::string sample_page(const Findings& found, const SampleOptions& options) {
  io::HtmlReport report(found.name);
  report.verdict(found.judgement.mark, found.judgement.sentence);
  for (const std::string& warning : found.judgement.warnings) report.paragraph(warning);
  if (!found.spheres.fitted.empty()) {
    report.picture(found.spheres.measured, "measured");
    report.picture(found.spheres.fitted, "fitted");
  }
  return report.document(io::provenance(options.fit.seed));
}

}  // namespace brdf::study
