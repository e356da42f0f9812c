#include "fit/report/page.h"
#include "io/files/numbers.h"
#include "io/page/sphere/page.h"
#include "measured/on_sphere.h"

namespace brdf::fit {

void add_sphere(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table) {
  if (!io::sphere::obstacle(fit.material).empty()) return;
  add_sphere(report, fit, io::file_name(table.name()), measured::seen_in_colour(table, &fit.material));
}

void add_sphere(io::HtmlReport& report, const FormFit& fit, const std::string& title,
                const std::shared_ptr<const measured::MeasuredReflectance>& seen, const std::string& still) {
  report.heading("Measured and fitted on a sphere");
  io::sphere::add(report, {.title = title,
                           .fitted = fit.material,
                           .measured = measured::on_sphere(seen),
                           .table = measured::table_size(*seen),
                           .caption = "Measured: " + measured::smoothed_words(seen->scatter()) +
                                      "; the measurements themselves deviate from the fit by " +
                                      io::percent(fit.median_relative_error) + " (median).",
                           .still = still});
}

}  // namespace brdf::fit
