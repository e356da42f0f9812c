#include "fit/report/html.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "brdf/aperture.h"
#include "brdf/geometry.h"
#include "fit/assess/derived.h"
#include "fit/assess/reported.h"
#include "fit/report/report.h"
#include "io/html_report.h"
#include "io/numbers.h"

namespace brdf::fit {
namespace {

using io::Cell;
using io::Mark;

Mark mark_of(Verdict v) {
  return v == Verdict::converged ? Mark::good : usable(v) ? Mark::warn : Mark::bad;
}

std::string in_words(const FormFit& f) {
  const std::string how =
      f.lack_of_fit.beyond_scatter
          ? " is off by " + io::percent(f.median_relative_error) + " in the middle, beyond the scatter"
          : std::string(" describes the samples");
  switch (f.verdict) {
    case Verdict::converged:
      return f.form + how + ": the solver converged and every parameter is identified.";
    case Verdict::at_bound:
      return f.form + how + ", with a parameter at the end of its range: see below.";
    case Verdict::determined:
      return f.form + how + ": what it gives is determined, not every parameter: see below.";
    case Verdict::not_identifiable:
      return f.form + " cannot be determined from these samples: see below what is missing.";
    case Verdict::misfit:
      return f.form + " does not describe the samples.";
    case Verdict::interrupted:
      return "Interrupted: " + f.form + " with the best parameters so far.";
    default:
      return f.form + " could not be fitted.";
  }
}

// Fitted values [channel][row] of the rows of a table.
std::vector<std::vector<double>> fitted_values(const Material& material, const Directions<double>& d,
                                               std::size_t rows, double aperture) {
  std::vector out(material.channels.size(), std::vector<double>(rows));
  const std::vector<ApertureNode> detector = aperture_nodes(degrees(aperture), kFitRings);
  const std::vector<ApertureNode> source = aperture_nodes({});
  std::vector<double> f(material.channels.size());
  for (std::size_t k = 0; k < rows; ++k) {
    const Vec3<double> wi = d.wi(k), wo = d.wo(k);
    if (aperture > 0)
      eval_aperture(material, wi, wo, source, detector, f);
    else
      eval(material, wi, wo, f);
    for (std::size_t c = 0; c < f.size(); ++c) out[c][k] = f[c];
  }
  return out;
}

// Signed detector angle of a row in the plane of incidence (mirror side positive); NaN outside the plane.
double in_plane_angle(const io::SampleTable& t, std::size_t k) {
  const double turn = std::remainder(t.phi_o[k] - t.phi_i[k], 360.0);
  if (t.theta_o[k] == 0 || std::abs(std::abs(turn) - 180) < 0.5) return t.theta_o[k];
  if (std::abs(turn) < 0.5) return -t.theta_o[k];
  return std::numeric_limits<double>::quiet_NaN();
}

// Fills the band about a line of fitted values: 95 %, from the parameters' covariance.
void add_band(const FormFit& fit, const Directions<double>& d, const std::vector<std::size_t>& rows,
              std::size_t channel, double aperture, io::Series& line) {
  if (!fit.covariance) return;
  DirectionArrays<double> few(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) few.set(k, d.wi(rows[k]), d.wo(rows[k]));
  const auto values = [&](const Material& material) {
    return fitted_values(material, few.view(), rows.size(), aperture)[channel];
  };
  const auto band = intervals(fit.material, *fit.covariance, line.y, values);
  for (std::size_t k = 0; band && k < rows.size(); ++k) {
    line.low.push_back((*band)[k].low);
    line.high.push_back((*band)[k].high);
  }
}

void add_slices(io::HtmlReport& report, const io::SampleTable& table, const FormFit& fit,
                const Directions<double>& d, const std::vector<std::vector<double>>& fitted,
                double aperture) {
  constexpr std::size_t kSlices = 4;
  std::map<double, std::vector<std::size_t>> by_theta;
  for (std::size_t k = 0; k < table.rows(); ++k)
    if (std::isfinite(in_plane_angle(table, k))) by_theta[table.theta_i[k]].push_back(k);
  std::vector<double> angles;
  for (const auto& [theta, rows] : by_theta)
    if (rows.size() >= 4) angles.push_back(theta);
  if (angles.empty()) return;
  report.heading("In the plane of incidence");
  for (std::size_t c = 0; c < table.channels.size() && c < 3; ++c) {
    io::Plot plot;
    plot.title = "channel " + table.channels[c] + ": measured (points) and fitted (lines)";
    plot.x_label = "theta_o, degrees (mirror side positive)";
    plot.y_label = "f_r, 1/sr";
    plot.log_y = true;
    const std::size_t count = std::min(kSlices, angles.size());
    for (std::size_t s = 0; s < count; ++s) {
      const double theta = angles[count == 1 ? 0 : s * (angles.size() - 1) / (count - 1)];
      std::vector<std::size_t> rows = by_theta[theta];
      std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
        return in_plane_angle(table, a) < in_plane_angle(table, b);
      });
      io::Series points{"", {}, {}, io::Series::Style::points};
      points.colour = int(s);
      io::Series line{io::short_number(theta) + " degrees", {}, {}, io::Series::Style::line};
      line.colour = int(s);
      for (std::size_t k : rows) {
        points.x.push_back(in_plane_angle(table, k));
        points.y.push_back(table.values[c][k]);
        line.x.push_back(in_plane_angle(table, k));
        line.y.push_back(fitted[c][k]);
      }
      add_band(fit, d, rows, c, aperture, line);
      plot.series.push_back(std::move(points));
      plot.series.push_back(std::move(line));
    }
    if (fit.covariance)
      plot.caption = "Bands: 95 % intervals of the fitted values, from the parameters' covariance.";
    report.plot(plot);
  }
}

constexpr std::size_t kMapCells = 45;  // of two degrees

// Mean ln(fit/value) of every cell over (theta_h, theta_d),
// row by row from theta_d 0; NaN where nothing was measured.
std::vector<double> residual_cells(const io::SampleTable& table, const Directions<double>& d,
                                   const std::vector<std::vector<double>>& fitted) {
  std::vector<double> sum(kMapCells * kMapCells, 0), count(kMapCells * kMapCells, 0);
  const auto cell = [](double angle) {
    return std::min(std::size_t(radians(angle).degrees() / 2), kMapCells - 1);
  };
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const Geometry<double> g = geometry(d.wi(k), d.wo(k));
    const std::size_t x = cell(std::atan2(std::hypot(g.h.x, g.h.y), g.h.z));
    const std::size_t y = cell(std::acos(std::min(g.cos_d, 1.0)));
    for (std::size_t c = 0; c < fitted.size(); ++c)
      if (table.values[c][k] > 0 && fitted[c][k] > 0) {
        sum[y * kMapCells + x] += std::log(fitted[c][k] / table.values[c][k]);
        count[y * kMapCells + x] += 1;
      }
  }
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] /= count[k];  // 0/0: NaN
  return sum;
}

// Blue where the fit is too dark, red where too bright.
void add_residual_map(io::HtmlReport& report, const std::vector<double>& cells) {
  constexpr std::size_t kPixels = 10, kWidth = kMapCells * kPixels;
  std::vector<double> sizes;
  for (const double v : cells)
    if (!std::isnan(v)) sizes.push_back(std::abs(v));
  if (sizes.empty()) return;
  const double largest = std::max(io::quantile(std::move(sizes), 0.95), 1e-12);
  std::vector<unsigned char> rgb(kWidth * kWidth * 3, 225);
  for (std::size_t py = 0; py < kWidth; ++py)
    for (std::size_t px = 0; px < kWidth; ++px) {
      const double v = cells[(kMapCells - 1 - py / kPixels) * kMapCells + px / kPixels];
      if (!std::isnan(v))
        io::map_colour(0.5 + 0.5 * v / largest, &rgb[(py * kWidth + px) * 3], io::Colours::diverging);
    }
  report.heading("Where the fit deviates");
  const std::vector<std::string> angles{"0", "30", "60", "90"};
  report.map({.png = io::png_of_pixels(kWidth, kWidth, rgb),
              .x_label = "theta_h, degrees: the half vector from the normal",
              .y_label = "theta_d, degrees: the light from the half vector",
              .x_ticks = angles,
              .y_ticks = angles,
              .low = io::percent(-std::expm1(-largest)) + " too dark",
              .high = io::percent(std::expm1(largest)) + " too bright",
              .caption = "Fitted less measured, mean over cells of two degrees; grey: nothing measured.",
              .command = {},
              .colours = io::Colours::diverging});
}

std::string extent_text(const Extent& e) {
  return std::isfinite(e.low) ? io::short_number(e.low) + " to " + io::short_number(e.high) : "-";
}

void add_parameters(io::HtmlReport& report, const FormFit& f) {
  report.heading("Parameters");
  std::vector<std::vector<Cell>> rows;
  for (const Estimate& e : f.estimates) {
    const std::string name = e.channel.empty() ? e.name : e.name + " [" + e.channel + "]";
    if (e.status == Status::free)
      rows.push_back({{name, Mark::none, true},
                      {io::short_number(e.value)},
                      {extent_text({e.low, e.high})},
                      {extent_text(e.with_lack_of_fit)},
                      {extent_text(e.left_out)},
                      {extent_text(e.other_metrics)},
                      {io::short_number(e.standard_error, 2)},
                      {"free", Mark::good}});
    else
      rows.push_back(
          {{name, Mark::none, true},
           {e.status == Status::unidentified ? "-" : io::short_number(e.value)},
           {"-"},
           {"-"},
           {"-"},
           {"-"},
           {"-"},
           {std::string(name_of(e.status)), e.status == Status::unidentified ? Mark::bad : Mark::warn}});
  }
  report.table({"parameter", "value", "95 % (statistical)", "95 % with lack of fit", "folds left out",
                "other metrics", "standard error", "status"},
               rows);
}

void add_correlations(io::HtmlReport& report, const Correlations& c) {
  constexpr std::size_t kMost = 16;
  const std::size_t n = std::min(c.names.size(), kMost);
  if (n < 2) return;
  report.heading("Correlations");
  std::vector<std::string> header{""};
  std::vector<std::vector<Cell>> rows;
  for (std::size_t i = 0; i < n; ++i) {
    header.push_back(c.names[i]);
    std::vector<Cell> row{{c.names[i], Mark::none, true}};
    for (std::size_t j = 0; j < n; ++j) {
      const double r = c.matrix(i, j);
      row.push_back({io::short_number(std::round(100 * r) / 100, 3),
                     i != j && std::abs(r) > 0.95 ? Mark::warn : Mark::none});
    }
    rows.push_back(std::move(row));
  }
  report.table(header, rows);
  if (c.names.size() > kMost)
    report.paragraph("The first " + std::to_string(kMost) + " of " + std::to_string(c.names.size()) +
                     " parameters; the JSON has all.");
}

void add_minima(io::HtmlReport& report, const FormFit& f) {
  report.heading("Minima");
  report.paragraph(std::to_string(f.starts) + " starts reached these distinct minima.");
  std::vector<std::vector<Cell>> rows;
  for (const MinimumReport& m : f.minima)
    rows.push_back({{io::short_number(m.cost, 6)}, {std::to_string(m.basin)}, {shape_text(m.material)}});
  report.table({"cost", "starts", "shape"}, rows);
}

void add_ranking(io::HtmlReport& report, const FitResult& result) {
  report.heading("Forms");
  std::vector<std::vector<Cell>> rows;
  for (const FormFit& f : result.ranking) {
    const RelativeErrors& errors = f.left_out ? f.left_out->errors : f.errors;
    const auto& over = f.lack_of_fit.residual_over_scatter;
    rows.push_back({{f.form, Mark::none, true},
                    {std::string(name_of(f.verdict)), mark_of(f.verdict)},
                    {f.left_out ? io::short_number(f.left_out->value, 3) : "-"},
                    {f.solved() ? io::percent(errors.median) : "-"},
                    {f.solved() ? io::percent(errors.ninth_decile) : "-"},
                    {f.solved() ? io::percent(errors.off_by_two) : "-"},
                    {over ? io::short_number(*over, 2) : "-"},
                    {f.lack_of_fit.worst ? to_text(f.lack_of_fit.worst->range) : "-"},
                    {f.lack_of_fit.worst ? io::short_number(f.lack_of_fit.worst->ratio, 3) : "-"},
                    {io::short_number(f.bic, 6)},
                    {std::to_string(f.parameters)},
                    {io::short_number(f.metrics.log, 3)},
                    {io::short_number(f.metrics.cosine_l2, 3)},
                    {io::short_number(f.metrics.cube_root, 3)},
                    {io::short_number(f.metrics.log_relative, 3)}});
  }
  report.table({"form", "verdict", "left out", "median", "90 %", "off by 2", "x scatter", "worst at",
                "ratio there", "BIC", "parameters", "log", "cosine L2", "cube root", "log-relative"},
               rows);
}

}  // namespace

std::string html_report(const FitResult& result, const io::SampleTable& table, const FitOptions& options) {
  io::HtmlReport report("Fit of " + table.source);
  const FormFit& best = result.ranking.front();
  report.verdict(mark_of(best.verdict), in_words(best));
  for (const std::string& finding : best.findings) report.paragraph(finding + ".");
  if (best.solved()) report.paragraph("Lack of fit: " + in_words(best.lack_of_fit) + ".");
  std::string about = std::to_string(result.rows) + " rows of " + std::to_string(table.rows()) +
                      " fitted, both polar angles at most " + io::short_number(options.max_theta) +
                      " degrees; residual " + std::string(name_of(result.metric.metric));
  if (!result.metric.asked) about += ", chosen: " + result.metric.reason;
  if (best.solved()) about += "; median relative error " + io::percent(best.median_relative_error);
  about += "; " + scatter_text(result);
  if (options.free_scale)
    about += "; values divided by the scale " + io::short_number(table.scale, 6) +
             ", which is unknown: weights are relative";
  report.paragraph(about + ".");
  if (!result.input_fault.empty()) report.verdict(Mark::warn, "The samples: " + result.input_fault + ".");
  if (std::string text = recommendation(result); !text.empty()) {
    text[0] = 'R';
    report.paragraph(text + ".");
  }
  for (const Step& step : result.steps) report.paragraph(in_words(step) + ".");
  add_ranking(report, result);
  if (!best.solved()) return report.document(io::provenance(options.seed));
  add_parameters(report, best);
  const DirectionArrays<double> arrays = io::unit_directions(table);
  const Directions<double> d = arrays.view();
  const auto fitted = fitted_values(best.material, d, table.rows(), options.aperture);
  add_slices(report, table, best, d, fitted, options.aperture);
  add_residual_map(report, residual_cells(table, d, fitted));
  add_correlations(report, best.correlations);
  add_minima(report, best);
  return report.document(io::provenance(options.seed));
}

}  // namespace brdf::fit
