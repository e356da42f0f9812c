// Plots and maps of a report.
#include <array>
#include <cmath>

#include "io/colour/channel_colours.h"
#include "io/files/json.h"
#include "io/page/colour_scales.h"
#include "io/page/html_markup.h"
#include "io/page/html_report.h"

namespace brdf::io {
namespace {

const char* style_name(Series::Style style) {
  constexpr std::array names{"line", "dashed", "points", "faint", "faint_points"};
  return names[std::size_t(style)];
}

// Rounds to seven significant digits, more than a screen shows: all digits would double the weight of a page.
double rounded(double v) {
  if (v == 0 || !std::isfinite(v)) return v;
  const double unit = std::pow(10.0, 6 - std::floor(std::log10(std::abs(v))));
  const double out = std::round(v * unit) / unit;
  return std::isfinite(out) ? out : v;
}

Json values(const std::vector<double>& data, bool log) {
  Json array = Json::array();
  for (const double v : data) {
    if (std::isfinite(v) && (!log || v > 0))
      array.push_back(rounded(v));
    else
      array.push_back(nullptr);
  }
  return array;
}

// The bottom edge of the axis: the lowest decade of the other values (`least`), and the value `at` which
// replaces the values on the edge.
struct Edge {
  double least = HUGE_VAL, at = 0;
};

Edge edge_of(const Plot& plot) {
  Edge edge;
  for (const Series& s : plot.series)
    for (const double y : s.y)
      if (y > plot.bottom_edge->below) edge.least = std::fmin(edge.least, y);
  if (!std::isfinite(edge.least)) edge.least = 1;
  edge.least = std::pow(10, std::floor(std::log10(edge.least)));
  edge.at = edge.least / 10;
  return edge;
}

Json to_json(const Plot& plot) {
  Json json{{"title", plot.title}, {"x_label", plot.x_label}, {"y_label", plot.y_label},
            {"log_x", plot.log_x}, {"log_y", plot.log_y},     {"series", Json::array()}};
  const bool edged = plot.log_y && plot.bottom_edge;
  const Edge edge = edged ? edge_of(plot) : Edge{};
  if (edged)
    json["bottom_edge"] = {{"label", plot.bottom_edge->label}, {"at", edge.at}, {"least", edge.least}};
  double x_max = 0, y_max = 0;
  for (const Series& s : plot.series) {
    std::vector<double> y = s.y;
    for (double& v : y)
      if (edged && v <= plot.bottom_edge->below) v = edge.at;
    Json& entry = json["series"].emplace_back(Json{{"label", s.label},
                                                   {"style", style_name(s.style)},
                                                   {"x", values(s.x, plot.log_x)},
                                                   {"y", values(y, plot.log_y)}});
    if (s.colour >= 0) entry["colour"] = s.colour;
    if (!s.role.empty()) entry["role"] = s.role;
    if (s.hidden) entry["hidden"] = true;
    if (!s.names.empty()) entry["names"] = s.names;
    if (!s.low.empty()) {
      entry["low"] = values(s.low, plot.log_y);
      entry["high"] = values(s.high, plot.log_y);
    }
    for (const double x : s.x) x_max = std::fmax(x_max, std::abs(x));
    for (const double v : s.y) y_max = std::fmax(y_max, std::abs(v));
  }
  if (!plot.counted.empty()) {
    json["counted"] = plot.counted;
    json["all"] = plot.all;
  }
  if (plot.range_y && !plot.log_y) json["range_y"] = {plot.range_y->first, plot.range_y->second};
  if (plot.equal_axes) {  // a half plane seen from the side
    const double size = 1.05 * std::fmax(std::fmax(x_max, y_max), plot.reach);
    json["range_x"] = {-size, size};
    json["range_y"] = {0, size};
  }
  return json;
}

void append_ticks(std::string& html, const char* extra, const std::vector<std::string>& ticks) {
  html += std::string("<div class=\"ticks") + extra + "\">";
  for (const std::string& tick : ticks) html += "<span>" + html_escaped(tick) + "</span>";
  html += "</div>";
}

}  // namespace

std::vector<int> channel_palette(const std::vector<std::string>& channels) {
  constexpr std::array kRedGreenBlue{1, 2, 0};  // numbers of --c0 to --c7 in html_page.css
  std::vector<int> numbers(channels.size(), -1);
  const auto colours = channel_colours(channels);
  if (colours && channels.size() > 1)
    for (std::size_t k = 0; k < 3; ++k) numbers[colours->of[k]] = kRedGreenBlue[k];
  int next = channels.size() > 1 && colours ? 3 : 0;
  for (int& number : numbers)
    if (number < 0) number = next++;
  return numbers;
}

void HtmlReport::plot(const Plot& plot) {
  const std::string id = "plot" + std::to_string(count_++);
  body_ += "<figure class=\"plot\"><p class=\"title\">" + html_escaped(plot.title) +
           "</p><p class=\"axis y\">" + running_text(plot.y_label) + "</p><div class=\"chart" +
           (plot.equal_axes ? " square" : "") + "\"><canvas id=\"" + id + "\" role=\"img\" aria-label=\"" +
           html_escaped(plot.title) + "\"></canvas></div><p class=\"axis x\">" + running_text(plot.x_label) +
           "</p>";
  if (!plot.caption.empty()) body_ += "<figcaption>" + running_text(plot.caption) + "</figcaption>";
  command(plot.command);
  body_ += "</figure>\n";
  if (!plots_.empty()) plots_ += ",\n";
  plots_ += to_line(to_json(plot));
}

void HtmlReport::map(const HeatMap& m) {
  body_ += "<figure><div class=\"map\"><div class=\"y\">" + running_text(m.y_label) + "</div>";
  append_ticks(body_, " up", m.y_ticks);
  body_ += image(m.png, m.caption) + "<div class=\"x\">";
  append_ticks(body_, "", m.x_ticks);
  body_ += running_text(m.x_label) + "</div></div>" + colour_bar(m.low, m.colours, m.high) + "<figcaption>" +
           running_text(m.caption) + "</figcaption>";
  command(m.command);
  body_ += "</figure>\n";
}

void map_colour(double x, unsigned char rgb[3], Colours colours) {
  const ColourScale& stations = colours == Colours::sequential ? kSequentialScale : kDivergingScale;
  const double at = 4 * std::fmin(std::fmax(x, 0.0), 1.0);
  const std::size_t k = at >= 4 ? 3 : std::size_t(at);
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<unsigned char>(stations[k][c] +
                                        (at - double(k)) * (stations[k + 1][c] - stations[k][c]) + 0.5);
}

}  // namespace brdf::io
