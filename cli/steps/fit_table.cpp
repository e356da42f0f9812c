#include "cli/steps/fit_table.h"

#include <unistd.h>

#include <filesystem>
#include <iostream>

#include "cli/options/next_step.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "fit/report/first_screen.h"
#include "fit/report/html.h"
#include "fit/report/report.h"
#include "io/files/output.h"
#include "io/material/material_json.h"

namespace brdf::cli {
namespace {

void print(const fit::FitResult& result, const io::SampleTable& table, const fit::FitOptions& options,
           std::optional<double> tolerance, TextStream stream) {
  PlainText out(stream);
  const int descriptor = descriptor_of(stream);
  fit::print(out, result, table, options, {columns_of(descriptor), colours_on(descriptor)});
  if (tolerance) out << fit::tolerance_sentence(result.ranking.front(), *tolerance) << '\n';
}

}  // namespace

Exit write_fit(const fit::FitResult& result, const io::SampleTable& table, const fit::FitOptions& options,
               const FitTargets& targets) {
  const fit::FormFit& best = result.ranking.front();
  const std::string& output = targets.material;
  const TextStream stream = text_stream({{"-o", output}, {"--report", targets.report}}, targets.json);
  bool is_written = false;
  if (result.interrupted && !output.empty() && std::filesystem::is_regular_file(output)) {
    Warning() << "brdf fit: interrupted: " << output << " is kept unchanged";
  } else if (!output.empty() && best.solved()) {
    io::write_material_file(output, {best.material, fit::material_block(best, result, table, options)});
    is_written = true;
    if (result.interrupted)
      Warning() << "brdf fit: interrupted: " << output << " holds the best parameters so far";
  } else if (!output.empty()) {
    Warning() << "brdf fit: no form could be fitted: " << output << " is not written";
  }
  if (!targets.report.empty())
    io::write_file_atomically(targets.report,
                              fit::html_report(result, table, options, true, targets.tolerance));
  if (targets.json) {
    io::Json json = fit::to_json(result, table, options);
    if (targets.tolerance) {
      json["tolerance"] = *targets.tolerance;
      json["within_tolerance"] = fit::is_within(best, *targets.tolerance);
    }
    std::cout << io::to_text(json);
  } else {
    print(result, table, options, targets.tolerance, stream);
    print_next_step({is_written ? view_command(output, targets.samples) : "", open_page(targets.report)},
                    stream);
  }
  const bool is_accepted = !targets.tolerance || fit::is_within(best, *targets.tolerance);
  return fit::usable(best.verdict) && is_accepted && !result.interrupted ? Exit::good : Exit::failed;
}

}  // namespace brdf::cli
