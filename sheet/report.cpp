#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/files/evenly.h"
#include "io/files/shell.h"
#include "io/files/text.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

constexpr std::size_t kMostCurves = 8;  // that are distinguished by colour, dash and shape

}  // namespace

void add_to_report(io::HtmlReport& report, const io::SampleTable& t, const DataSheet& sheet) {
  if (t.rows() == 0) return;
  std::vector<std::vector<io::Cell>> rows;
  for (const auto& [name, value] : sheet.facts) rows.push_back({{name}, {value}});
  report.table({}, rows);
  io::Plot plane;
  plane.title = "In the plane of incidence: " + io::file_name(t.source);
  plane.x_label = "viewing angle theta_o, degrees, positive on the mirror side";
  plane.y_label = "BRDF value f_r of channel " + t.channels.front() + ", 1/sr";
  plane.log_y = true;
  plane.caption = "Measured values, one colour for each angle of incidence.";
  plane.command = "grep -v '^#' " + io::shell_file(t.source);
  if (is_of_cells(t))
    for (const double theta_i : {15.0, 30.0, 45.0, 60.0, 75.0}) {
      plane.series.push_back(cells_in_plane(t, theta_i));
      plane.series.back().label = "incidence at " + io::to_text(theta_i) + " degrees";
      plane.series.back().style = io::Series::Style::points;
    }
  std::vector<io::Series> lights;
  const View view(t);
  for (const Scan& scan : view.scans()) {
    io::Series s{"incidence at " + io::to_text(scan.theta_i) + " degrees", {}, {}, io::Series::Style::points};
    for (const InPlane& p : in_plane(view, scan)) {
      s.x.push_back(p.angle);
      s.y.push_back(t.values.front()[p.row]);
    }
    if (!s.x.empty()) lights.push_back(std::move(s));
  }
  if (plane.series.empty()) {
    plane.counted = "angles of incidence";
    plane.all = lights.size();
  }
  constexpr std::size_t kOffered = 16;  // the most entries of a legend
  lights = io::evenly(std::move(lights), kOffered);
  std::vector<std::size_t> numbers(lights.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  for (io::Series& s : lights) s.hidden = true;
  for (const std::size_t k : io::evenly(std::move(numbers), kMostCurves)) lights[k].hidden = false;
  for (io::Series& s : lights) plane.series.push_back(std::move(s));
  if (!plane.series.empty()) report.plot(plane);
  io::Plot albedo;
  albedo.title = "Directional albedo, integrated from the measurements: " + io::file_name(t.source);
  albedo.x_label = "angle of incidence, degrees";
  albedo.y_label = "directional albedo";
  const std::vector<int> palette = io::channel_palette(t.channels);
  std::vector<std::size_t> channels(t.channels.size());
  std::iota(channels.begin(), channels.end(), 0);
  for (const std::size_t c : io::evenly(channels, kMostCurves)) {
    io::Series s{t.channels[c], {}, {}};
    s.colour = palette[c];
    for (const MeasuredAlbedo& a : sheet.albedo) {
      if (a.coverage < kEnoughCoverage) continue;
      s.x.push_back(a.theta_i);
      s.y.push_back(a.value[c]);
      s.low.push_back(a.value[c] - a.bound[c]);
      s.high.push_back(a.value[c] + a.bound[c]);
    }
    albedo.series.push_back(std::move(s));
  }
  albedo.caption =
      "The band is the error bound. It includes directions without measurements nearby, the coarseness of "
      "the sampling, and half of the noise floor.";
  if (channels.size() > kMostCurves)
    albedo.caption +=
        " " + std::to_string(kMostCurves) + " of " + std::to_string(channels.size()) + " channels are shown.";
  albedo.command = "brdf validate " + io::shell_file(t.source) + " --json";
  if (albedo.series.empty() || albedo.series[0].x.size() < 2) return;
  double highest = 1;
  for (const io::Series& s : albedo.series)
    for (const double high : s.high) highest = std::max(highest, high);
  albedo.range_y = {0, 1.05 * highest};
  const std::vector<double>& angles = albedo.series[0].x;
  albedo.series.push_back(
      {"1: energy limit", {angles.front(), angles.back()}, {1, 1}, io::Series::Style::faint});
  report.plot(albedo);
}

}  // namespace brdf::sheet
