#include "validate/report/report_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "brdf/integrals.h"
#include "io/files/numbers.h"
#include "io/files/png.h"
#include "io/files/text.h"
#include "validate/search/extremes.h"
#include "validate/search/pair_search.h"

namespace brdf::validate {
namespace {

// The material that a subject's plots show: the subject's own, or a form with its table defaults. If all
// weights are diffuse, the weights are full.
Material shown(const Subject& subject) {
  Material m = subject.own();
  if (!subject.of_form()) return m;
  const ReflectanceInfo& f = info(*subject.of_form());
  if (std::ranges::all_of(f.weights, [](const ParameterInfo& p) { return p.role == Role::diffuse; }))
    for (auto& weights : m.terms.front().weights) weights = lobe_alone(f);
  return m;
}

// Joins the command that writes a table of directions with the command that reads it; empty if the latter
// is empty.
std::string with_table(const std::string& table, const std::string& command) {
  return command.empty() ? "" : table + " && " + command;
}

io::Plot albedo_plot(const Subject& subject, const Material& m, double max_theta, double phi = 0) {
  io::Plot plot;
  plot.title = "Albedo against angle: " + io::file_name(subject.name());
  plot.x_label = "angle of incidence, degrees";
  plot.y_label = "directional albedo";
  std::vector<double> angles;
  for (double theta = 0; theta < max_theta; theta += theta < 85 ? 2.5 : 0.25) angles.push_back(theta);
  angles.push_back(max_theta);
  double widest = 0, highest = 1;
  const std::vector<int> palette = io::channel_palette(m.channels);
  for (std::size_t c = 0; c < m.channels.size(); ++c) {
    plot.series.push_back({m.channels[c], angles, {}, io::Series::Style::line});
    plot.series.back().colour = palette[c];
  }
  for (const double theta : angles) {
    AlbedoOptions options;
    options.tolerance = 1e-5;
    const auto results = directional_albedo(m, degrees(theta), degrees(phi), options);
    for (std::size_t c = 0; c < results.size(); ++c) {
      const AlbedoResult& r = results[c];
      io::Series& s = plot.series[c];
      s.y.push_back(r.value);
      s.low.push_back(r.value - r.error_bound);
      s.high.push_back(r.value + r.error_bound);
      widest = std::max(widest, r.error_bound);
      highest = std::max(highest, r.value);
    }
  }
  plot.range_y = {0, 1.05 * highest};
  plot.series.push_back({"1: energy limit", {0, max_theta}, {1, 1}, io::Series::Style::faint});
  plot.caption =
      "The fraction of light from this angle that is reflected into all directions. Above 1 the material "
      "violates energy conservation. The band is the error bound, at most " +
      io::short_number(widest, 2) + ".";
  plot.command = subject.command(
      "albedo", m,
      "--theta " + io::joined_numbers(angles, ",") + " --phi " + io::to_text(phi) + " --tolerance 1e-5");
  return plot;
}

constexpr std::array kLobeAngles{0.0, 30.0, 60.0};  // of incidence, degrees

// Calls visit(theta_o in degrees, f cos of the brightest channel) along the plane of incidence.
void for_each_of_lobe(const Material& m, double theta_i, const std::function<void(double, double)>& visit) {
  std::vector<double> f(m.channels.size());
  for (double theta = -89; theta <= 89; theta += 0.5) {
    const Vec3<double> wi = direction(degrees(theta_i), radians(kPi)), wo = direction(degrees(theta), {});
    eval(m, wi, wo, f);
    visit(theta, *std::ranges::max_element(f) * wo.z);
  }
}

io::Plot polar_plot(const Subject& subject, const Material& m, double reach) {
  io::Plot plot;
  plot.title = "Reflected lobes in the plane of incidence: " + io::file_name(subject.name());
  plot.x_label = "reflected radiance f_r cos theta_o along the surface, 1/sr";
  plot.y_label = "reflected radiance f_r cos theta_o along the normal, 1/sr";
  plot.equal_axes = true;
  plot.reach = reach;
  for (const double theta_i : kLobeAngles) {
    io::Series lobe{"incidence at " + io::to_text(theta_i) + " degrees", {}, {}, io::Series::Style::line};
    for_each_of_lobe(m, theta_i, [&](double theta, double r) {
      lobe.x.push_back(r * std::sin(degrees(theta).radians()));
      lobe.y.push_back(r * std::cos(degrees(theta).radians()));
    });
    plot.series.push_back(std::move(lobe));
  }
  plot.caption =
      "Reflected radiance f cos_o over the viewing direction, with light from the left; the brightest "
      "channel. All lobes of a page have one scale.";
  plot.command = with_table(
      "(echo theta_i,phi_i,theta_o,phi_o; for i in 0 30 60; do for o in $(seq -89 0.5 89); do echo "
      "$i,180,$o,0; done; done) > lobes.csv",
      subject.command("eval", m, "lobes.csv   # f; the plot shows f cos(theta_o)"));
  return plot;
}

// Plots the albedo at the parameters with which a form reflects most, if the energy check did not pass.
void add_worst_albedo(io::HtmlReport& report, const Subject& subject, const std::vector<Finding>& findings,
                      double max_theta) {
  if (!subject.of_form()) return;
  const auto found = std::ranges::find_if(findings, [&](const Finding& f) {
    return f.subject == subject.name() && f.check == "energy" && f.witness && f.outcome != Outcome::pass;
  });
  if (found == findings.end()) return;
  Material worst = subject.own();
  Term& term = worst.terms.front();
  const ReflectanceInfo& f = info(*subject.of_form());
  for (const auto& [name, value] : found->witness->parameters) {
    const int weight = f.weight_index(name), shape = f.shape_index(name);
    if (shape >= 0) term.shape.front()[std::size_t(shape)] = value;
    if (weight >= 0)
      for (auto& weights : term.weights) weights[std::size_t(weight)] = value;
  }
  io::Plot plot = albedo_plot(subject, worst, max_theta, found->witness->angles.back().second);
  plot.title = "Albedo against angle at the worst parameters: " + io::file_name(subject.name());
  plot.caption = "Parameters of the largest violation: " + found->statement + ".";
  report.plot(plot);
}

constexpr int kNoWidth = 6;

// The parameters that determine the width of the lobe (two for an anisotropic form), or the closest
// substitute.
std::vector<std::size_t> width_parameters(const ReflectanceInfo& form) {
  if (const auto [along, across] = form.axes(); across >= 0) return {std::size_t(along), std::size_t(across)};
  // Other forms use the parameter with the role that comes first below. A parameter that is a reflectance
  // does not describe the width.
  const auto rank = [](Role role) {
    switch (role) {
      case Role::width:
        return 0;
      case Role::exponent:
        return 1;
      case Role::slope:
        return 2;
      case Role::other:
        return 3;
      case Role::index:
        return 4;
      case Role::extinction:
        return 5;
      case Role::diffuse:
      case Role::specular:
      case Role::f0:
      case Role::tint:
      case Role::width_across:
      case Role::exponent_across:
        return kNoWidth;
    }
    return kNoWidth;
  };
  const auto by_rank = [&](const ParameterInfo& a, const ParameterInfo& b) {
    return rank(a.role) < rank(b.role);
  };
  const auto best = std::ranges::min_element(form.shape, by_rank);
  if (best == form.shape.end() || rank(best->role) == kNoWidth) return {};
  return {std::size_t(best - form.shape.begin())};
}

// White furnace: the reflected fraction of uniform light, plotted against the lobe's width.
void add_furnace(io::HtmlReport& report, const Subject& subject, const Material& m) {
  if (!subject.of_form()) return;
  const ReflectanceInfo& f = info(*subject.of_form());
  const std::vector<std::size_t> tied = width_parameters(f);
  if (tied.empty()) return;  // no parameter is known to be a lobe's width
  const ParameterInfo& width = f.shape[tied.front()];
  io::Plot plot;
  plot.title = "White furnace: " + io::file_name(subject.name());
  plot.log_x = width.log_scale && width.min > 0;
  plot.x_label = tied.size() == 1 ? std::string(width.name) : tied_name(f) + " (both widths)";
  plot.y_label = "albedo of the lobe at full weight";
  std::vector<double> values;
  for (int k = 0; k <= 40; ++k) values.push_back(parameter_value(width, k / 40.0, width.usual_max));
  Material full = m;
  Term& term = full.terms.front();
  std::ranges::fill(term.weights, lobe_alone(f));
  double highest = 1;
  for (const double theta : {0.0, 60.0, 80.0}) {
    io::Series s{"incidence at " + io::to_text(theta) + " degrees", values, {}, io::Series::Style::line};
    for (const double value : values) {
      for (const std::size_t k : tied) term.shape.front()[k] = value;
      AlbedoOptions options;
      options.tolerance = 1e-4;
      s.y.push_back(directional_albedo(full, degrees(theta), {}, options).front().value);
      highest = std::max(highest, s.y.back());
    }
    plot.series.push_back(std::move(s));
  }
  plot.range_y = {0, 1.05 * highest};
  plot.series.push_back({"1: no loss", {values.front(), values.back()}, {1, 1}, io::Series::Style::faint});
  plot.caption =
      "Under uniform illumination a lossless surface has albedo 1 and is invisible. The difference from 1 is "
      "lost by the model.";
  if (std::string command = subject.command("albedo", full, "--theta 0,60,80"); !command.empty()) {
    for (const std::size_t k : tied) {
      const std::string set = std::string(f.shape[k].name) + "=", last = io::to_text(values.back());
      command.replace(command.find(set + last) + set.size(), last.size(), "$x");
    }
    plot.command = "for x in " + io::joined_numbers(values, " ") + "; do " + command + "; done";
  }
  report.plot(plot);
}

// The relative difference of f under exchange of light and viewer, over pairs of polar angles, at the worst
// azimuth.
void add_reciprocity_map(io::HtmlReport& report, const Subject& subject, const Material& m) {
  constexpr std::size_t kCells = 60, kScale = 6;
  constexpr double kEqual = 1e-12;
  std::vector<double> cells(kCells * kCells);
  double worst = 0;
  std::vector<double> f(m.channels.size()), g(f.size());
  for (std::size_t i = 0; i < kCells; ++i)
    for (std::size_t o = 0; o < kCells; ++o)
      for (const double phi : {0.0, 40.0, 86.0, 138.0, 180.0}) {
        const Vec3<double> wi = direction(degrees((double(i) + 0.5) * 1.5), degrees(17));
        const Vec3<double> wo = direction(degrees((double(o) + 0.5) * 1.5), degrees(17 + phi));
        eval(m, wi, wo, f);
        eval(m, wo, wi, g);
        for (std::size_t c = 0; c < f.size(); ++c)
          cells[o * kCells + i] = std::max(cells[o * kCells + i], difference(f[c], g[c]));
        worst = std::max(worst, cells[o * kCells + i]);
      }
  if (worst < kEqual)
    return report.paragraph("Reciprocity: exact. When the two directions are exchanged, values differ by " +
                            io::short_number(worst, 2) +
                            (worst > 0 ? " (relative), which is rounding." : "."));
  std::vector<unsigned char> rgb(3 * kCells * kScale * kCells * kScale);
  for (std::size_t y = 0; y < kCells * kScale; ++y)
    for (std::size_t x = 0; x < kCells * kScale; ++x) {
      const double v = cells[(kCells - 1 - y / kScale) * kCells + x / kScale];
      // From 1e-16 (dark) to 1 (bright), logarithmic.
      io::map_colour(v > 0 ? 1 + std::log10(v) / 16 : 0, &rgb[3 * (y * kCells * kScale + x)]);
    }
  const std::vector<std::string> ticks{"0", "30", "60", "90"};
  report.map(
      {io::png_of_pixels(kCells * kScale, kCells * kScale, rgb), "angle of incidence, degrees",
       "viewing angle, degrees", ticks, ticks, "1e-16: rounding", "1: as large as f itself",
       "Reciprocity of " + io::file_name(subject.name()) +
           ": relative difference when the two directions are exchanged, for every pair of polar angles, at "
           "the worst of five azimuths. At most " +
           io::short_number(worst, 2) + " here.",
       with_table(
           "(echo theta_i,phi_i,theta_o,phi_o; for i in $(seq 0.75 1.5 89.25); do for o in $(seq 0.75 1.5 "
           "89.25); do for p in 17 57 103 155 197; do echo $i,17,$o,$p; echo $o,$p,$i,17; done; done; done) "
           "> pairs.csv",
           subject.command("eval", m, "pairs.csv   # every second row is the one before, exchanged"))});
}

}  // namespace

double lobe_reach(const std::vector<Subject>& subjects) {
  double reach = 0;
  for (const Subject& subject : subjects) {
    const Material m = shown(subject);
    for (const double theta_i : kLobeAngles)
      for_each_of_lobe(m, theta_i, [&](double, double r) {
        if (std::isfinite(r)) reach = std::max(reach, std::abs(r));
      });
  }
  return reach;
}

void add_subject_plots(io::HtmlReport& report, const Subject& subject, const std::vector<Finding>& findings,
                       double max_theta, double reach) {
  const Material m = shown(subject);
  report.plot(albedo_plot(subject, m, max_theta));
  add_worst_albedo(report, subject, findings, max_theta);
  report.plot(polar_plot(subject, m, reach));
  add_furnace(report, subject, m);
  add_reciprocity_map(report, subject, m);
}

}  // namespace brdf::validate
