// The symmetries that a program shows. No symmetry is inferred from the names of the arguments.
#include <gtest/gtest.h>

#include "shader/symmetry.h"
#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

struct SymmetryCase {
  const char* body;
  bool isotropic, mirrored, reflects;
};

class Symmetries : public testing::TestWithParam<SymmetryCase> {};

TEST_P(Symmetries, AreShownFromTheProgram) {
  const auto& [body, isotropic, mirrored, reflects] = GetParam();
  const auto model = shader_of(
      std::string("//: param p 0 1 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) { ") + body + " }");
  const Symmetry& s = model->function().symmetry;
  EXPECT_EQ(s.isotropic, isotropic) << body;
  EXPECT_EQ(s.isotropic && s.mirrored, mirrored) << body;
  EXPECT_EQ(s.reflects, reflects) << body;
}

INSTANTIATE_TEST_SUITE_P(
    Bodies, Symmetries,
    testing::Values(
        SymmetryCase{"return p * (L.z + dot(L, V) + 1.0);", true, true, true},
        SymmetryCase{"return p * (L.z * V.z + L.y * V.y + V.x * L.x + 1.0);", true, true, true},
        SymmetryCase{"vec3 H = normalize(L + V); return p * pow(max(dot(N, H), 0.0), 20.0) * dot(H, V);",
                     true, true, true},
        SymmetryCase{"vec3 R = reflect(-L, N); return p * max(dot(R, V), 0.0);", true, true, true},
        SymmetryCase{"float x = L.x * V.y - L.y * V.x; return p * x * x;", true, true, true},
        SymmetryCase{"float x = L.x * V.y - L.y * V.x; return p * (1.0 + x);", true, false, false},
        SymmetryCase{"vec3 c = cross(L, V); return p * dot(c, c);", true, true, true},
        SymmetryCase{"vec3 H = L + V; if (p > 0.5) H = L - 0.5 * V; return p * dot(H, H);", true, true, true},
        SymmetryCase{
            "float s = 0.0; for (int k = 0; k < 4; ++k) s += float(k) * dot(L, V); return 1.0 + p * s * s;",
            true, true, true},
        // Functions that change when the directions turn about the normal.
        SymmetryCase{"return p * (1.0 + L.y);", false, false, false},
        SymmetryCase{"return p * L.x * L.x;", false, false, true},
        SymmetryCase{"return p * (L.x * V.x + 1.0001 * L.y * V.y + 1.0);", false, false, true},
        SymmetryCase{"return L.x * V.x > 0.1 ? p : 0.5 * p;", false, false, true},
        SymmetryCase{"return p * (1.0 + L.x * V.y);", false, false, false},
        SymmetryCase{"vec3 up = abs(N.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0); vec3 t = "
                     "normalize(cross(up, N)); "
                     "float a = dot(t, L); return p * a * a;",
                     false, false, true},
        // A product of terms from two iterations of a loop is not a product of terms from one.
        SymmetryCase{
            "float s = 0.0, x = 0.0; for (int k = 0; k < 4; ++k) { s += x; float w = 1.0 + float(k) * p; x "
            "= w * L.x * V.x; "
            "s += w * L.y * V.y; } return 5.0 + s;",
            false, false, true}));

}  // namespace
}  // namespace brdf::shader
