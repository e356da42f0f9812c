#include "io/html_report.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>

#include "io/channel_colours.h"
#include "io/error.h"
#include "io/json.h"

#ifndef BRDF_CHART_JS
#define BRDF_CHART_JS "/usr/share/javascript/chart.js/chart.min.js"
#endif

namespace brdf::io {
namespace {

constexpr const char* kStyle = R"css(
body { font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; color: #1a1a1a; background: #fff; max-width: 62rem;
  margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; margin-bottom: .3rem; } h2 { font-size: 1.25rem; margin: 2.2rem 0 .6rem; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; margin: .6rem 0 1rem; }
th, td { text-align: left; padding: .3rem .6rem; border-bottom: 1px solid #ddd; vertical-align: top; }
th { background: #f2f2f2; }
code, pre { font: .82rem/1.4 "DejaVu Sans Mono", monospace; }
pre { background: #f6f6f6; padding: .5rem .7rem; overflow-x: auto; white-space: pre-wrap; word-break: break-all; }
.good { color: #0a6b2d; font-weight: 600; } .warn { color: #8a5a00; font-weight: 600; }
.bad { color: #b00020; font-weight: 600; }
.verdict { border-left: .4rem solid #999; padding: .4rem .8rem; margin: .8rem 0; background: #f8f8f8; }
.verdict.good { border-color: #0a6b2d; } .verdict.warn { border-color: #d09000; }
.verdict.bad { border-color: #b00020; }
figure { margin: 1rem 0 1.6rem; break-inside: avoid; } figcaption { font-size: .9rem; color: #444; }
.chart { position: relative; height: 22rem; } .chart.square { height: 23rem; max-width: 38rem; }
img { max-width: 100%; image-rendering: auto; }
td.good, td.warn, td.bad { white-space: nowrap; }
td pre { margin: .3rem 0 0; padding: .3rem .5rem; word-break: normal; overflow-wrap: anywhere; }
.map { display: inline-grid; grid-template-columns: auto auto 22.5rem; gap: .2rem .4rem; font-size: .8rem; color: #444; }
.map img { width: 22.5rem; height: 22.5rem; image-rendering: pixelated; }
.map .y { writing-mode: vertical-rl; transform: rotate(180deg); text-align: center; }
.map .x { grid-column: 3; text-align: center; } .map .ticks { display: flex; justify-content: space-between; }
.map .up { flex-direction: column-reverse; text-align: right; }
.bar { display: flex; gap: .5rem; align-items: center; font-size: .8rem; color: #444; margin: .5rem 0; }
.bar i { width: 12rem; height: .8rem; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
footer { margin-top: 3rem; border-top: 1px solid #ccc; font-size: .85rem; color: #555; }
@media print { body { max-width: none; margin: 0; } .chart { height: 16rem; } a { color: inherit; } }
)css";

// Draws every plot once, without animation, and leaves a mark that a test can wait for.
constexpr const char* kDraw = R"js(
const palette = ["#1f5fa8", "#c2410c", "#2e7d32", "#7b1fa2", "#00838f", "#6d4c41", "#ad1457", "#455a64"];
Chart.defaults.font.family = '"DejaVu Sans", system-ui, sans-serif';
Chart.defaults.animation = false;
// Ticks of a logarithmic axis: 1, 2 and 5 times a power of ten, in few digits.
const decade = (value) => {
  const digit = Math.round(value / 10 ** Math.floor(Math.log10(value) + 1e-9));
  if (![1, 2, 5].includes(digit)) return "";
  return value >= 1e-3 && value < 1e4 ? String(Number(value.toPrecision(2))) : value.toExponential(0);
};
for (const [index, plot] of plots.entries()) {
  const axis = (label, log, range) => ({ type: log ? "logarithmic" : "linear", title: { display: true, text: label },
    min: range ? range[0] : undefined, max: range ? range[1] : undefined,
    ticks: log ? { callback: decade } : {} });
  const datasets = plot.series.flatMap((s, k) => {
    const faint = s.style.startsWith("faint"), points = s.style.endsWith("points");
    const colour = faint ? "#bbbbbb" : palette[(s.colour ?? k) % palette.length];
    const line = { label: s.label, data: s.x.map((x, j) => ({ x: x, y: s.y[j] })), borderColor: colour,
      backgroundColor: colour, borderWidth: faint ? 1 : 2, showLine: !points,
      borderDash: s.style === "dashed" ? [6, 4] : [], pointRadius: points ? 2.5 : 0, spanGaps: false };
    const edge = (values, fill) => ({ label: "", data: s.x.map((x, j) => ({ x: x, y: values[j] })), showLine: true,
      borderWidth: 0, pointRadius: 0, fill: fill, backgroundColor: colour + "38" });
    return s.low ? [edge(s.low, false), edge(s.high, "-1"), line] : [line];
  });
  new Chart(document.getElementById("plot" + index), { type: "scatter", data: { datasets }, options: {
    maintainAspectRatio: false, responsive: true,
    plugins: { legend: { display: plot.series.length > 1,
        labels: { boxHeight: 2, filter: item => item.text !== "" } },
      title: { display: true, text: plot.title, font: { size: 15 } } },
    scales: { x: axis(plot.x_label, plot.log_x, plot.range_x), y: axis(plot.y_label, plot.log_y, plot.range_y) } } });
}
addEventListener("beforeprint", () => { for (const chart of Object.values(Chart.instances)) chart.resize(); });
document.documentElement.dataset.plots = plots.length;
)js";

const char* css_class(Mark mark) {
  constexpr std::array names{"", "good", "warn", "bad"};
  return names[std::size_t(mark)];
}

const char* style_name(Series::Style style) {
  constexpr std::array names{"line", "dashed", "points", "faint", "faint_points"};
  return names[std::size_t(style)];
}

Json values(const std::vector<double>& data, bool log) {
  Json array = Json::array();
  for (const double v : data) {
    if (std::isfinite(v) && (!log || v > 0))
      array.push_back(v);
    else
      array.push_back(nullptr);
  }
  return array;
}

Json to_json(const Plot& plot) {
  Json json{{"title", plot.title}, {"x_label", plot.x_label}, {"y_label", plot.y_label},
            {"log_x", plot.log_x}, {"log_y", plot.log_y},     {"series", Json::array()}};
  double x_max = 0, y_max = 0;
  for (const Series& s : plot.series) {
    json["series"].push_back({{"label", s.label},
                              {"style", style_name(s.style)},
                              {"x", values(s.x, plot.log_x)},
                              {"y", values(s.y, plot.log_y)}});
    if (s.colour >= 0) json["series"].back()["colour"] = s.colour;
    if (!s.low.empty()) {
      json["series"].back()["low"] = values(s.low, plot.log_y);
      json["series"].back()["high"] = values(s.high, plot.log_y);
    }
    for (const double x : s.x) x_max = std::fmax(x_max, std::abs(x));
    for (const double y : s.y) y_max = std::fmax(y_max, std::abs(y));
  }
  if (plot.equal_axes) {  // a half plane seen from the side
    const double size = 1.05 * std::fmax(x_max, y_max);
    json["range_x"] = {-size, size};
    json["range_y"] = {0, size};
  }
  return json;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j)
      text += k + j <= bytes.size() && (j < 2 || k + j - 1 < bytes.size())
                  ? kDigits[group >> (18 - 6 * j) & 63]
                  : '=';
  }
  return text;
}

std::string chart_library() {
  std::ifstream file(BRDF_CHART_JS, std::ios::binary);
  if (!file)
    throw EnvironmentError("HTML reports need Chart.js at " BRDF_CHART_JS " (Debian: libjs-chart.js)");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  // The addresses in its licence comments lose their scheme: a report refers to nothing outside, and a search
  // for addresses can show it.
  constexpr std::string_view kScheme = "https://";
  for (std::size_t comment = 0; (comment = text.find("/*!", comment)) != text.npos; ++comment)
    for (std::size_t at; (at = text.find(kScheme, comment)) < text.find("*/", comment);)
      text.erase(at, kScheme.size());
  return text;
}

void append_ticks(std::string& html, const char* extra, const std::vector<std::string>& ticks) {
  html += std::string("<div class=\"ticks") + extra + "\">";
  for (const std::string& tick : ticks) html += "<span>" + html_escaped(tick) + "</span>";
  html += "</div>";
}

// The colours of map_colour() as a CSS gradient.
std::string gradient(Colours colours) {
  std::string css = "linear-gradient(90deg";
  for (int k = 0; k <= 4; ++k) {
    unsigned char rgb[3];
    map_colour(k / 4.0, rgb, colours);
    css +=
        ", rgb(" + std::to_string(rgb[0]) + " " + std::to_string(rgb[1]) + " " + std::to_string(rgb[2]) + ")";
  }
  return css + ")";
}

}  // namespace

std::vector<int> channel_palette(const std::vector<std::string>& channels) {
  constexpr std::array kRedGreenBlue{1, 2, 0};  // in kDraw's palette
  std::vector<int> numbers(channels.size(), -1);
  const auto colours = channel_colours(channels);
  if (colours && channels.size() > 1)
    for (std::size_t k = 0; k < 3; ++k) numbers[colours->of[k]] = kRedGreenBlue[k];
  int next = channels.size() > 1 && colours ? 3 : 0;
  for (int& number : numbers)
    if (number < 0) number = next++;
  return numbers;
}

std::string html_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

void HtmlReport::heading(std::string_view text) {
  body_ += "<h2>" + html_escaped(text) + "</h2>\n";
}

void HtmlReport::paragraph(std::string_view text) {
  body_ += "<p>" + html_escaped(text) + "</p>\n";
}

void HtmlReport::verdict(Mark mark, std::string_view text) {
  body_ += std::string("<p class=\"verdict ") + css_class(mark) + "\">" + html_escaped(text) + "</p>\n";
}

void HtmlReport::table(const std::vector<std::string>& header, const std::vector<std::vector<Cell>>& rows) {
  body_ += "<table><thead><tr>";
  for (const std::string& h : header) body_ += "<th>" + html_escaped(h) + "</th>";
  body_ += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    body_ += "<tr>";
    for (const Cell& cell : row) {
      const std::string text = html_escaped(cell.text);
      body_ += cell.mark == Mark::none ? "<td>" : std::string("<td class=\"") + css_class(cell.mark) + "\">";
      body_ += cell.code && !text.empty() ? "<code>" + text + "</code>" : text;
      if (!cell.command.empty()) body_ += "<pre>" + html_escaped(cell.command) + "</pre>";
      body_ += "</td>";
    }
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table>\n";
}

void HtmlReport::plot(const Plot& plot) {
  const std::string id = "plot" + std::to_string(count_++);
  body_ += std::string("<figure><div class=\"chart") + (plot.equal_axes ? " square" : "") +
           "\"><canvas id=\"" + id + "\" role=\"img\" aria-label=\"" + html_escaped(plot.title) +
           "\"></canvas></div>";
  if (!plot.caption.empty()) body_ += "<figcaption>" + html_escaped(plot.caption) + "</figcaption>";
  body_ += "</figure>\n";
  command(plot.command);
  if (!plots_.empty()) plots_ += ",\n";
  plots_ += to_line(to_json(plot));
}

void HtmlReport::picture(std::string_view png, std::string_view caption, std::string_view made_by) {
  body_ += "<figure><img alt=\"" + html_escaped(caption) + "\" src=\"data:image/png;base64," + base64(png) +
           "\"><figcaption>" + html_escaped(caption) + "</figcaption></figure>\n";
  command(made_by);
}

void HtmlReport::map(const HeatMap& m) {
  body_ += "<figure><div class=\"map\"><div class=\"y\">" + html_escaped(m.y_label) + "</div>";
  append_ticks(body_, " up", m.y_ticks);
  body_ += "<img alt=\"" + html_escaped(m.caption) + "\" src=\"data:image/png;base64," + base64(m.png) +
           "\"><div class=\"x\">";
  append_ticks(body_, "", m.x_ticks);
  body_ += html_escaped(m.x_label) + "</div></div><div class=\"bar\"><span>" + html_escaped(m.low) +
           "</span><i style=\"background: " + gradient(m.colours) + "\"></i><span>" + html_escaped(m.high) +
           "</span></div><figcaption>" + html_escaped(m.caption) + "</figcaption></figure>\n";
  command(m.command);
}

void HtmlReport::command(std::string_view text) {
  if (!text.empty()) body_ += "<pre>" + html_escaped(text) + "</pre>\n";
}

std::string HtmlReport::document(const Provenance& made) const {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      html_escaped(title_) + "</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>" + kStyle +
      "</style></head>\n<body>\n<h1>" + html_escaped(title_) + "</h1>\n" + body_ + "<footer><p>";
  for (const auto& [key, value] : provenance_fields(made))
    html += html_escaped(key) + ": <code>" + html_escaped(value) + "</code><br>";
  html += "</p></footer>\n";
  if (!plots_.empty()) {
    std::string data;  // in a script element "</" and "<!--" have meanings of their own
    for (const char c : plots_) data += c == '<' ? std::string("\\u003c") : std::string(1, c);
    html += "<script>" + chart_library() + "</script>\n<script>\nconst plots = [\n" + data + "\n];" + kDraw +
            "</script>\n";
  }
  return html + "</body></html>\n";
}

void map_colour(double x, unsigned char rgb[3], Colours colours) {
  // Five stations of even lightness steps.
  using Stations = double[5][3];
  constexpr Stations kSequential = {
      {48, 18, 59}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
  constexpr Stations kDiverging = {
      {31, 95, 168}, {143, 175, 212}, {255, 255, 255}, {217, 140, 149}, {178, 24, 43}};
  const Stations& stations = colours == Colours::sequential ? kSequential : kDiverging;
  const double at = 4 * std::fmin(std::fmax(x, 0.0), 1.0);
  const int k = at >= 4 ? 3 : int(at);
  for (int c = 0; c < 3; ++c)
    rgb[c] =
        static_cast<unsigned char>(stations[k][c] + (at - k) * (stations[k + 1][c] - stations[k][c]) + 0.5);
}

}  // namespace brdf::io
