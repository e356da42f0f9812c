// Users' shaders on boxes: no value lies outside the enclosure, faults are refuted or remain open, and
// unknown facts are not claimed.
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <sstream>

#include "io/files/content.h"
#include "io/files/temporary.h"
#include "prove/shader/on_box.h"
#include "prove/shader/shader_proof.h"
#include "tests/prove/boxes.h"
#include "tests/shader/texts.h"
#include "texel/planes.h"

namespace brdf::prove {
namespace {

constexpr int kShaderBoxes = 300;

using shader::shader_of;

const std::string kBranches = R"(
//: param r 0.1 1 0.5
//: param tint 0 1 0.5
float brdf(vec3 L, vec3 V, vec3 N, float r, float tint) {
  float a = dot(N, L), b = dot(N, V), sum = 0.0;
  if (a < 0.3) sum += sqrt(0.3 - a);
  else if (b > 0.5 && a < 0.9) sum += log2(1.0 + b) * exp(-a / r);
  for (int k = 0; k < 4; ++k) {
    if (k == 2) continue;
    sum += float(k) * smoothstep(0.1, 0.9, a * b) + (k % 2 == 0 ? tint : -tint * 0.125);
  }
  float table[3] = float[3](0.25, 0.5, 1.0);
  vec3 H = normalize(L + V);
  float d = clamp(dot(H, N), 0.0, 1.0);
  return sum + table[int(2.9 * a)] * pow(d, 8.0 / r) + acos(d) + atan(L.y, L.x + 1.5) + fract(3.0 * b) + mix(a, b, tint) + step(0.4, a) + sin(a) * cos(3.0 * b) + mod(7.0 * a, 2.0);
}
)";
const std::string kWays = R"(
//: param shift 0 1 0.5
vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 colour, float shift) {
  float x = L.x * V.x + L.y * V.y + shift;
  float y = max(x, 0.25), z = min(abs(x), 2.0);
  if (!(x <= 0.1)) y = 1.0 / (x - 0.05);
  bool both = x > 0.2 || z < 0.4;
  vec3 w = both ? colour * colour : 1.0 - colour;
  return w * y + sign(x) + floor(2.0 * x) * z + inversesqrt(1.0 + z) + tanh(x) + exp2(-z);
}
)";

struct Counted {
  long points = 0, beyond = 0, finite_boxes = 0;
  std::string first;
};

// Returns whether direction_of() moved a component that was exactly 0. The direction is then in another box:
// the box on the axis holds the direction of the axis only.
template <class T>
bool is_next_to_axis(const Vec3<T>& w) {
  const auto moved = [](T c) { return c != 0 && std::abs(c) < std::numeric_limits<T>::min(); };
  return moved(w.x) || moved(w.y);
}

template <class T>
Counted sample(const std::string& text, int boxes, int points, const shader::ShaderChoice& choice = {}) {
  const auto model = shader_of(text, choice);
  const shader::Function& f = model->function();
  Domain domain;
  for (const shader::Parameter& p : f.parameters)
    for (int k = 0; k < (p.colour ? 3 : 1); ++k)
      domain.variables.push_back({p.name, p.min, p.max, Variable::Cut::middle});
  const std::size_t count = domain.variables.size();
  for (int k = 0; k < 2; ++k) {
    domain.variables.push_back({"cos", kLeastShaderCosine, 1, Variable::Cut::cosine});
    domain.variables.push_back({"turn", -2, 2, Variable::Cut::middle});
  }
  Engine e(11);
  Counted found;
  shader::Runner<T, 1> runner(f);
  for (int b = 0; b < boxes; ++b) {
    const Box box = random_box(e, domain);
    ShaderInputs in{
        {box.begin(), box.begin() + long(count)}, box[count], box[count + 1], box[count + 2], box[count + 3]};
    const Bounds bounds = shader_on_box<T>(f, in).value;
    if (!std::isfinite(bounds.lo)) continue;
    ++found.finite_boxes;
    for (int k = 0; k < points; ++k) {
      std::vector<T> values;
      std::vector<double> at;
      bool inside = true;
      for (std::size_t j = 0; j < box.size(); ++j) {
        at.push_back(anywhere(e, domain.variables[j], box[j]));
        if (j < count) {
          values.push_back(T(at.back()));
          inside = inside && box[j].lo <= double(values.back()) && double(values.back()) <= box[j].hi;
        }
      }
      if (!inside) continue;
      const Vec3<T> wi = direction_of<T>(e, at[count], at[count + 1]),
                    wo = direction_of<T>(e, at[count + 2], at[count + 3]);
      if (is_next_to_axis(wi) || is_next_to_axis(wo)) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const double value = double(shader::evaluate<T>(f, runner, values, wi, wo, c));
        ++found.points;
        if (bounds.lo <= value && value <= bounds.hi) continue;
        if (found.beyond++ > 0) continue;
        std::ostringstream out;
        out.precision(17);
        out << value << " outside " << bounds.lo << " .. " << bounds.hi << " in";
        for (std::size_t j = 0; j < box.size(); ++j)
          out << "\n  " << box[j].lo << " .. " << box[j].hi << " at " << at[j];
        found.first = out.str();
      }
    }
  }
  return found;
}

class ShaderBoxes : public testing::TestWithParam<std::string> {};

TEST_P(ShaderBoxes, HoldEveryValueInBothPrecisions) {
  const Counted in_float = sample<float>(GetParam(), kShaderBoxes, 20),
                in_double = sample<double>(GetParam(), kShaderBoxes, 20);
  for (const Counted& c : {in_float, in_double}) {
    EXPECT_EQ(c.beyond, 0) << c.beyond << " of " << c.points << "\n" << c.first;
    EXPECT_GT(c.finite_boxes, kShaderBoxes / 3);
  }
}

INSTANTIATE_TEST_SUITE_P(Texts, ShaderBoxes, testing::Values(kBranches, kWays, shader::kGgx));

// A read of a texture lies in the range of its texels, with every filter and wrap.
TEST(ShaderTextures, AreEnclosedByTheirTexels) {
  io::TemporaryFolder folder;
  const std::string file = (folder.path() / "a.exr").string();
  texel::write_planes(file, {3, 2, {"R"}, {{0.25f, -0.5f, 1, 0.125f, 3, 0.1f}}});
  const std::string text =
      "uniform sampler2D map;\n//: param u -3 3 0\n//: param v -1e-3 1 0\n"
      "float brdf(vec3 L, vec3 V, vec3 N, float u, float v) { return texture(map, vec2(u, v + L.x)).r; }";
  for (const std::string rules : {"", ":nearest", ":clamp", ":mirror", ":nearest:mirror"}) {
    const shader::ShaderChoice choice{.file = "", .textures = {shader::parse_texture("map=" + file + rules)}};
    for (const Counted& c :
         {sample<float>(text, kShaderBoxes, 20, choice), sample<double>(text, kShaderBoxes, 20, choice)}) {
      EXPECT_EQ(c.beyond, 0) << rules << c.beyond << " of " << c.points << "\n" << c.first;
      EXPECT_GT(c.finite_boxes, kShaderBoxes / 3) << rules;
    }
    const auto model = shader_of(text, choice);
    const ShaderInputs all{{{-3, 3}, {-1e-3, 1}}, {0.001, 1}, {-2, 2}, {0.001, 1}, {-2, 2}};
    const Bounds bounds = shader_on_box<double>(model->function(), all).value;
    EXPECT_NEAR(bounds.lo, -0.5, 1e-12) << rules;
    EXPECT_NEAR(bounds.hi, 3, 1e-12) << rules;
  }
}

// One function for each cosine that a parameter can ask for: of two of light, viewer, half vector, normal,
// tangent and bitangent.
std::vector<std::string> texts_of_cosines() {
  const std::string_view axes = "LVHNXY";
  std::vector<std::string> texts;
  for (const char a : axes)
    for (const char b : axes)
      if (a < b) {
        const std::string cosine{a, 'o', b};
        texts.push_back("float brdf(float " + cosine + ", vec3 L, vec3 V) { return " + cosine + "; }");
      }
  return texts;
}
INSTANTIATE_TEST_SUITE_P(Cosines, ShaderBoxes, testing::ValuesIn(texts_of_cosines()));

// One function for each coordinate of a vector that a parameter can ask for.
std::vector<std::string> texts_of_coordinates() {
  std::vector<std::string> texts;
  for (const std::string vector : {"L", "V", "H", "N"})
    for (const std::string coordinate : {".x", ".y", ".z"}) {
      texts.emplace_back("float brdf(vec3 L, vec3 V, vec3 H, vec3 N) { return ");
      texts.back() += vector + coordinate + "; }";
    }
  return texts;
}
INSTANTIATE_TEST_SUITE_P(Coordinates, ShaderBoxes, testing::ValuesIn(texts_of_coordinates()));

std::map<std::string, Proof> proofs_of(const std::string& text,
                                       std::vector<Property> properties = {
                                           Property::finite, Property::non_negative, Property::energy}) {
  const auto model = shader_of(text);
  Options options;
  options.search = {500, 5};
  options.properties = std::move(properties);
  std::map<std::string, Proof> found;
  for (Proof& p : prove(*model, model->material(model), " --shader x.glsl", options)) {
    const std::string scalar = p.claim.precision == Precision::float_type ? "float " : "";
    found[scalar + std::string(name_of(p.claim.property))] = std::move(p);
  }
  return found;
}

// A cosine of light, viewer or half vector with the tangent is negative for half of the directions, and the
// cosine of light and viewer for some. The others are at least 0.
TEST(ShaderProofs, OnlyCosinesThatCannotBeNegativeAreProvedNonNegative) {
  for (const std::string& text : texts_of_cosines()) {
    const std::string cosine = text.substr(text.find("return ") + 7, 3);
    const bool in_plane =
        cosine.find_first_of("XY") != cosine.npos && cosine.find('N') == cosine.npos && cosine != "XoY";
    const bool is_negative_somewhere = in_plane || cosine == "LoV";
    for (const auto& [name, p] : proofs_of(text, {Property::non_negative}))
      EXPECT_EQ(p.verdict == Verdict::proved, !is_negative_somewhere)
          << cosine << ' ' << name << ": " << p.statement;
  }
}

TEST(ShaderProofs, OfSoundShaders) {
  const auto ggx = proofs_of(io::read_content(BRDF_SOURCE_DIR "/data/shaders/sound.glsl").bytes,
                             {Property::finite, Property::non_negative});
  ASSERT_EQ(ggx.size(), 4u);
  for (const auto& [name, p] : ggx) EXPECT_EQ(p.verdict, Verdict::proved) << name << ": " << p.statement;
  const auto diffuse = proofs_of(R"(
//: param rho 0 1 0.5
float brdf(vec3 L, vec3 V, vec3 N, float rho) { return dot(N, L) > 0.5 ? rho / 3.141592653589793 : 0.25 * rho; })");
  EXPECT_EQ(diffuse.at("energy").verdict, Verdict::proved) << diffuse.at("energy").statement;
  EXPECT_GE(diffuse.at("energy").high, diffuse.at("energy").low - 1e-9);
  EXPECT_NEAR(diffuse.at("energy").high, 1, 1e-6);
}

TEST(ShaderProofs, FaultsAreRefutedOrStayOpen) {
  const auto of = [](const std::string& body) {
    return proofs_of("//: param r 0 1 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, float r) { " + body + " }");
  };
  const auto negative = of("return dot(N, L) - r;");
  ASSERT_EQ(negative.at("non_negative").verdict, Verdict::refuted);
  EXPECT_LT(negative.at("non_negative").witness->value, 0);
  EXPECT_EQ(negative.at("finite").verdict, Verdict::proved);
  EXPECT_EQ(of("return sqrt(dot(N, L) - r);").at("finite").verdict, Verdict::refuted);
  EXPECT_EQ(of("return log(r);").at("finite").verdict, Verdict::refuted);
  EXPECT_NE(of("return 1.0 / (r - 0.3);").at("finite").verdict, Verdict::proved);
  EXPECT_NE(of("return pow(dot(L, V), r);").at("finite").verdict, Verdict::proved);
  EXPECT_NE(of("return acos(1.001 * dot(N, L));").at("finite").verdict, Verdict::proved);
  EXPECT_NE(of("float x = r; for (int k = 0; k < 10; ++k) x = x * x + 1.0; return 1e-30 * exp(x);")
                .at("finite")
                .verdict,
            Verdict::proved);
  // dot(L, H) may round above 1, and pow of a negative number is NaN.
  EXPECT_NE(proofs_of(shader::kGgx, {Property::finite}).at("finite").verdict, Verdict::proved);
  // Numbers that an integer cannot hold are converted to the nearest integer that exists.
  EXPECT_NE(of("return 1.0 / float(uint(-1.25 - 0.5 * r));").at("finite").verdict, Verdict::proved);
  EXPECT_NE(of("return 1.0 / float(int(-3e9 - 1e9 * r) + 2147483647 + 1);").at("finite").verdict,
            Verdict::proved);
  const auto bright = of("return 0.32 * (1.0 + r);");
  ASSERT_EQ(bright.at("energy").verdict, Verdict::refuted);
  EXPECT_NEAR(bright.at("energy").witness->value, 0.64 * kPi, 1e-6);
  EXPECT_GE(bright.at("energy").high, bright.at("energy").low);
}

TEST(ShaderProofs, WhatIsNotKnownIsNotClaimed) {
  for (const char* body : {"return intBitsToFloat(floatBitsToInt(N.z) & 0x7fffffff);", "return sinh(N.z);"}) {
    const auto found = proofs_of(std::string("float brdf(vec3 L, vec3 V, vec3 N) { ") + body + " }");
    for (const auto& [name, p] : found) EXPECT_EQ(p.verdict, Verdict::no_method) << name << body;
  }
  for (const auto& [name, p] : proofs_of("float brdf(vec3 L, vec3 V, vec3 N) { return 0.1; }",
                                         {Property::reciprocity, Property::rounding}))
    EXPECT_EQ(p.verdict, Verdict::no_method) << name;
}

}  // namespace
}  // namespace brdf::prove
