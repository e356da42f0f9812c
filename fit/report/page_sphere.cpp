#include "fit/report/page.h"
#include "io/sphere/page.h"
#include "measured/on_sphere.h"

namespace brdf::fit {

void add_sphere(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table) {
  if (!io::sphere::obstacle(fit.material).empty()) return;
  report.heading("Measured beside fitted");
  const auto seen = std::make_shared<const measured::MeasuredReflectance>(table, &fit.material);
  io::sphere::add(report, {.title = io::file_name(table.name()),
                           .fitted = fit.material,
                           .measured = measured::on_sphere(seen),
                           .table = measured::table_size(*seen)});
}

}  // namespace brdf::fit
