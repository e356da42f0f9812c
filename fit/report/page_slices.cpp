// Plots of measured and fitted values: slices in the plane of incidence, and a map of the deviations over
// the half angles.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "brdf/aperture.h"
#include "fit/assess/derived.h"
#include "fit/report/page.h"
#include "fit/report/page_values.h"
#include "io/colour/channel_colours.h"
#include "io/files/evenly.h"
#include "io/files/numbers.h"
#include "io/files/png.h"
#include "io/samples/in_plane.h"
#include "measured/residual_map.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kShown = 4, kOffered = 12, kLeastRows = 4, kMostChannels = 3;
constexpr double kCurveStep = 0.5;  // degrees, of a curve

// The rows of one incidence in the plane of incidence, sorted by the angle of the detector.
struct Slice {
  double theta_i, phi_i;  // degrees
  std::vector<std::pair<double, std::size_t>> rows;
};

struct Slices {
  std::vector<Slice> offered;  // up to kOffered
  std::size_t all = 0;         // angles of incidence with enough rows in the plane
  std::vector<bool> shown;     // up to kShown of all; readers can switch the others on
};

// Returns slices from the steepest to the flattest angle of incidence. For each angle, uses the azimuth with
// most rows.
Slices slices_of(const io::SampleTable& table) {
  std::map<double, std::map<double, Slice>> by_light;
  for (std::size_t k = 0; k < table.rows(); ++k)
    if (const double angle = io::in_plane_angle(table, k); std::isfinite(angle)) {
      Slice& slice = by_light[table.theta_i[k]][table.phi_i[k]];
      slice.theta_i = table.theta_i[k];
      slice.phi_i = table.phi_i[k];
      slice.rows.emplace_back(angle, k);
    }
  std::vector<Slice> all;
  for (auto& [theta, azimuths] : by_light) {
    auto& [phi, most] = *std::ranges::max_element(
        azimuths, [](const auto& a, const auto& b) { return a.second.rows.size() < b.second.rows.size(); });
    if (most.rows.size() < kLeastRows) continue;
    std::ranges::sort(most.rows);
    all.push_back(std::move(most));
  }
  Slices slices;
  slices.all = all.size();
  slices.offered = io::evenly(std::move(all), kOffered);
  slices.shown.resize(slices.offered.size());
  std::vector<std::size_t> numbers(slices.offered.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  for (const std::size_t k : io::evenly(std::move(numbers), kShown)) slices.shown[k] = true;
  return slices;
}

// Returns every half degree between the outermost samples, and the angles of the samples.
std::vector<double> angles_of(const Slice& slice) {
  std::vector<double> angles;
  for (const auto& [angle, row] : slice.rows) angles.push_back(angle);
  const double last = angles.back();
  for (double angle = angles.front(); angle < last; angle += kCurveStep) angles.push_back(angle);
  std::ranges::sort(angles);
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
  return angles;
}

struct Curve {
  std::vector<double> angles;
  std::vector<std::vector<double>> values;  // [channel shown][angle]
  std::vector<std::vector<Extent>> bands;   // [channel shown][angle]; empty if unknown
};

constexpr double kOpenBand = 1e3;  // times a value

// Returns the material in these channels alone, after the first channel. Some forms mix channels by the
// weights of the first one.
Material in_channels(const Material& material, const std::vector<std::size_t>& channels) {
  Material out;
  std::vector<std::size_t> kept{0};
  kept.insert(kept.end(), channels.begin(), channels.end());
  for (const std::size_t c : kept) out.channels.push_back(material.channels[c]);
  for (const Term& term : material.terms) {
    Term& own = out.terms.emplace_back(Term{term.form, {}, {}, term.tangent_phi});
    for (const std::size_t c : kept) {
      own.weights.push_back(term.weights[c]);
      if (term.shape.size() > 1) own.shape.push_back(term.shape[c]);
    }
    if (term.shape.size() == 1) own.shape = term.shape;
  }
  return out;
}

// Returns the curve of these channels with its 95 % band.
Curve curve_of(const FormFit& fit, const Slice& slice, const std::vector<std::size_t>& channels,
               double aperture) {
  Curve curve{angles_of(slice), {}, {}};
  const std::size_t count = curve.angles.size();
  DirectionArrays<double> directions(count);
  const Vec3<double> wi = direction(degrees(slice.theta_i), degrees(slice.phi_i));
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = curve.angles[k], turn = angle < 0 ? 0 : 180;
    directions.set(k, wi, direction(degrees(std::abs(angle)), degrees(slice.phi_i + turn)));
  }
  const auto shown_values = [&](const Material& m) {
    auto values = fitted_values(in_channels(m, channels), directions.view(), aperture);
    values.erase(values.begin());
    return values;
  };
  curve.values = shown_values(fit.material);
  const Knowledge known = knowledge_of(fit);
  if (!known.any()) return curve;
  const auto in_one_row = [](const std::vector<std::vector<double>>& values) {
    std::vector<double> row;
    for (const auto& channel : values) row.insert(row.end(), channel.begin(), channel.end());
    return row;
  };
  const auto bands = intervals(fit.material, known, in_one_row(curve.values),
                               [&](const Material& m) { return in_one_row(shown_values(m)); });
  for (std::size_t c = 0; bands && c < curve.values.size(); ++c)
    curve.bands.emplace_back(bands->begin() + std::ptrdiff_t(c * count),
                             bands->begin() + std::ptrdiff_t((c + 1) * count));
  return curve;
}

// Returns red, green and blue if they can be identified, otherwise the first channels.
std::vector<std::size_t> shown_channels(const std::vector<std::string>& channels) {
  std::vector<std::size_t> shown;
  const auto colours = io::channel_colours(channels);
  for (std::size_t c = 0; c < std::min(channels.size(), kMostChannels); ++c)
    shown.push_back(colours && channels.size() >= kMostChannels ? colours->of[c] : c);
  return shown;
}

// Returns the plot of one channel, which is number `shown` of the curves.
io::Plot slice_plot(const io::SampleTable& table, const Slices& chosen, const std::vector<Curve>& curves,
                    std::size_t channel, std::size_t shown) {
  const std::vector<Slice>& slices = chosen.offered;
  io::Plot plot;
  plot.counted = "angles of incidence";
  plot.all = chosen.all;
  plot.title = "Channel " + table.channels[channel] + ": measured (points) and fitted (lines)";
  plot.x_label = "viewing angle theta_o, degrees, positive on the mirror side";
  plot.y_label = "BRDF value f_r, 1/sr";
  plot.log_y = true;
  for (std::size_t s = 0; s < slices.size(); ++s) {
    io::Series points{"", {}, {}, io::Series::Style::points};
    points.colour = int(s);
    points.role = "measured";
    points.hidden = !chosen.shown[s];
    for (const auto& [angle, row] : slices[s].rows) {
      points.x.push_back(angle);
      points.y.push_back(table.values[channel][row]);
    }
    io::Series line{"incidence at " + io::short_number(slices[s].theta_i) + " degrees", curves[s].angles,
                    curves[s].values[shown], io::Series::Style::line};
    line.colour = int(s);
    line.role = "fitted";
    line.hidden = !chosen.shown[s];
    if (!curves[s].bands.empty())
      for (const Extent& band : curves[s].bands[shown]) {
        // An open band extends beyond the plot.
        const double value = line.y[line.low.size()];
        line.low.push_back(std::max(band.low, value / kOpenBand));
        line.high.push_back(std::min(band.high, value * kOpenBand));
      }
    plot.series.push_back(std::move(points));
    plot.series.push_back(std::move(line));
  }
  return plot;
}

constexpr std::size_t kMapCells = measured::ResidualMap::kCells;

// Returns the pixels: blue if the fit is too dark, red if too bright, transparent if nothing was measured.
std::vector<unsigned char> pixels_of(const std::vector<double>& cells, double largest, std::size_t scale) {
  const std::size_t width = kMapCells * scale;
  std::vector<unsigned char> rgba(width * width * 4, 0);
  for (std::size_t py = 0; py < width; ++py)
    for (std::size_t px = 0; px < width; ++px) {
      const double v = cells[(kMapCells - 1 - py / scale) * kMapCells + px / scale];
      if (std::isnan(v)) continue;
      unsigned char* const pixel = &rgba[(py * width + px) * 4];
      io::map_colour(0.5 + 0.5 * v / largest, pixel, io::Colours::diverging);
      pixel[3] = 255;
    }
  return rgba;
}

}  // namespace

std::vector<std::vector<double>> fitted_values(const Material& material, const Directions<double>& d,
                                               double aperture) {
  std::vector out(material.channels.size(), std::vector<double>(d.count));
  const std::vector<ApertureNode> detector = aperture_nodes(degrees(aperture), kFitRings);
  const std::vector<ApertureNode> source = aperture_nodes({});
  std::vector<double> f(material.channels.size());
  for (std::size_t k = 0; k < d.count; ++k) {
    if (aperture > 0)
      eval_aperture(material, d.wi(k), d.wo(k), source, detector, f);
    else
      eval(material, d.wi(k), d.wo(k), f);
    for (std::size_t c = 0; c < f.size(); ++c) out[c][k] = f[c];
  }
  return out;
}

void add_slices(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table, double aperture) {
  const Slices slices = slices_of(table);
  if (slices.offered.empty()) return;
  report.heading("Measured and fitted in the plane of incidence");
  std::vector<Curve> curves;
  const std::vector<std::size_t> channels = shown_channels(table.channels);
  for (const Slice& slice : slices.offered) curves.push_back(curve_of(fit, slice, channels, aperture));
  for (std::size_t k = 0; k < channels.size(); ++k)
    report.plot(slice_plot(table, slices, curves, channels[k], k));
  std::string about;
  if (!curves[0].bands.empty())
    about = std::string("Bands: 95 % confidence bands of the fit, assuming that the form is correct") +
            (fit.budget ? ", with the budget. " : ", of the scatter only. ");
  if (table.channels.size() > channels.size())
    about += std::to_string(channels.size()) + " of " + std::to_string(table.channels.size()) +
             " channels are shown.";
  if (!about.empty()) report.paragraph(about);
}

void add_deviation(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table,
                   double aperture) {
  const measured::ResidualMap map(table);
  const std::vector<double> cells = map.cells(fitted_values(fit.material, map.directions(), aperture));
  std::vector<double> sizes;
  for (const double v : cells)
    if (!std::isnan(v)) sizes.push_back(std::abs(v));
  if (sizes.empty()) return;
  report.heading("Residuals of the fit");
  const double largest = io::quantile(std::move(sizes), 0.95);
  constexpr double kExact = 1e-9;
  if (largest < kExact) return report.paragraph("The fit reproduces every measurement to rounding.");
  constexpr std::size_t kPixels = 10, kWidth = kMapCells * kPixels;
  const std::vector<std::string> angles{"0", "30", "60", "90"};
  report.map(
      {.png = io::png_of_pixels(kWidth, kWidth, pixels_of(cells, largest, kPixels)),
       .x_label = "half angle theta_h, degrees, between the half vector and the normal",
       .y_label = "difference angle theta_d, degrees, between the incident direction and the half vector",
       .x_ticks = angles,
       .y_ticks = angles,
       .low = io::percent(-std::expm1(-largest)) + " too dark",
       .high = io::percent(std::expm1(largest)) + " too bright",
       .caption = "Fitted minus measured, mean over cells of two degrees. Hatched: no measurements.",
       .command = {},
       .colours = io::Colours::diverging});
}

}  // namespace brdf::fit
