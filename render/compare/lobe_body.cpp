#include "render/compare/lobe_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/colour/channel_colours.h"
#include "io/colour/in_colour.h"
#include "io/files/numbers.h"
#include "render/compare/lobe_colours.h"
#include "render/compare/lobe_points.h"
#include "render/picture/canvas.h"

namespace brdf::render {
namespace {

constexpr double kReach = 89;                     // degrees of theta_o
constexpr int kRings = 90, kSectors = 180;        // of a body in a picture
constexpr int kTurnedSectors = 72;                // of a body that readers turn
constexpr Angle kTurn = 25_deg, kAbove = 28_deg;  // of the eye
constexpr ByteColor kBackground{28, 28, 32}, kDots{255, 140, 40};

// The view from the side and from above, without perspective. x of the lobe's frame points to the mirror
// direction.
struct Eye {
  glm::vec3 right, up, back;  // unit vectors; back points to the eye

  explicit Eye(Angle turn, Angle above) {
    const float ct = float(std::cos(turn.radians())), st = float(std::sin(turn.radians())),
                ca = float(std::cos(above.radians())), sa = float(std::sin(above.radians()));
    right = {ct, st, 0};
    back = {st * ca, -ct * ca, sa};
    up = glm::cross(back, right);
  }
  glm::vec3 seen(const glm::vec3& p) const {
    return {glm::dot(p, right), glm::dot(p, up), glm::dot(p, back)};
  }
};

glm::vec3 towards(double theta, double phi) {
  const Vec3<double> d = direction(degrees(theta), degrees(phi));
  return {float(d.x), float(d.y), float(d.z)};
}

// f_r of the channels for directions in the lobe's frame.
class Lobe {
 public:
  Lobe(const Material& material, double theta_i)
      : material_(io::in_colour(material)), wi_(direction(degrees(theta_i), 180_deg)) {
    const auto colours = io::channel_colours(material_.channels);
    if (colours) of_ = colours->of;
  }
  glm::vec3 at(double theta, double phi) const {
    std::vector<double> f(material_.channels.size());
    eval(material_, wi_, direction(degrees(theta), degrees(phi)), f);
    return {float(f[of_[0]]), float(f[of_[1]]), float(f[of_[2]])};
  }

 private:
  Material material_;
  Vec3<double> wi_;
  std::array<std::size_t, 3> of_{0, 0, 0};
};

float largest_of(const glm::vec3& f) {
  return std::max({f.r, f.g, f.b, 0.0f});
}

// A picture with the nearest depth of each pixel.
class Canvas {
 public:
  Canvas(int width, int height, const Eye& eye, glm::vec2 origin, float scale)
      : picture(width, height),
        eye_(eye),
        origin_(origin),
        scale_(scale),
        depth_(picture.pixels.size(), -std::numeric_limits<float>::infinity()) {}

  // Returns the place in pixels (x, y), and the coordinate towards the eye in the lobe's units (z).
  glm::vec3 place(const glm::vec3& p) const {
    const glm::vec3 s = eye_.seen(p);
    return {origin_.x + scale_ * s.x, origin_.y - scale_ * s.y, s.z};
  }
  void path(const std::vector<glm::vec3>& points, float width, ByteColor color) {
    std::vector<glm::vec2> places;
    for (const glm::vec3& p : points) places.emplace_back(place(p));
    draw_path(picture, places, width, color);
  }
  void triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, ByteColor color) {
    const std::array p{place(a), place(b), place(c)};
    const float area = cross(p[0], p[1], p[2]);
    if (std::abs(area) < 1e-9f) return;
    const auto low = [&](int axis) { return std::min({p[0][axis], p[1][axis], p[2][axis]}); };
    const auto high = [&](int axis) { return std::max({p[0][axis], p[1][axis], p[2][axis]}); };
    for (int y = std::max(0, int(low(1))); y <= std::min(picture.height - 1, int(high(1))); ++y) {
      for (int x = std::max(0, int(low(0))); x <= std::min(picture.width - 1, int(high(0))); ++x) {
        const glm::vec3 at(float(x) + 0.5f, float(y) + 0.5f, 0);
        const float u = cross(at, p[1], p[2]) / area, v = cross(p[0], at, p[2]) / area, w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0) continue;
        const float depth = u * p[0].z + v * p[1].z + w * p[2].z;
        const std::size_t k = index(x, y);
        if (depth <= depth_[k]) continue;
        depth_[k] = depth;
        picture.pixels[k] = color;
      }
    }
  }
  // Draws a dot, faint if a part of the body hides it.
  void dot(const glm::vec3& p, float size, ByteColor color) {
    const glm::vec3 at = place(p);
    const int x = int(at.x), y = int(at.y);
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
    // Of the radius: a measured value that agrees with the material lies on the body.
    constexpr float kInside = 0.01f;
    draw_dot(picture, glm::vec2(at), size, color, at.z + kInside < depth_[index(x, y)] ? 0.25f : 1);
  }

  BytePicture picture;

 private:
  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(picture.width) + std::size_t(x);
  }
  static float cross(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  Eye eye_;
  glm::vec2 origin_;
  float scale_;
  std::vector<float> depth_;
};

void draw_ground(Canvas& canvas) {
  for (const float radius : {0.5f, 1.0f}) {
    std::vector<glm::vec3> ring;
    for (int k = 0; k <= 90; ++k) ring.push_back(radius * towards(90, 4 * k));
    canvas.path(ring, 1, kLobeGrid);
  }
  for (int phi = 0; phi < 360; phi += 45) canvas.path({{0, 0, 0}, towards(90, phi)}, 1, kLobeGrid);
  canvas.path({{0, 0, 0}, {0, 0, 1}}, 1, kLobeGrid);
}

// The points of the body, ring by ring from the normal.
struct Body {
  std::vector<glm::vec3> points, values;
  const glm::vec3& point(int ring, int sector) const { return points[at(ring, sector)]; }
  static std::size_t at(int ring, int sector) {
    return std::size_t(ring) * kSectors + std::size_t(sector % kSectors);
  }
};

std::vector<glm::vec3> values_of(const Lobe& lobe) {
  std::vector<glm::vec3> values;
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector)
      values.push_back(lobe.at(ring, sector * 360.0 / kSectors));
  return values;
}

Body body_of(const Lobe& lobe, float& largest, float outer) {
  Body body;
  body.values = values_of(lobe);
  for (const glm::vec3& f : body.values) largest = std::max(largest, largest_of(f));
  largest = std::max(largest, outer);
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector) {
      const glm::vec3& f = body.values[body.points.size()];
      body.points.push_back(std::cbrt(largest_of(f) / largest) * towards(ring, sector * 360.0 / kSectors));
    }
  return body;
}

// The colour (0 to 255) of the body for a value, before the shading.
glm::vec3 surface_color(const glm::vec3& f) {
  return 215.0f * glm::mix(glm::vec3(1), f / std::max(largest_of(f), 1e-20f), 0.7f);
}

void draw_body(Canvas& canvas, const Body& body, const Eye& eye) {
  const glm::vec3 light = glm::normalize(0.5f * eye.up + 0.8f * eye.back - 0.4f * eye.right);
  for (int ring = 0; ring + 1 < kRings; ++ring) {
    for (int sector = 0; sector < kSectors; ++sector) {
      const glm::vec3 &a = body.point(ring, sector), &b = body.point(ring, sector + 1),
                      &c = body.point(ring + 1, sector + 1), &d = body.point(ring + 1, sector);
      glm::vec3 normal = glm::cross(c - a, b - d);
      const float length = glm::length(normal);
      if (!(length > 0)) continue;
      normal /= length;
      if (glm::dot(normal, a + c) < 0) normal = -normal;
      const float shade = 0.3f + 0.7f * std::max(0.0f, glm::dot(normal, light));
      const glm::vec3 color = shade * surface_color(body.values[Body::at(ring, sector)]);
      const ByteColor bytes{std::uint8_t(color.r), std::uint8_t(color.g), std::uint8_t(color.b)};
      canvas.triangle(a, b, c, bytes);
      canvas.triangle(a, c, d, bytes);
    }
  }
}

constexpr float kLeast = 1e-6f;  // 1/sr: the scale of a material that reflects nothing

struct MeasuredDot {
  double theta, phi;
  float value;
};

// An isotropic lobe is its own mirror image. Its dots are mirrored if most of them lie on the side that faces
// away from the eye.
std::vector<MeasuredDot> dots_of(const Material& material, const io::SampleTable* measured, double theta_i) {
  std::vector<MeasuredDot> dots;
  for (const LobePoint& p : measured ? points_of_light(*measured, theta_i) : std::vector<LobePoint>{}) {
    float value = 0;
    for (const std::vector<double>& channel : measured->values)
      value = std::max(value, float(channel[p.row]));
    dots.push_back({p.theta, p.phi, value});
  }
  double side = 0;
  for (const MeasuredDot& dot : dots) side += std::sin(degrees(dot.phi).radians());
  if (side > 0 && !is_anisotropic(material))
    for (MeasuredDot& dot : dots) dot.phi = -dot.phi;
  return dots;
}

}  // namespace

double largest_of_lobe(const Material& material, double theta_i_degrees, const io::SampleTable* measured) {
  float largest = kLeast;
  for (const MeasuredDot& dot : dots_of(material, measured, theta_i_degrees))
    largest = std::max(largest, dot.value);
  for (const glm::vec3& f : values_of(Lobe(material, theta_i_degrees)))
    largest = std::max(largest, largest_of(f));
  return double(largest);
}

io::Body lobe_to_turn(const Material& material, double theta_i_degrees, const io::SampleTable* measured,
                      double outer) {
  const auto bytes = [](ByteColor c) { return std::array<unsigned char, 3>{c[0], c[1], c[2]}; };
  io::Body body{.rings = kRings,
                .sectors = kTurnedSectors,
                .reach = kReach,
                .theta_i = theta_i_degrees,
                .dot_colour = bytes(kDots),
                .line_colours = {bytes(kLobeGrid), bytes(kLobeLight), bytes(kLobeWords)},
                .background = bytes(kBackground),
                .turn = kTurn.degrees(),
                .above = kAbove.degrees()};
  const Lobe lobe(material, theta_i_degrees);
  for (int ring = 0; ring < body.rings; ++ring)
    for (int sector = 0; sector < body.sectors; ++sector) {
      const glm::vec3 f = lobe.at(ring * kReach / (body.rings - 1), sector * 360.0 / body.sectors);
      const glm::vec3 color = surface_color(f);
      body.points.push_back({std::cbrt(largest_of(f) / outer),
                             {std::uint8_t(color.r), std::uint8_t(color.g), std::uint8_t(color.b)}});
    }
  for (const MeasuredDot& dot : dots_of(material, measured, theta_i_degrees))
    body.dots.push_back(
        {std::abs(dot.theta), dot.theta < 0 ? dot.phi + 180 : dot.phi, std::cbrt(double(dot.value) / outer)});
  return body;
}

BytePicture lobe_body_picture(const Material& material, const std::string& name, double theta_i_degrees,
                              const io::SampleTable* measured, int width, double outer, bool has_words) {
  const Lobe lobe(material, theta_i_degrees);
  float largest = kLeast;
  const std::vector<MeasuredDot> dots = dots_of(material, measured, theta_i_degrees);
  for (const MeasuredDot& dot : dots) largest = std::max(largest, dot.value);
  const Body body = body_of(lobe, largest, float(outer));
  const int pixels = std::clamp(width / 45, 9, 40);
  const Eye eye(kTurn, kAbove);
  const float scale = 0.45f * float(width);
  Canvas canvas(width, int(0.72f * float(width)) + (has_words ? 6 : 0) * pixels, eye,
                {float(width) / 2, 0.48f * float(width) + float(pixels)}, scale);
  fill(canvas.picture, {0, 0}, {width, canvas.picture.height}, kBackground);
  draw_ground(canvas);
  canvas.path({{0, 0, 0}, towards(theta_i_degrees, 180)}, 2, kLobeLight);
  canvas.path({{0, 0, 0}, towards(theta_i_degrees, 0)}, 1, kLobeWords);
  draw_body(canvas, body, eye);
  const float size = std::max(3.0f, float(pixels) / 3);
  for (const MeasuredDot& dot : dots)
    canvas.dot(std::cbrt(dot.value / largest) * towards(dot.theta, dot.phi), size, kDots);
  if (!has_words) return std::move(canvas.picture);
  float line = float(canvas.picture.height) - (dots.empty() ? 1.0f : 2.5f) * float(pixels);
  const auto text = [&](float left, const std::string& words, ByteColor color) {
    const float room = float(width) - left - float(pixels);
    draw_text(canvas.picture, {left, line}, elided(words, pixels, room), pixels, color);
  };
  const float left = float(pixels);
  line -= 1.5f * float(pixels);
  text(left, name + ", incidence " + io::short_number(theta_i_degrees, 3) + "°", kLobeLight);
  line += 1.5f * float(pixels);
  text(left, "radius: cube root of f_r; outer circle " + io::short_number(double(largest), 3) + " 1/sr",
       kLobeWords);
  if (dots.empty()) return std::move(canvas.picture);
  line += 1.5f * float(pixels);
  draw_dot(canvas.picture, {left + 0.3f * float(pixels), line - 0.35f * float(pixels)}, size, kDots);
  text(2.2f * left,
       "measured within " + io::short_number(kNearLight) + "° of this incidence, faint behind the lobe",
       kDots);
  return std::move(canvas.picture);
}

}  // namespace brdf::render
