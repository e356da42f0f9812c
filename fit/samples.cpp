#include "fit/samples.h"

#include "io/files/text.h"
#include "io/samples/relative_scale.h"

namespace brdf::fit {

Samples arranged(io::SampleTable read, const FitOptions& options) {
  Samples samples{std::move(read), {}, {}};
  samples.sheet = sheet::data_sheet(samples.table, {.keep_fill = options.keep_fill});
  if (options.free_scale)
    sheet::set_apart(samples.sheet, {"quantity", "energy"},
                     "the scale of the values is fitted (--free-scale)");
  sheet::leave_out(samples.sheet.not_measured, samples.table);
  io::arrange(samples.table, options.arrangement);
  if (options.free_scale) io::make_relative(samples.table);
  if (const double aperture = aperture_of(samples.table, options); aperture > 0 && !options.aperture)
    samples.table.assume("the model is averaged over the detector's field of " + io::to_text(aperture) +
                         " degrees that the file states (--aperture 0 turns this off)");
  samples.budget = options.budget;
  if (samples.budget) return samples;
  if (std::optional<io::Budget> stated = io::stated_budget(samples.table)) {
    samples.table.warnings.push_back("the file names the uncertainty budget " + stated->file);
    samples.budget = std::make_shared<const io::Budget>(*std::move(stated));
  }
  return samples;
}

Prepared prepared(const Samples& samples, const FitOptions& asked) {
  FitOptions options = asked;
  if (samples.budget) options.budget = samples.budget;
  Prepared out = prepared(samples.table, options);
  out.noise.agreements = samples.sheet.scatter.agreements;
  out.noise.isotropy = samples.sheet.scatter.isotropy;
  out.interpolated = samples.sheet.has_failed("invented");
  return out;
}

}  // namespace brdf::fit
