// Meshes: closed surfaces with outward normals and sound frames, shapes, models from files, and limits.
#include "render/mesh/mesh.h"
#include "render/mesh/simplified.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>

#include "brdf/scalar.h"
#include "io/files/error.h"
#include "io/files/temporary.h"
#include "render/mesh/lathe.h"
#include "render/mesh/spline.h"

namespace brdf::render {
namespace {

// Area and outward volume. Both are wrong if a triangle is missing, doubled or reversed.
struct Measure {
  double area = 0, volume = 0;
};
Measure measure(const Mesh& mesh) {
  Measure m;
  for (std::size_t f = 0; f < mesh.indices.size(); f += 3) {
    const glm::dvec3 a(mesh.vertices[mesh.indices[f]].position),
        b(mesh.vertices[mesh.indices[f + 1]].position), c(mesh.vertices[mesh.indices[f + 2]].position);
    m.area += glm::length(glm::cross(b - a, c - a)) / 2;
    m.volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return m;
}

void expect_sound_frames(const Mesh& mesh) {
  for (const Vertex& v : mesh.vertices) {
    ASSERT_NEAR(glm::length(v.normal), 1, 1e-5);
    ASSERT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-5);
    ASSERT_EQ(std::abs(v.tangent.w), 1);
  }
}

std::filesystem::path write(const char* name, const std::string& text) {
  static const io::TemporaryFolder folder;
  const auto file = folder.path() / name;
  std::ofstream(file) << text;
  return file;
}

std::string message_of(const std::filesystem::path& file) {
  try {
    load_model(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

constexpr const char* kQuad =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
    "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n";

TEST(Mesh, SphereIsClosedAndApproachesTheTrueOne) {
  const Mesh sphere = make_sphere_of(kSphereTriangles);
  EXPECT_EQ(sphere.triangles(), 50176u);
  const Measure m = measure(sphere);
  const double volume = 4.0 / 3 * std::acos(-1.0);
  EXPECT_LT(1 - m.volume / volume, 1e-3);
  EXPECT_GT(1 - m.volume / volume, 1e-4);
  expect_sound_frames(sphere);
}

TEST(Mesh, IcosphereHasTwentyTimesFourToTheLevelTriangles) {
  for (int level = 0; level < 5; ++level) EXPECT_EQ(make_icosphere(level).triangles(), 20u << (2 * level));
  const Measure m = measure(make_icosphere(4));
  EXPECT_GT(m.volume, 0.99 * 4.0 / 3 * std::acos(-1.0));
  expect_sound_frames(make_icosphere(3));
}

TEST(Mesh, PlaneFacesUpAndItsTextureRunsAlongX) {
  const Mesh plane = make_plane(3);
  EXPECT_NEAR(measure(plane).area, 4, 1e-5);
  for (std::size_t f = 0; f < plane.indices.size(); f += 3) {
    const glm::vec3 a = plane.vertices[plane.indices[f]].position,
                    b = plane.vertices[plane.indices[f + 1]].position,
                    c = plane.vertices[plane.indices[f + 2]].position;
    EXPECT_GT(glm::cross(b - a, c - a).y, 0);
  }
}

TEST(Mesh, CarIsClosedAndItsNormalsPointOutwards) {
  const Mesh car = make_car();
  expect_sound_frames(car);
  EXPECT_GT(measure(car).volume, 3);
  std::size_t agreeing = 0;
  for (std::size_t f = 0; f < car.indices.size(); f += 3) {
    const Vertex &a = car.vertices[car.indices[f]], &b = car.vertices[car.indices[f + 1]],
                 &c = car.vertices[car.indices[f + 2]];
    if (glm::dot(glm::cross(b.position - a.position, c.position - a.position),
                 a.normal + b.normal + c.normal) > 0) {
      ++agreeing;
    }
  }
  EXPECT_GT(double(agreeing) / double(car.triangles()), 0.99);
}

TEST(Mesh, PartsMakeUpTheWhole) {
  std::size_t triangles = 0;
  double volume = 0;
  for (const char* part : {"car:body", "car:cabin", "car:wheels"}) {
    const Mesh mesh = make_mesh(part, ".");
    expect_sound_frames(mesh);
    triangles += mesh.triangles();
    volume += measure(mesh).volume;
  }
  EXPECT_EQ(triangles, make_mesh("car", ".").triangles());
  EXPECT_NEAR(volume, measure(make_mesh("car", ".")).volume, 1e-4);
  EXPECT_NEAR(measure(make_mesh("checker_even:5", ".")).area, 4 * 13.0 / 25, 1e-5);
  EXPECT_NEAR(measure(make_mesh("checker_odd:5", ".")).area, 4 * 12.0 / 25, 1e-5);
  EXPECT_THROW(make_mesh("car:engine", "."), InputError);
}

// Returns the number of triangles that face away from the normals of their corners.
std::size_t turned_round(const Mesh& mesh) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < mesh.indices.size(); f += 3) {
    const Vertex &a = mesh.vertices[mesh.indices[f]], &b = mesh.vertices[mesh.indices[f + 1]],
                 &c = mesh.vertices[mesh.indices[f + 2]];
    const glm::vec3 across = glm::cross(b.position - a.position, c.position - a.position);
    count += glm::dot(across, a.normal + b.normal + c.normal) < 0;
  }
  return count;
}

TEST(Mesh, ShapesToShowMaterialsOnHaveSoundFramesAndFaceOutwards) {
  for (const char* shape : {"shader_ball", "vase", "cloth", "sedan"}) {
    SCOPED_TRACE(shape);
    const Mesh mesh = make_mesh(shape, ".");
    expect_sound_frames(mesh);
    // The sedan's body has slivers across the upright ends of its arches, which are visible only from the
    // edge.
    EXPECT_LE(double(turned_round(mesh)), 0.01 * double(mesh.triangles()));
    if (std::string_view(shape) != "sedan") {
      EXPECT_EQ(turned_round(mesh), 0u);
    }
    EXPECT_GT(mesh.triangles(), 50000u);
  }
  // The groove is 12 % deep and 16 degrees of latitude wide, and removes 6 % of the ball's volume.
  const Measure ball = measure(make_shader_ball("ball"));
  EXPECT_NEAR(ball.volume / (4 * kPi / 3), 0.94, 0.02);
  // The wall of the vase is about 0.06 thick; its area counts two sides.
  const Measure vase = measure(make_vase());
  EXPECT_NEAR(vase.volume / (vase.area / 2), 0.06, 0.03);
  // A cloth keeps its size when it falls: both sides measure 4.2 by 4.2.
  EXPECT_NEAR(measure(make_cloth()).area / 2, 4.2 * 4.2, 0.08 * 4.2 * 4.2);
  for (const Vertex& v : make_cloth().vertices) EXPECT_GT(v.position.y, -0.76f);
  // The cloth is closed: its volume is its area times its thickness, independently of the origin.
  Mesh moved;
  append(moved, make_cloth(), glm::translate(glm::mat4(1), glm::vec3(5, 3, -4)));
  EXPECT_NEAR(measure(moved).volume, 0.008 * measure(moved).area / 2, 0.02 * 0.008 * 4.2 * 4.2);
}

TEST(Mesh, ASedansPartsMakeUpTheWhole) {
  std::size_t triangles = 0;
  for (const char* part : {"sedan:body", "sedan:windows", "sedan:trim", "sedan:metal", "sedan:lamps"})
    triangles += make_mesh(part, ".").triangles();
  EXPECT_EQ(triangles, make_mesh("sedan", ".").triangles());
  EXPECT_THROW(make_mesh("sedan:engine", "."), InputError);
  EXPECT_THROW(make_mesh("vase:2", "."), InputError);
}

TEST(Mesh, TheLatheKeepsFlatsFlatAndCornersSharp) {
  // A disc under a cylinder, with one sharp and one rounded corner.
  const Profile profile = filleted({{{0, 0}}, {{1, 0}}, {{1, 2}, 0.25f}, {{0, 2}}}, 16);
  const Mesh mesh = lathe(profile, 256);
  expect_sound_frames(mesh);
  EXPECT_EQ(turned_round(mesh), 0u);
  const double r = 0.25, rounded_off = 2 * kPi * ((1 - kPi / 4) * r * r) * (1 - 0.2234 * r);
  EXPECT_NEAR(measure(mesh).volume, 2 * kPi - rounded_off, 2e-3);
  for (const Vertex& v : mesh.vertices) {
    if (v.position.y == 0 && glm::length(v.position) < 0.99f) {
      EXPECT_FLOAT_EQ(v.normal.y, -1);
    }
    if (v.position.y > 0.01f && v.position.y < 1.7f) {
      EXPECT_NEAR(v.normal.y, 0, 1e-6);
    }
  }
  const auto at_the_corner = [&](glm::vec2 tangent) {
    return std::any_of(profile.begin(), profile.end(), [&](const ProfilePoint& p) {
      return p.at == glm::vec2(1, 0) && glm::distance(p.tangent, tangent) < 1e-6f;
    });
  };
  EXPECT_TRUE(at_the_corner({1, 0}) && at_the_corner({0, 1}));
}

TEST(Mesh, ASplineOfACircleIsRoundWithContinuousCurvature) {
  std::vector<glm::vec2> points;
  for (int k = 0; k <= 16; ++k) points.push_back({std::cos(k * kPi / 16), std::sin(k * kPi / 16)});
  const NaturalSpline<glm::vec2> curve(points);
  for (std::size_t k = 3; k + 3 < curve.pieces(); ++k) {  // away from its ends, which do not bend
    EXPECT_NEAR(glm::length(curve.at(k, 0.5f)), 1, 1e-4);
    const glm::vec2 before = curve.slope(k, 1) - curve.slope(k, 0.99f),
                    after = curve.slope(k + 1, 0.01f) - curve.slope(k + 1, 0);
    EXPECT_NEAR(glm::length(before) / glm::length(after), 1, 0.03);
  }
}

TEST(Mesh, AModelsSharpEdgesStaySharp) {
  const Mesh cube = load_model(BRDF_SOURCE_DIR "/data/scenes/models/cube.x");
  for (const Vertex& v : cube.vertices) {
    const glm::vec3 n = glm::abs(v.normal);
    EXPECT_NEAR(std::max({n.x, n.y, n.z}), 1, 1e-5);
  }
}

TEST(Mesh, TextLiesOnTheSphereAndFacesOutwards) {
  const Mesh text = make_text_sphere("BRDF");
  EXPECT_GT(text.triangles(), 200u);
  for (const Vertex& v : text.vertices) ASSERT_NEAR(glm::length(v.position), 1, 1e-5);
  EXPECT_GT(measure(text).volume, 0);
  // Letters with holes cover less than the filled outlines. The letters B, R and D have four holes.
  EXPECT_LT(measure(text).area, 1.6);
  EXPECT_GT(measure(text).area, 0.4);
  EXPECT_THROW(make_text_sphere("  "), InputError);
  EXPECT_THROW(make_text_sphere("\xff"), InputError);
}

TEST(Mesh, ModelKeepsMirroredHandedness) {
  const Mesh plain = load_model(write("quad.obj", kQuad));
  std::string mirrored = kQuad;
  for (const auto& [from, to] :
       {std::pair{"vt 0 0", "vt 1 0 "}, {"vt 1 0\nvt 1 1\nvt 0 1", "vt 0 0\nvt 0 1\nvt 1 1"}}) {
    mirrored.replace(mirrored.find(from), std::string(from).size(), to);
  }
  const Mesh turned = load_model(write("mirrored.obj", mirrored));
  for (const Vertex& v : plain.vertices) EXPECT_EQ(v.tangent.w, 1);
  for (const Vertex& v : turned.vertices) EXPECT_EQ(v.tangent.w, -1);
}

TEST(Mesh, ModelWithoutTextureCoordinatesGetsFramesFromItsNormals) {
  const Mesh mesh = load_model(write("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_EQ(mesh.triangles(), 1u);
  expect_sound_frames(mesh);
}

TEST(Mesh, BrokenModelsAreRefusedInOneLine) {
  EXPECT_NE(message_of("absent.obj").find("absent.obj: no such model file"), std::string::npos);
  EXPECT_NE(message_of(write("broken.obj", "this is no model")).find("broken.obj"), std::string::npos);
  EXPECT_NE(
      message_of(write("flat.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n")).find("no triangle with an area"),
      std::string::npos);
  for (const std::string end : {"", "end_header0\n"})
    EXPECT_NE(message_of(write("cut.ply",
                               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n" + end + "0\n"))
                  .find("cut.ply: the header of the PLY file has no line end_header"),
              std::string::npos);
  EXPECT_NE(message_of(write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).find("not finite"),
            std::string::npos);
}

TEST(Mesh, PointsAndLinesAreNotDrawn) {
  constexpr const char* kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\n";
  const std::string cloud =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
      "end_header\n0 0 0\n1 0 0\n";
  for (const auto& [name, text] : {std::pair{"lines.obj", kVertices + std::string("l 1 2\nl 2 3\n")},
                                   {"points.obj", kVertices + std::string("p 1 2 3\n")},
                                   {"cloud.ply", cloud}})
    EXPECT_NE(
        message_of(write(name, text)).find(std::string(name) + ": has no triangle with an area above 0"),
        std::string::npos)
        << name << ": " << message_of(write(name, text));
  const Mesh mixed = load_model(write("mixed.obj", kVertices + std::string("f 1 2 3\nl 1 4\np 4\n")));
  EXPECT_EQ(mixed.triangles(), 1u);
  EXPECT_EQ(mixed.vertices.size(), 3u);  // vertices that only a line or a point uses are dropped
  expect_sound_frames(mixed);
}

TEST(Mesh, TextsAreLimited) {
  EXPECT_GT(make_text_sphere(std::string(kMostLetters, 'B')).triangles(), kMostLetters);
  EXPECT_THROW(make_text_sphere(std::string(kMostLetters + 1, 'B')), InputError);
}

TEST(Mesh, TrianglesWithoutAreaAreDropped) {
  const Mesh mesh = load_model(write("sliver.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n"));
  EXPECT_EQ(mesh.triangles(), 1u);
}

TEST(Simplified, HasFewerTrianglesOnTheSameSurface) {
  const Mesh sphere = make_sphere_of(kSphereTriangles), coarse = simplified(sphere, 32);
  EXPECT_LT(coarse.triangles(), sphere.triangles() / 3);
  EXPECT_GT(coarse.triangles(), 1000u);
  EXPECT_TRUE(coarse.closed);
  double volume = 0;
  for (const Vertex& v : coarse.vertices) EXPECT_NEAR(glm::length(v.position), 1, 1e-5);
  for (std::size_t k = 0; k < coarse.indices.size(); k += 3) {
    const auto at = [&](std::size_t corner) { return coarse.vertices[coarse.indices[k + corner]].position; };
    volume += double(glm::dot(at(0), glm::cross(at(1), at(2)))) / 6;
  }
  EXPECT_NEAR(volume, 4 * kPi / 3, 0.03) << "the surface has gaps or is turned inside out";
}

TEST(Simplified, KeepsTheNormalsOfSharpEdgesAndMeshesThatWouldVanish) {
  Mesh roof;
  const glm::vec4 along(0, 0, 1, 1);
  for (const float side : {-1.0f, 1.0f})
    for (const glm::vec3& place : {glm::vec3(0, 1, 0), glm::vec3(0, 1, 2), glm::vec3(side * 2, 0, 1)})
      roof.vertices.push_back({place, glm::normalize(glm::vec3(side, 2, 0)), along, {0, 0}});
  roof.indices = {0, 1, 2, 3, 4, 5};
  const Mesh same = simplified(roof, 16);
  EXPECT_EQ(same.triangles(), 2u);
  EXPECT_EQ(same.vertices.size(), 6u);
  EXPECT_EQ(simplified(roof, 1).triangles(), 2u);
}

}  // namespace
}  // namespace brdf::render
