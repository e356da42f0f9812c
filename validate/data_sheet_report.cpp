#include <cmath>

#include "io/text.h"
#include "validate/sheet_checks.h"

namespace brdf::validate {

void add_to_report(io::HtmlReport& report, const io::SampleTable& t, const DataSheet& sheet) {
  if (t.rows() == 0) return;
  std::vector<std::vector<io::Cell>> rows;
  for (const auto& [name, value] : sheet.facts) rows.push_back({{name}, {value}});
  report.table({"table", t.source}, rows);
  io::Plot plane;
  plane.title = "In the plane of incidence: " + t.source;
  plane.x_label = "polar angle of the viewer, degrees (mirror side positive)";
  plane.y_label = "f_r of " + t.channels.front() + ", 1/sr";
  plane.log_y = true;
  plane.caption = "The values as they were measured, one colour for each angle of the light.";
  plane.command = "grep -v '^#' " + t.source;
  for (const auto& [light, members] : by_light(t)) {
    io::Series s{"light at " + io::to_text(light.first), {}, {}, io::Series::Style::points};
    for (const std::size_t k : members) {
      const double phi = std::abs(std::remainder(t.phi_o[k] - light.second, 360.0));
      if (t.theta_o[k] != 0 && phi != 0 && phi != 180) continue;
      s.x.push_back(phi == 0 ? -t.theta_o[k] : t.theta_o[k]);
      s.y.push_back(t.values.front()[k]);
    }
    if (!s.x.empty() && plane.series.size() < 8) plane.series.push_back(std::move(s));
  }
  if (!plane.series.empty()) report.plot(plane);
  io::Plot albedo;
  albedo.title = "Reflected fraction by integrating the samples: " + t.source;
  albedo.x_label = "polar angle of the light, degrees";
  albedo.y_label = "albedo of " + t.channels.front();
  albedo.series = {{"value", {}, {}, io::Series::Style::line},
                   {"value + bound", {}, {}, io::Series::Style::dashed},
                   {"value - bound", {}, {}, io::Series::Style::dashed}};
  for (const MeasuredAlbedo& a : sheet.albedo) {
    if (a.coverage < 0.6) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      albedo.series[k].x.push_back(a.theta_i);
      albedo.series[k].y.push_back(a.value[0] + (k == 1 ? a.bound[0] : k == 2 ? -a.bound[0] : 0));
    }
  }
  albedo.caption =
      "The bound holds what no sample is near to, the coarseness of the sampling, and half the noise floor.";
  albedo.command = "brdf validate " + t.source + " --json";
  if (albedo.series[0].x.size() > 1) report.plot(albedo);
}

}  // namespace brdf::validate
