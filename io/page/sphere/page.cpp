#include "io/page/sphere/page.h"

#include "io/colour/channel_colours.h"
#include "io/files/base64.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/material/glsl.h"
#include "io/page/hatching.h"
#include "io/page/html_markup.h"
#include "io/page/sphere/files.h"
#include "io/page/sphere/still.h"
#include "io/page/sphere/studio.h"

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
         "<label>turn <select class=\"moves\"><option value=\"sphere\">the sphere</option>"
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

namespace {

constexpr const char* kMeasuredTitles =
    "<div class=\"titles\"><span>fitted</span><span>measured</span><span>difference</span></div>";

// The parts of a figure that differ between the studio and the single light.
struct Block {
  std::string kind, title, name, still, below, caption;
  bool measured = false;
  Json data;
};

std::string figure(const Block& block) {
  std::string still = image(block.still, block.name);
  still.insert(still.find(' '), " class=\"still\"");
  return "<figure class=\"sphere " + block.kind + "\"><p class=\"title\">" + html_escaped(block.title) +
         "</p><canvas tabindex=\"0\" role=\"application\" aria-label=\"" + html_escaped(block.name) +
         ". Arrow keys turn the sphere, with Shift they move the light, Home resets both.\"></canvas>" +
         still + block.below + controls(block.measured) +
         "<p class=\"note\">This picture is static: an interactive sphere needs a browser with WebGL 2 and "
         "scripts.</p><figcaption>" +
         block.caption +
         " <span class=\"turning\">Drag the sphere, or use the arrow keys while it has the "
         "focus.</span></figcaption><script type=\"application/json\">" +
         within_script(to_line(block.data)) + "</script></figure>";
}

Block in_studio(const Shown& shown, const FittedPairs& fitted) {
  const double exposure = studio_exposure(shown.fitted);
  const std::string functions = glsl_source(shown.fitted, {.whole = false, .dialect = GlslDialect::es});
  return {
      .kind = "one",
      .title = shown.title + " in the studio",
      .name = shown.title + " in the studio: computed from the formula",
      .still = shown.still.empty() ? studio_pictures(shown.fitted, exposure, kStillSide).whole : shown.still,
      .caption = std::string(shown.measured ? "The fitted material in" : "In") +
                 " the studio: three soft boxes and a bright floor, as in <code>brdf render</code>." +
                 (exposure == 0 ? "" : " Exposure " + short_number(exposure) + " stops."),
      .data = {{"shader", "#version 300 es\nprecision highp float;\nprecision highp int;\n" + functions +
                              studio_glsl() + kShader},
               {"exposure", exposure},
               {"studio", lobe_widths(fitted)},
               {"stations", stations()},
               {"hatching", {kHatchPeriod, kHatchDark / 255.0, kHatchBright / 255.0}}}};
}

// The shader is that of the sphere in the studio before it.
Block under_one_light(const Shown& shown, const FittedPairs& fitted) {
  const double exposure = exposure_of(fitted), range = difference_range(fitted, shown.measured);
  return {.kind = "measured",
          .title = shown.title + " under one light, measured and fitted",
          .name = shown.title + " under one light: fitted, measured and the difference of the two",
          .still = still_picture(fitted, shown.measured, exposure, kStillSide),
          .below = kMeasuredTitles + colour_bar("fitted " + percent(range) + " too dark", Colours::diverging,
                                                percent(range) + " too bright"),
          .caption =
              "For comparison: lit by one distant light only, initially 44.8 degrees from the viewing "
              "direction. Hatched: no measurements nearby. The difference combines all channels, "
              "relative to the measured values." +
              (shown.caption.empty() ? "" : " " + html_escaped(shown.caption)),
          .measured = true,
          .data = {{"exposure", exposure},
                   {"range", range},
                   {"stations", stations()},
                   {"hatching", {kHatchPeriod, kHatchDark / 255.0, kHatchBright / 255.0}},
                   {"table", to_json(table_of(fitted, shown.measured, shown.table))}}};
}

}  // namespace

void add(HtmlReport& report, const Shown& shown) {
  if (const std::string why = obstacle(shown.fitted); !why.empty())
    throw InputError("no sphere for " + shown.title + ": " + why);
  const FittedPairs fitted = fitted_pairs(shown.fitted);
  std::string html = figure(in_studio(shown, fitted));
  if (shown.measured)
    html = "<div class=\"lights\">" + html + figure(under_one_light(shown, fitted)) + "</div>";
  report.raw(html);
  report.style(kStyle);
  report.script(kScript);
}

}  // namespace brdf::io::sphere
