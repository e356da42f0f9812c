#include "io/page/sphere/page.h"

#include "io/colour/channel_colours.h"
#include "io/files/base64.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/material/glsl.h"
#include "io/page/hatching.h"
#include "io/page/html_markup.h"
#include "io/page/sphere/files.h"
#include "io/page/sphere/still.h"

namespace brdf::io::sphere {
namespace {

constexpr int kStillSide = 180;

Json stations() {
  Json list = Json::array();
  for (int k = 0; k <= 4; ++k) {
    unsigned char rgb[3];
    map_colour(k / 4.0, rgb, Colours::diverging);
    list.push_back({rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0});
  }
  return list;
}

Json to_json(const Table& table) {
  const TableSize& n = table.size;
  return {{"counts", {n.theta_h, n.theta_d, n.phi_d, n.phi_h}},
          {"scale", {table.low, table.high, table.floor}},
          {"bytes", base64(table.bytes)}};
}

std::string controls(bool measured) {
  const std::string choice = measured
                                 ? "<label>show <select class=\"show\"><option value=\"all\">all "
                                   "three</option><option>fitted</option>"
                                   "<option>measured</option><option>difference</option></select></label>"
                                 : "<select class=\"show\" hidden><option>fitted</option></select>";
  return "<div class=\"controls\">" + choice +
         "<label>Drag or arrow keys turn <select class=\"moves\"><option value=\"sphere\">the sphere</option>"
         "<option value=\"light\">the light (or hold Shift)</option></select></label>"
         "<label>exposure <input class=\"exposure\" type=\"range\" min=\"-14\" max=\"14\" "
         "step=\"0.5\"></label>"
         "<button class=\"reset\" type=\"button\">Reset</button><output "
         "class=\"reading\"></output></div>";
}

}  // namespace

std::string obstacle(const Material& material) {
  if (!channel_colours(material.channels)) return "its channels are not colours";
  for (const Term& term : material.terms)
    if (!info(term.form).has_glsl) return std::string(info(term.form).name) + " cannot be written as GLSL";
  return "";
}

void add(HtmlReport& report, const Shown& shown) {
  if (const std::string why = obstacle(shown.fitted); !why.empty())
    throw InputError("no sphere for " + shown.title + ": " + why);
  const bool measured = bool(shown.measured);
  const FittedPairs fitted = fitted_pairs(shown.fitted);
  const double exposure = exposure_of(fitted);
  const std::string functions = glsl_source(shown.fitted, {.whole = false, .dialect = GlslDialect::es});
  Json data{
      {"shader", "#version 300 es\nprecision highp float;\nprecision highp int;\n" + functions + kShader},
      {"exposure", exposure},
      {"stations", stations()},
      {"hatching", {kHatchPeriod, kHatchDark / 255.0, kHatchBright / 255.0}}};
  if (measured) data["table"] = to_json(table_of(fitted, shown.measured, shown.table));
  const std::string what =
      measured ? "fitted, measured and the difference of the two" : "computed from the formula";
  const std::string name = shown.title + " on a sphere: " + what;
  std::string html =
      "<figure class=\"sphere" + std::string(measured ? "" : " one") + "\"><p class=\"title\">" +
      html_escaped(shown.title) + " on a sphere</p>" +
      "<canvas tabindex=\"0\" role=\"application\" aria-label=\"" + html_escaped(name) +
      ". Arrow keys turn the sphere, with Shift they move the light, Home resets both.\"></canvas>";
  std::string still = image(
      shown.still.empty() ? still_picture(fitted, shown.measured, exposure, kStillSide) : shown.still, name);
  html += still.insert(still.find(' '), " class=\"still\"");
  if (measured)
    html += "<div class=\"titles\"><span>fitted</span><span>measured</span><span>difference</span></div>" +
            colour_bar("fitted 50 % too dark", Colours::diverging, "50 % too bright");
  html += controls(measured) +
          "<p class=\"note\">This picture is static: an interactive sphere needs a browser with WebGL 2 and "
          "scripts.</p>"
          "<figcaption>Lit by one distant light, initially 44.8 degrees from the viewing direction. " +
          (measured ? std::string("Hatched: no measurements nearby. The difference combines all channels, "
                                  "relative to the measured values. ")
                    : std::string()) +
          "<span class=\"turning\">Drag the sphere, or use the arrow keys while it has the "
          "focus.</span></figcaption><script type=\"application/json\">" +
          within_script(to_line(data)) + "</script></figure>";
  report.raw(html);
  report.style(kStyle);
  report.script(kScript);
}

}  // namespace brdf::io::sphere
