#include "fit/html.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

#include "brdf/aperture.h"
#include "fit/report.h"
#include "io/html_report.h"

namespace brdf::fit {
namespace {

using io::Cell;
using io::Mark;

std::string digits(double x, int precision = 4) {
  std::ostringstream text;
  text << std::setprecision(precision) << x;
  return text.str();
}
std::string percent(double x) {
  return digits(100 * x, 3) + " %";
}

Mark mark_of(Verdict v) {
  return v == Verdict::kConverged ? Mark::good : v == Verdict::kAtBound ? Mark::warn : Mark::bad;
}

std::string in_words(const FormFit& f) {
  switch (f.verdict) {
    case Verdict::kConverged:
      return f.form + " describes the samples: the solver converged and every parameter is identified.";
    case Verdict::kAtBound:
      return f.form + " describes the samples with a parameter at the end of its range: see below.";
    case Verdict::kNotIdentifiable:
      return f.form + " cannot be determined from these samples: see below what is missing.";
    case Verdict::kMisfit:
      return f.form + " does not describe the samples.";
    case Verdict::kInterrupted:
      return "Interrupted: " + f.form + " with the best parameters so far.";
    default:
      return f.form + " could not be fitted.";
  }
}

// Fitted values [channel][row] of the rows of a table.
std::vector<std::vector<double>> fitted_values(const Material& material, const io::UnitDirections& d,
                                               std::size_t rows, double aperture) {
  std::vector out(material.channels.size(), std::vector<double>(rows));
  const std::vector<ApertureNode> detector = aperture_nodes(aperture * (kPi / 180), kFitRings);
  const std::vector<ApertureNode> source = aperture_nodes(0);
  std::vector<double> f(material.channels.size());
  for (std::size_t k = 0; k < rows; ++k) {
    const Vec3<double> wi{d.wi_x[k], d.wi_y[k], d.wi_z[k]}, wo{d.wo_x[k], d.wo_y[k], d.wo_z[k]};
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

void add_slices(io::HtmlReport& report, const io::SampleTable& table,
                const std::vector<std::vector<double>>& fitted) {
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
      io::Series points{digits(theta) + " degrees, measured", {}, {}, io::Series::Style::points};
      io::Series line{digits(theta) + " degrees, fitted", {}, {}, io::Series::Style::line};
      for (std::size_t k : rows) {
        points.x.push_back(in_plane_angle(table, k)), points.y.push_back(table.values[c][k]);
        line.x.push_back(in_plane_angle(table, k)), line.y.push_back(fitted[c][k]);
      }
      plot.series.push_back(std::move(points));
      plot.series.push_back(std::move(line));
    }
    report.plot(plot);
  }
}

// Mean ln(fit/value) over cells of two degrees: blue where the fit is too dark, red where too bright.
void add_residual_map(io::HtmlReport& report, const io::SampleTable& table, const io::UnitDirections& d,
                      const std::vector<std::vector<double>>& fitted) {
  constexpr std::size_t kCells = 45, kPixels = 10;
  std::vector<double> sum(kCells * kCells, 0), count(kCells * kCells, 0);
  double largest = 0;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const Geometry<double> g = geometry(Vec3<double>{d.wi_x[k], d.wi_y[k], d.wi_z[k]},
                                        Vec3<double>{d.wo_x[k], d.wo_y[k], d.wo_z[k]});
    const double theta_h = std::atan2(std::hypot(g.h.x, g.h.y), g.h.z) * 180 / kPi;
    const double theta_d = std::acos(std::min(g.cos_d, 1.0)) * 180 / kPi;
    const std::size_t x = std::min(std::size_t(theta_h / 2), kCells - 1);
    const std::size_t y = std::min(std::size_t(theta_d / 2), kCells - 1);
    for (std::size_t c = 0; c < fitted.size(); ++c)
      if (table.values[c][k] > 0 && fitted[c][k] > 0) {
        sum[y * kCells + x] += std::log(fitted[c][k] / table.values[c][k]);
        count[y * kCells + x] += 1;
      }
  }
  std::vector<double> sizes;
  for (std::size_t k = 0; k < sum.size(); ++k)
    if (count[k] > 0) sizes.push_back(std::abs(sum[k] / count[k]));
  if (sizes.empty()) return;
  std::sort(sizes.begin(), sizes.end());
  largest = std::max(sizes[sizes.size() * 95 / 100], 1e-12);
  const std::size_t width = kCells * kPixels;
  std::vector<unsigned char> rgb(width * width * 3, 235);
  for (std::size_t py = 0; py < width; ++py)
    for (std::size_t px = 0; px < width; ++px) {
      const std::size_t cell = (kCells - 1 - py / kPixels) * kCells + px / kPixels;
      if (count[cell] == 0) continue;
      const double v = std::clamp(sum[cell] / count[cell] / largest, -1.0, 1.0);
      unsigned char* out = &rgb[(py * width + px) * 3];
      const auto fade = [&](double full) {
        return static_cast<unsigned char>(255 - std::abs(v) * (255 - full));
      };
      out[0] = v < 0 ? fade(31) : fade(178), out[1] = v < 0 ? fade(95) : fade(24);
      out[2] = v < 0 ? fade(168) : fade(43);
    }
  report.heading("Where the fit deviates");
  report.picture(
      io::png_of_pixels(width, width, rgb),
      "Mean of ln(fit/measured). Across: theta_h, 0 to 90 degrees; up: theta_d, 0 to 90 degrees. Red: "
      "the fit is too bright, blue: too dark; full colour at " +
          percent(std::expm1(largest)) + ", grey where nothing was measured.");
}

void add_parameters(io::HtmlReport& report, const FormFit& f) {
  report.heading("Parameters");
  std::vector<std::vector<Cell>> rows;
  for (const Estimate& e : f.estimates) {
    const std::string name = e.channel.empty() ? e.name : e.name + " [" + e.channel + "]";
    if (e.status == Estimate::Status::kFree)
      rows.push_back({{name, Mark::none, true},
                      {digits(e.value)},
                      {digits(e.low) + " to " + digits(e.high)},
                      {digits(e.standard_error, 2)},
                      {"free", Mark::good}});
    else
      rows.push_back({{name, Mark::none, true},
                      {e.status == Estimate::Status::kUnidentified ? "-" : digits(e.value)},
                      {"-"},
                      {"-"},
                      {std::string(to_text(e.status)),
                       e.status == Estimate::Status::kUnidentified ? Mark::bad : Mark::warn}});
  }
  report.table({"parameter", "value", "95 % interval", "standard error", "status"}, rows);
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
      row.push_back(
          {digits(std::round(100 * r) / 100, 3), i != j && std::abs(r) > 0.95 ? Mark::warn : Mark::none});
    }
    rows.push_back(std::move(row));
  }
  report.table(header, rows);
  if (c.names.size() > kMost)
    report.paragraph("The first " + std::to_string(kMost) + " of " + std::to_string(c.names.size()) +
                     " parameters; the JSON has all.");
}

std::string shape_text(const Material& m) {
  std::string text;
  for (const Term& term : m.terms) {
    const FormInfo& f = info(term.form);
    for (std::size_t k = 0; k < f.shape.size(); ++k)
      text += (text.empty() ? "" : ", ") + std::string(f.shape[k].name) + " " + digits(term.shape[0][k]);
  }
  return text.empty() ? "-" : text;
}

void add_minima(io::HtmlReport& report, const FormFit& f) {
  report.heading("Minima");
  report.paragraph(std::to_string(f.starts) + " starts reached these distinct minima.");
  std::vector<std::vector<Cell>> rows;
  for (const MinimumReport& m : f.minima)
    rows.push_back({{digits(m.cost, 6)}, {std::to_string(m.basin)}, {shape_text(m.material)}});
  report.table({"cost", "starts", "shape"}, rows);
}

void add_ranking(io::HtmlReport& report, const FitResult& result) {
  report.heading("Forms");
  std::vector<std::vector<Cell>> rows;
  for (const FormFit& f : result.ranking)
    rows.push_back({{f.form, Mark::none, true},
                    {std::string(to_text(f.verdict)), mark_of(f.verdict)},
                    {percent(f.median_relative_error)},
                    {f.cross_validated_error ? percent(*f.cross_validated_error) : "-"},
                    {digits(f.bic, 6)},
                    {std::to_string(f.parameters)},
                    {digits(f.metrics.log, 3)},
                    {digits(f.metrics.cosine_l2, 3)},
                    {digits(f.metrics.cube_root, 3)},
                    {digits(f.metrics.log_relative, 3)}});
  report.table({"form", "verdict", "median error", "left out", "BIC", "parameters", "log", "cosine L2",
                "cube root", "log-relative"},
               rows);
}

}  // namespace

std::string html_report(const FitResult& result, const io::SampleTable& table, const FitOptions& options) {
  io::HtmlReport report("Fit of " + table.source);
  const FormFit& best = result.ranking.front();
  report.verdict(mark_of(best.verdict), in_words(best));
  for (const std::string& finding : best.findings) report.paragraph(finding + ".");
  std::string about = std::to_string(result.rows) + " rows of " + std::to_string(table.rows()) +
                      " fitted, both polar angles at most " + digits(options.max_theta) +
                      " degrees; residual " + std::string(metric_name(options.metric)) +
                      "; median relative error " + percent(best.median_relative_error);
  if (result.noise_floor)
    about += "; the values scatter about their neighbours by " + percent(*result.noise_floor);
  report.paragraph(about + ".");
  if (const FormFit& simple = result.ranking[result.recommended]; &simple != &best)
    report.paragraph("Recommended: " + simple.form + ", which is simpler and as good within the noise.");
  add_ranking(report, result);
  add_parameters(report, best);
  const io::UnitDirections d = io::unit_directions(table);
  const auto fitted = fitted_values(best.material, d, table.rows(), options.aperture);
  add_slices(report, table, fitted);
  add_residual_map(report, table, d, fitted);
  add_correlations(report, best.correlations);
  add_minima(report, best);
  return report.document(io::provenance(options.seed));
}

}  // namespace brdf::fit
