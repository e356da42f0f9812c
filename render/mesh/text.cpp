#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include <GL/glu.h>

#include <array>
#include <cmath>
#include <deque>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "brdf/scalar.h"
#include "io/files/error.h"
#include "render/mesh/mesh.h"
#include "render/text/font.h"

namespace brdf::render {
namespace {

constexpr int kCurveSegments = 8;   // straight pieces per Bezier curve
constexpr float kLatitude = 0.75f;  // radians that the em height covers on the sphere
// Radians; longer triangles are halved so that the letters follow the sphere.
constexpr float kLongestEdge = 0.06f;

using Contour = std::vector<glm::dvec2>;

struct Outline {
  std::vector<Contour> contours;
  glm::dvec2 pen{0, 0};
  glm::dvec2 offset{0, 0};
};

glm::dvec2 point(const FT_Vector& v) {
  return {double(v.x), double(v.y)};
}

int move_to(const FT_Vector* to, void* user) {
  auto& out = *static_cast<Outline*>(user);
  out.contours.emplace_back();
  out.pen = point(*to);
  out.contours.back().push_back(out.pen + out.offset);
  return 0;
}

int line_to(const FT_Vector* to, void* user) {
  auto& out = *static_cast<Outline*>(user);
  out.pen = point(*to);
  out.contours.back().push_back(out.pen + out.offset);
  return 0;
}

int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
  auto& out = *static_cast<Outline*>(user);
  const glm::dvec2 a = out.pen, b = point(*control), c = point(*to);
  for (int i = 1; i <= kCurveSegments; ++i) {
    const double t = double(i) / kCurveSegments, s = 1 - t;
    out.contours.back().push_back(a * (s * s) + b * (2 * s * t) + c * (t * t) + out.offset);
  }
  out.pen = c;
  return 0;
}

int cubic_to(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* user) {
  auto& out = *static_cast<Outline*>(user);
  const glm::dvec2 a = out.pen, b = point(*first), c = point(*second), d = point(*to);
  for (int i = 1; i <= kCurveSegments; ++i) {
    const double t = double(i) / kCurveSegments, s = 1 - t;
    out.contours.back().push_back(a * (s * s * s) + b * (3 * s * s * t) + c * (3 * s * t * t) +
                                  d * (t * t * t) + out.offset);
  }
  out.pen = d;
  return 0;
}

// Returns the outlines of the whole text in units of the em, and its width.
std::pair<std::vector<Contour>, double> text_outlines(std::string_view text,
                                                      const std::filesystem::path& font) {
  const Font opened(font);
  FT_Face face = opened.face();
  FT_Outline_Funcs functions{move_to, line_to, conic_to, cubic_to, 0, 0};
  Outline outline;
  for (const char32_t code : code_points(text)) {
    if (FT_Load_Char(face, code, FT_LOAD_NO_SCALE)) continue;
    FT_Outline_Decompose(&face->glyph->outline, &functions, &outline);
    outline.offset.x += double(face->glyph->advance.x);
  }
  const double em = face->units_per_EM;
  for (Contour& contour : outline.contours)
    for (glm::dvec2& p : contour) p /= em;
  return {std::move(outline.contours), outline.offset.x / em};
}

using Triangles = std::vector<std::array<glm::dvec2, 3>>;

struct Tessellation {
  Triangles triangles;
  std::vector<glm::dvec2> corners;       // of the triangle being assembled
  std::deque<glm::dvec3> intersections;  // a deque: the tessellator keeps pointers into it
};

void GLAPIENTRY on_vertex(void* vertex, void* user) {
  auto& out = *static_cast<Tessellation*>(user);
  out.corners.push_back(glm::dvec2(*static_cast<glm::dvec3*>(vertex)));
  if (out.corners.size() < 3) return;
  out.triangles.push_back({out.corners[0], out.corners[1], out.corners[2]});
  out.corners.clear();
}
// The presence of this callback makes GLU emit only separate triangles.
void GLAPIENTRY on_edge_flag(GLboolean, void*) {}
void GLAPIENTRY on_combine(GLdouble coordinates[3], void* [4], GLfloat[4], void** out_vertex, void* user) {
  auto& out = *static_cast<Tessellation*>(user);
  out.intersections.emplace_back(coordinates[0], coordinates[1], coordinates[2]);
  *out_vertex = &out.intersections.back();
}
using GluCallback = void(GLAPIENTRY*)();

Triangles tessellated(const std::vector<Contour>& contours) {
  const std::unique_ptr<GLUtesselator, void (*)(GLUtesselator*)> tessellator(gluNewTess(), gluDeleteTess);
  gluTessCallback(tessellator.get(), GLU_TESS_VERTEX_DATA, reinterpret_cast<GluCallback>(on_vertex));
  gluTessCallback(tessellator.get(), GLU_TESS_EDGE_FLAG_DATA, reinterpret_cast<GluCallback>(on_edge_flag));
  gluTessCallback(tessellator.get(), GLU_TESS_COMBINE_DATA, reinterpret_cast<GluCallback>(on_combine));
  gluTessProperty(tessellator.get(), GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_NONZERO);
  gluTessNormal(tessellator.get(), 0, 0, 1);
  Tessellation out;
  std::deque<glm::dvec3> points;
  gluTessBeginPolygon(tessellator.get(), &out);
  for (const Contour& contour : contours) {
    gluTessBeginContour(tessellator.get());
    for (const glm::dvec2& p : contour) {
      points.emplace_back(p, 0.0);
      gluTessVertex(tessellator.get(), &points.back().x, &points.back());
    }
    gluTessEndContour(tessellator.get());
  }
  gluTessEndPolygon(tessellator.get());
  return std::move(out.triangles);
}

// Halves the longest edge until each edge is short. Neighbours halve a shared edge at the same point, so
// that no gap opens.
void add_refined(std::array<glm::dvec2, 3> t, Triangles& out) {
  int longest = 0;
  for (int e = 1; e < 3; ++e)
    if (glm::distance(t[e], t[(e + 1) % 3]) > glm::distance(t[longest], t[(longest + 1) % 3])) longest = e;
  const glm::dvec2 a = t[longest], b = t[(longest + 1) % 3], c = t[(longest + 2) % 3];
  if (glm::distance(a, b) <= kLongestEdge) {
    out.push_back(t);
    return;
  }
  const glm::dvec2 middle = (a + b) / 2.0;
  add_refined({a, middle, c}, out);
  add_refined({middle, b, c}, out);
}

}  // namespace

Mesh make_text_sphere(std::string_view text, const std::filesystem::path& font) {
  if (const std::size_t letters = code_points(text).size(); letters > kMostLetters)
    throw InputError("text mesh: " + std::to_string(letters) + " letters; at most " +
                     std::to_string(kMostLetters) + " are drawn");
  auto [contours, width] = text_outlines(text, font.empty() ? Font::bold() : font);
  if (contours.empty()) throw InputError("text mesh: \"" + std::string(text) + "\" has no visible letter");
  // The longitude is proportional to x, and the text goes round at most once; the middle of the capitals
  // lies on the equator.
  const double scale = std::min(double(kLatitude), 2 * kPi / width);
  for (Contour& contour : contours)
    for (glm::dvec2& p : contour) p = (p - glm::dvec2(width / 2, 0.36)) * scale;
  Triangles fine;
  for (const auto& triangle : tessellated(contours)) add_refined(triangle, fine);
  Mesh mesh;
  for (const auto& triangle : fine) {
    for (const glm::dvec2& p : triangle) {
      const glm::dvec3 n(std::sin(p.x) * std::cos(p.y), std::sin(p.y), std::cos(p.x) * std::cos(p.y));
      const glm::dvec3 t(std::cos(p.x), 0, -std::sin(p.x));
      mesh.indices.push_back(std::uint32_t(mesh.vertices.size()));
      mesh.vertices.push_back({glm::vec3(n),
                               glm::vec3(n),
                               glm::vec4(glm::vec3(t), 1),
                               {float(p.x / (width * scale) + 0.5), float(p.y / scale + 0.36)}});
    }
  }
  clean(mesh, "text mesh");
  return mesh;
}

}  // namespace brdf::render
