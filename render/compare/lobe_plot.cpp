#include "render/compare/lobe_plot.h"

#include <algorithm>
#include <cmath>

#include "io/colour/in_colour.h"
#include "io/files/numbers.h"
#include "io/samples/in_plane.h"
#include "render/compare/lobe_colours.h"
#include "render/compare/lobe_points.h"

namespace brdf::render {
namespace {

constexpr std::array kFirst{ByteColor{235, 80, 70}, ByteColor{90, 205, 90}, ByteColor{90, 145, 255}};
constexpr std::array kSecond{ByteColor{255, 175, 155}, ByteColor{185, 245, 175}, ByteColor{175, 210, 255}};

glm::vec2 at_angle(Angle angle, float radius) {
  return radius * glm::vec2(float(std::sin(angle.radians())), float(std::cos(angle.radians())));
}

std::vector<glm::vec2> half_circle(float radius) {
  std::vector<glm::vec2> points;
  for (int k = -90; k <= 90; k += 3) points.push_back(at_angle(degrees(k), radius));
  return points;
}

// Returns the colour of each channel, in the order of a material's or a table's channels.
std::vector<ByteColor> channel_colors(const std::vector<std::string>& channels, bool second) {
  const auto& shades = second ? kSecond : kFirst;
  std::vector<ByteColor> out;
  for (std::size_t c = 0; c < channels.size(); ++c) out.push_back(shades[c % 3]);
  if (const auto colours = io::channel_colours(channels); colours && channels.size() >= 3)
    for (std::size_t k = 0; k < 3; ++k) out[colours->of[k]] = shades[k];
  return out;
}

}  // namespace

bool is_shown(int solo, std::size_t curve) {
  return solo < 0 || std::size_t(solo) == curve;
}

bool is_shown(int solo, const LobeDot& dot, const std::vector<LobeCurve>& curves) {
  return solo < 0 || std::size_t(solo) >= curves.size() || curves[std::size_t(solo)].channel == dot.channel;
}

std::vector<LobeCurve> lobe_curves(const Material& given, const std::string& name, double theta_i_degrees,
                                   bool second) {
  const Material material = io::in_colour(given);
  const std::size_t channels = material.channels.size();
  std::vector<LobeCurve> curves(channels);
  std::vector<double> f(channels);
  const Vec3<double> wi = direction(degrees(theta_i_degrees), {});
  for (int k = 0; k < kLobePoints; ++k) {
    const int theta = k - kSteepest;
    eval(material, wi, direction(degrees(std::abs(theta)), degrees(theta > 0 ? 180 : 0)), f);
    for (std::size_t c = 0; c < channels; ++c) curves[c].values.push_back(float(f[c]));
  }
  const std::vector<ByteColor> colors = channel_colors(material.channels, second);
  for (std::size_t c = 0; c < channels; ++c) {
    curves[c].name = name + " " + material.channels[c];
    curves[c].channel = material.channels[c];
    curves[c].color = colors[c];
  }
  return curves;
}

std::vector<LobeCurve> lobe_curves(const ViewState& state) {
  return lobe_curves(state, double(state.plot_theta));
}

std::vector<LobeCurve> lobe_curves(const ViewState& state, double theta) {
  std::vector<LobeCurve> curves = lobe_curves(state.scene.objects.at(state.selected).material, "A", theta);
  const auto add = [&](const Material& material, const std::string& name) {
    for (LobeCurve& curve : lobe_curves(material, name, theta, true)) curves.push_back(std::move(curve));
  };
  if (state.other == Other::material && state.material) add(*state.material, "B");
  for (const auto& [name, material] : state.kept) add(material, name);
  return curves;
}

std::vector<LobeDot> lobe_dots(const io::SampleTable& given, double theta_i_degrees) {
  if (io::is_spectrum(given.channels)) return lobe_dots(io::in_colour(given), theta_i_degrees);
  const io::SampleTable& table = given;
  const std::vector<ByteColor> colors = channel_colors(table.channels, false);
  std::vector<LobeDot> dots;
  for (const LobePoint& point : points_in_plane(table, theta_i_degrees))
    for (std::size_t c = 0; c < table.channels.size(); ++c)
      dots.push_back({point.theta, float(table.values[c][point.row]), table.channels[c], colors[c]});
  return dots;
}

LobePlot lobe_plot(const std::vector<LobeCurve>& curves, double theta_i_degrees, int solo,
                   const std::vector<LobeDot>& dots) {
  LobePlot plot;
  plot.largest = 1e-6f;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (!is_shown(solo, c)) continue;
    for (const float f : curves[c].values) plot.largest = std::max(plot.largest, f);
  }
  for (const LobeDot& dot : dots)
    if (is_shown(solo, dot, curves)) plot.largest = std::max(plot.largest, dot.value);
  for (const float radius : {0.5f, 1.0f}) plot.paths.push_back({half_circle(radius), kLobeGrid, 1});
  for (int angle = -90; angle <= 90; angle += 30)
    plot.paths.push_back({{{0, 0}, at_angle(degrees(angle), 1)}, kLobeGrid, 1});
  plot.paths.push_back({{{0, 0}, at_angle(degrees(-theta_i_degrees), 1)}, kLobeLight, 1.5f});
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (!is_shown(solo, c)) continue;
    LobePath path{{}, curves[c].color, 2};
    for (int k = 0; k < kLobePoints; ++k) {
      const float share = std::max(0.0f, curves[c].values[std::size_t(k)]) / plot.largest;
      path.points.push_back(at_angle(degrees(k - kSteepest), std::cbrt(share)));
    }
    plot.paths.push_back(std::move(path));
  }
  for (const LobeDot& dot : dots) {
    const float share = std::max(0.0f, dot.value) / plot.largest;
    if (is_shown(solo, dot, curves))
      plot.dots.push_back({at_angle(degrees(dot.theta_o), std::cbrt(share)), dot.color});
  }
  return plot;
}

BytePicture lobe_picture(const std::vector<LobeCurve>& curves, double theta_i_degrees, int solo, int width,
                         const std::vector<LobeDot>& dots) {
  const int pixels = std::clamp(width / 45, 9, 40), pad = 3 * pixels;
  const float radius = float(width) / 2 - float(pad);
  const int words = dots.empty() ? 1 : 2;  // lines of text
  BytePicture out(width, int(radius) + 2 * pad + (1 + 2 * words) * pixels);
  fill(out, {0, 0}, {out.width, out.height}, {28, 28, 32});
  const glm::vec2 origin(float(width) / 2, float(pad) + radius);
  const auto place = [&](glm::vec2 p) { return origin + radius * glm::vec2(p.x, -p.y); };
  const LobePlot plot = lobe_plot(curves, theta_i_degrees, solo, dots);
  for (const LobePath& path : plot.paths) {
    std::vector<glm::vec2> points;
    for (const glm::vec2& p : path.points) points.push_back(place(p));
    draw_path(out, points, path.width, path.color);
  }
  const float dot_size = std::max(4.0f, float(pixels) / 3);
  for (const LobePlot::Dot& dot : plot.dots) draw_dot(out, place(dot.at), dot_size, dot.color);
  const auto centred = [&](glm::vec2 at, const std::string& text, ByteColor color) {
    draw_text(out, at - glm::vec2(text_width(text, pixels) / 2, 0), text, pixels, color);
  };
  for (int angle = -90; angle <= 90; angle += 30) {
    centred(place(at_angle(degrees(angle), 1 + 1.2f * float(pixels) / radius)) +
                glm::vec2(0, 0.35f * float(pixels)),
            std::to_string(std::abs(angle)) + "°", kLobeWords);
  }
  // The radius is the cube root of the share, so that half of the radius corresponds to an eighth.
  const float below = origin.y + 1.6f * float(pixels);
  centred({origin.x + radius / 2, below}, io::short_number(double(plot.largest) / 8, 3), kLobeWords);
  centred({origin.x + radius, below}, io::short_number(double(plot.largest), 3), kLobeWords);
  centred({origin.x, below}, "0", kLobeWords);
  centred({origin.x - radius / 2, below}, "radius: cube root of f_r in 1/sr", kLobeWords);
  float left = float(pixels);
  float line = origin.y + 4 * float(pixels);
  const auto word = [&](const std::string& text, ByteColor color) {
    draw_text(out, {left, line}, text, pixels, color);
    left += text_width(text, pixels) + 1.5f * float(pixels);
  };
  word("incidence " + io::short_number(theta_i_degrees, 3) + "°", kLobeLight);
  for (std::size_t c = 0; c < curves.size(); ++c)
    if (is_shown(solo, c)) word(curves[c].name, curves[c].color);
  if (dots.empty()) return out;
  left = float(pixels);
  line += 2 * float(pixels);
  draw_dot(out, {left, line - 0.35f * float(pixels)}, dot_size, kLobeWords);
  left += float(pixels);
  word("measured, within " + io::short_number(io::kInPlane, 3) + "° of the plane of incidence", kLobeWords);
  return out;
}

}  // namespace brdf::render
