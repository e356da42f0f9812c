#include <algorithm>
#include <cmath>
#include <map>

#include "fit/assess/derived.h"
#include "fit/between/difference_report.h"
#include "fit/between/shared_report.h"
#include "io/files/evenly.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"
#include "io/page/html_report.h"
#include "io/samples/in_plane.h"

namespace brdf::fit {
namespace {

constexpr double kPercent = 100;
constexpr std::size_t kShownLights = 3, kPlotChannels = 3;

// Returns the viewing angle, positive on the mirror side.
double view_of_direction(const AskedDirections& at) {
  return at.phi == 180 ? at.theta_o : -at.theta_o;
}

// Returns the plot of the relative difference of the fitted values, one curve for each light.
io::Plot difference_plot(const Difference& d, const std::string& channel) {
  io::Plot plot;
  plot.title = "Channel " + channel + ": fitted values of the second table relative to the first";
  plot.x_label = "viewing angle theta_o, degrees, positive on the mirror side";
  plot.y_label = "difference, %";
  std::map<double, io::Series> lights;
  for (const DirectionDifference& x : d.directions) {
    if (x.channel != channel) continue;
    io::Series& line = lights[x.at.theta_i];
    const double reach = d.band * x.uncertainty;
    line.x.push_back(view_of_direction(x.at));
    line.y.push_back(kPercent * std::expm1(-x.difference));
    line.low.push_back(kPercent * std::expm1(-x.difference - reach));
    line.high.push_back(kPercent * std::expm1(-x.difference + reach));
  }
  if (lights.empty()) return plot;
  double least = 0, most = 0;
  for (auto& [theta, line] : lights) {
    line.label = "incidence at " + io::short_number(theta) + " degrees";
    line.colour = int(plot.series.size());
    line.hidden = plot.series.size() >= kShownLights;
    least = std::min(least, line.x.front());
    most = std::max(most, line.x.back());
    plot.series.push_back(std::move(line));
  }
  plot.series.push_back({"", {least, most}, {0, 0}, io::Series::Style::dashed});
  plot.caption =
      d.fits.have_budgets()
          ? "Bands: uncertainty of the difference by the budgets and the scatter. For equal surfaces all "
            "bands together contain 0 in at least 95 % of cases."
          : "Bands: scatter alone, because there is no budget; a common scale or angle error of "
            "either instrument is not in them.";
  return plot;
}

// The measured values of one table in the plane of incidence at one light.
io::Series measured_series(const io::SampleTable& table, std::size_t channel, double theta_i) {
  io::Series points{"", {}, {}, io::Series::Style::points};
  points.role = "measured";
  for (std::size_t k = 0; k < table.rows(); ++k)
    if (const double angle = io::in_plane_angle(table, k);
        std::isfinite(angle) && table.theta_i[k] == theta_i) {
      points.x.push_back(angle);
      points.y.push_back(table.values[channel][k]);
    }
  return points;
}

io::Series fitted_series(const FittedTable& table, std::size_t channel, double theta_i, double reach) {
  io::Series line{"", {}, {}, io::Series::Style::line};
  line.role = "fitted";
  for (double view = -reach; view <= reach; view += 1) {
    const AskedDirections at{theta_i, std::abs(view), view < 0 ? 0.0 : 180.0};
    line.x.push_back(view);
    line.y.push_back(values_at(table.fit.material, std::span(&at, 1))[channel]);
  }
  return line;
}

// Returns the plot of the measured values of both tables with both fits at one light.
io::Plot slice_plot(const Comparison& c, const std::vector<TableToFit>& tables, std::size_t channel,
                    double theta_i) {
  io::Plot plot;
  plot.title = "Channel " + c.difference.fits.channels[channel] + ", incidence at " +
               io::short_number(theta_i) + " degrees: measured (points) and fitted (lines)";
  plot.x_label = "viewing angle theta_o, degrees, positive on the mirror side";
  plot.y_label = "BRDF value f_r, 1/sr";
  plot.log_y = true;
  for (std::size_t t = 0; t < tables.size(); ++t) {
    io::Series points = measured_series(tables[t].samples.table, channel, theta_i);
    points.colour = int(t);
    double reach = 0;
    for (const double x : points.x)
      reach = std::max(reach, std::min(std::abs(x), tables[t].options.max_theta));
    io::Series line = fitted_series(c.difference.fits.tables[t], channel, theta_i, reach);
    line.label = io::file_name(c.difference.fits.tables[t].name);
    line.colour = int(t);
    plot.series.push_back(std::move(points));
    plot.series.push_back(std::move(line));
  }
  return plot;
}

// Returns the angles of incidence that both tables have in the plane of incidence.
std::vector<double> common_lights(const std::vector<TableToFit>& tables) {
  std::map<double, std::size_t> count;
  for (const TableToFit& t : tables) {
    std::map<double, bool> own;
    for (std::size_t k = 0; k < t.samples.table.rows(); ++k)
      if (std::isfinite(io::in_plane_angle(t.samples.table, k))) own[t.samples.table.theta_i[k]] = true;
    for (const auto& [theta, seen] : own) ++count[theta];
  }
  std::vector<double> out;
  for (const auto& [theta, n] : count)
    if (n == tables.size()) out.push_back(theta);
  return io::evenly(std::move(out), kShownLights);
}

void add_parameters(io::HtmlReport& page, const Difference& d) {
  page.heading("Parameters");
  std::vector<io::Row> rows;
  for (const ParameterDifference& p : d.parameters) {
    const bool far = d.fits.have_budgets() && d.sameness == Sameness::different && p.beyond;
    rows.push_back({{.text = p.name, .code = true},
                    {.text = io::short_number(p.first)},
                    {.text = io::short_number(p.second)},
                    {.text = signed_amount_text(p.logarithmic ? std::expm1(-p.difference) : -p.difference,
                                                p.logarithmic),
                     .mark = far ? io::Mark::warn : io::Mark::none},
                    {.text = amount_text(p.uncertainty, p.logarithmic)}});
  }
  page.table({"parameter", "first table", "second table", "difference", "standard uncertainty"}, rows);
}

void add_explanations(io::HtmlReport& page, const Comparison& c) {
  if (c.explanations.empty()) return;
  page.heading("Errors of an instrument that would explain the difference");
  std::vector<io::Remark> remarks;
  for (const Explanation& e : c.explanations) {
    std::string text = in_words(e);
    text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
    remarks.push_back({e.explains ? io::Mark::warn : io::Mark::none, text + "."});
  }
  page.remarks(remarks);
}

io::Mark mark_of_answer(const Difference& d) {
  switch (d.sameness) {
    case Sameness::no_difference:
      return io::Mark::good;
    case Sameness::different:
      return io::Mark::bad;
    default:
      return io::Mark::unknown;
  }
}

}  // namespace

std::string html_page(const Comparison& c, const std::vector<TableToFit>& tables) {
  const Difference& d = c.difference;
  io::HtmlReport page("Comparison of " + io::file_name(d.fits.tables[0].name) + " and " +
                      io::file_name(d.fits.tables[1].name));
  page.facts({{"first table", io::file_name(d.fits.tables[0].name)},
              {"second table", io::file_name(d.fits.tables[1].name)},
              {"form", d.fits.form},
              {"budgets", d.fits.have_budgets() ? "of both tables" : ""}});
  std::string text = answer(d);
  text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
  page.verdict(mark_of_answer(d), text + ".");
  if (d.obstacle.empty()) {
    for (const std::string& text_of : {directions_in_words(d), values_in_words(d)})
      if (!text_of.empty())
        page.paragraph(char(std::toupper(static_cast<unsigned char>(text_of[0]))) + text_of.substr(1) + ".");
    add_explanations(page, c);
    page.heading("Difference in the plane of incidence");
    for (std::size_t k = 0; k < std::min(d.fits.channels.size(), kPlotChannels); ++k)
      if (const io::Plot plot = difference_plot(d, d.fits.channels[k]); !plot.series.empty()) page.plot(plot);
    add_parameters(page, d);
  }
  const std::vector<double> lights = common_lights(tables);
  if (!lights.empty()) page.heading("Measured values");
  for (const double theta : lights) page.plot(slice_plot(c, tables, 0, theta));
  add_fits(page, d.fits);
  for (const FittedTable& t : d.fits.tables) page.footnote("samples", t.name);
  return page.document(io::provenance());
}

}  // namespace brdf::fit
