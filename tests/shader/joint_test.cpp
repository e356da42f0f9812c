// Samplers and densities in the styles of published renderers: found, bound and evaluated.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "brdf/random.h"
#include "shader/joint.h"
#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

using testing::HasSubstr;

const Vec3<double> kViewer = direction(degrees(40), degrees(30));

// Draws, and returns the worst difference between the density that the sampler returns and the density of the
// file, and between the value and f cos, in relative terms.
struct Worst {
  double pdf = 0, value = 0;
  int drawn = 0;
};

Worst compared(const Function& f, std::size_t value, bool times_cosine) {
  const Joint& joint = *f.joint;
  const std::vector<double> values = f.defaults();
  Random random(3);
  std::vector<double> u(64 * joint.randoms());
  for (double& x : u) x = random.uniform();
  std::vector<Draw> draws(64);
  joint.draw(values, kViewer, u, false, draws);
  Runner<double, 1> runner(f);
  Worst worst;
  for (const Draw& draw : draws) {
    if (!draw.valid || !(draw.pdf > 0) || draw.wi.z < 1e-3) continue;
    ++worst.drawn;
    double pdf = 0;
    joint.density(values, kViewer, std::span(&draw.wi, 1), false, std::span(&pdf, 1));
    worst.pdf = std::max(worst.pdf, std::abs(draw.pdf / pdf - 1));
    const double expected = evaluate<double>(f, runner, values, draw.wi, kViewer, 0) *
                            (times_cosine ? draw.wi.z : 1) /
                            (joint.values()[value].kind == SampleValue::weight ? draw.pdf : 1);
    worst.value = std::max(worst.value, std::abs(draw.values[value][0] / expected - 1));
  }
  return worst;
}

void expect_consistent(const Function& f, std::size_t value = 0, bool times_cosine = true) {
  ASSERT_TRUE(f.joint);
  EXPECT_THAT(f.joint->missing(), testing::IsEmpty());
  ASSERT_TRUE(f.joint->has_sampler());
  ASSERT_TRUE(f.joint->has_density());
  const Worst worst = compared(f, value, times_cosine);
  EXPECT_GT(worst.drawn, 40);
  EXPECT_LT(worst.pdf, 1e-10);
  EXPECT_LT(worst.value, 1e-6);  // the compiler folds quotients of constants to floats
}

Function function_in(const std::string& text, const std::string& name = "test.glsl",
                     const ShaderChoice& choice = {}) {
  return make_function(parse_source(name, text), choice);
}

const char* const kPlain = R"(
//: param albedo 0 1 0.7
const float kPi = 3.14159265358979;
float brdf(vec3 L, vec3 V, vec3 N, float albedo) { return albedo / kPi; }
float brdfPdf(vec3 L, vec3 V, vec3 N, float albedo) { return max(L.z, 0.0) / kPi; }
float brdfSample(vec2 u, vec3 V, vec3 N, float albedo, out vec3 L, out float pdf) {
  float r = sqrt(u.x), phi = 2.0 * kPi * u.y;
  L = vec3(r * cos(phi), r * sin(phi), sqrt(max(1.0 - u.x, 0.0)));
  pdf = L.z / kPi;
  return albedo / kPi;
}
)";

TEST(Joint, ArgumentsAreRandomNumbers) {
  const Function f = function_in(kPlain);
  expect_consistent(f, 0, false);
  EXPECT_EQ(f.joint->randoms(), 2u);
  EXPECT_EQ(f.joint->sampler_name(), "brdfSample");
  EXPECT_EQ(f.joint->density_name(), "brdfPdf");
}

// The shape of GLSL-PathTracer: a global generator, a State, f cos and pdf from eval.
TEST(Joint, AGlobalGeneratorIsReplaced) {
  const Function f = function_in(R"(
struct Mat { vec3 base; float rough; };
struct State { float eta; Mat mat; };
uvec4 seed;
void pcg(inout uvec4 v) { v = v * 1664525u + 1013904223u; v.x += v.y * v.w; }
float rand() { pcg(seed); return float(seed.x) / 4294967295.0; }
vec3 CosineSampleHemisphere(float r1, float r2) {
  float r = sqrt(r1), phi = 6.28318530717959 * r2;
  return vec3(r * cos(phi), r * sin(phi), sqrt(max(0.0, 1.0 - r1)));
}
//: param rough 0.1 1 0.5
//: returns f*cos_i
vec3 DisneyEval(State state, vec3 V, vec3 N, vec3 L, out float pdf) {
  pdf = 0.0;
  if (L.z <= 0.0) return vec3(0.0);
  vec3 H = normalize(L + V);
  float n = 2.0 / state.mat.rough, lobe = (n + 1.0) * pow(H.z, n) / 6.28318530717959;
  pdf = 0.5 * L.z / 3.14159265358979 + 0.5 * lobe / (4.0 * dot(V, H));
  return state.mat.base * (0.5 / 3.14159265358979 + 0.1 * lobe) * L.z;
}
vec3 DisneySample(State state, vec3 V, vec3 N, out vec3 L, out float pdf) {
  float r1 = rand(), r2 = rand();
  if (rand() < 0.5) {
    L = CosineSampleHemisphere(r1, r2);
  } else {
    float n = 2.0 / state.mat.rough, c = pow(1.0 - r1, 1.0 / (n + 1.0)), s = sqrt(1.0 - c * c);
    float phi = 6.28318530717959 * r2;
    vec3 H = vec3(s * cos(phi), s * sin(phi), c);
    L = reflect(-V, H);
  }
  return DisneyEval(state, V, N, L, pdf);
}
)");
  expect_consistent(f);
  EXPECT_TRUE(f.joint->generated());
  EXPECT_EQ(f.joint->density_name(), "DisneyEval");
}

// The shape of Falcor: wi is the viewer, wo is sampled, the generator is an object.
TEST(Joint, TheDirectionThatIsWrittenIsTheLight) {
  const Function f = function_in(R"(
struct SampleGenerator { uint state; };
uint next(inout SampleGenerator sg) { sg.state = sg.state * 747796405u + 2891336453u; return sg.state; }
float sampleNext1D(inout SampleGenerator sg) { return float(next(sg)) * 2.3283064365386963e-10; }
float2 sampleNext2D(inout SampleGenerator sg) {
  float2 u;
  u.x = sampleNext1D(sg);
  u.y = sampleNext1D(sg);
  return u;
}
float3 evalBsdf(float3 wi, float3 wo, float3 albedo) {
  return albedo / 3.14159265 * wo.z * (0.5 + 0.5 * wi.z);
}
float evalBsdfPdf(float3 wi, float3 wo) { return max(wo.z, 0) / 3.14159265; }
bool sampleBsdf(float3 wi, out float3 wo, out float pdf, out float3 weight, out uint lobe,
                inout SampleGenerator sg, float3 albedo) {
  float2 u = sampleNext2D(sg);
  float r = sqrt(u.x), phi = 6.2831853 * u.y;
  wo = float3(r * cos(phi), r * sin(phi), sqrt(1 - u.x));
  pdf = wo.z / 3.14159265;
  weight = albedo * (0.5 + 0.5 * wi.z);
  lobe = 1;
  return true;
}
)",
                                 "falcor.hlsl", {.file = "", .returns = "f*cos_i"});
  EXPECT_TRUE(f.exchanged);
  EXPECT_EQ(f.joint->values()[0].kind, SampleValue::weight);
  expect_consistent(f);
  EXPECT_EQ(f.joint->values().size(), 1u);
}

constexpr const char* kNamelessDirection = R"(
vec3 bsdf(vec3 wi, vec3 wo, float albedo) { return vec3(albedo / 3.14159265 * (0.5 + 0.5 * wi.z)); }
float bsdfPdf(vec3 wi, vec3 wo) { return max(wo.z, 0.0) / 3.14159265; }
vec3 sampleBsdf(vec3 wi, vec2 u) {
  float r = sqrt(u.x), phi = 6.2831853 * u.y;
  return vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.x));
}
)";

// The ray that comes in is the viewer's, and the direction that is returned has no name.
TEST(Joint, ASamplerThatTakesTheIncomingRayAloneTakesTheViewer) {
  const Function f = function_in(kNamelessDirection, "incoming.glsl");
  EXPECT_TRUE(f.exchanged);
  EXPECT_EQ(f.joint->viewer_name(), "wi");
  ASSERT_TRUE(f.joint->has_density());
  const Vec3<double> light{0.6, 0, 0.8};
  double pdf = 0;
  f.joint->density(f.defaults(), kViewer, std::span(&light, 1), false, std::span(&pdf, 1));
  EXPECT_NEAR(pdf, 0.8 / 3.14159265, 1e-8);  // a quotient of constants is folded to float
}

TEST(Joint, ASamplerThatTakesTheLightAloneKeepsItsNames) {
  std::string text = kNamelessDirection;
  for (std::size_t at; (at = text.find("wi")) != text.npos;) text.replace(at, 2, "L");
  EXPECT_FALSE(function_in(text, "from_light.glsl").exchanged);
  const Function declared =
      function_in("//: sample sampleBsdf(V, u)\n" + std::string(kNamelessDirection), "declared.glsl");
  EXPECT_FALSE(declared.exchanged);
}

// The shape of kajiya: a struct is returned, the density is per projected solid angle.
TEST(Joint, AStructMayHoldTheDirection) {
  const Function f = function_in(R"(
struct BrdfSample { float3 value; float3 value_over_pdf; float pdf; float3 wi; bool is_valid; };
static const float PI_ = 3.14159265;
//: pdf per projected
float3 evaluate(float3 wo, float3 wi, float3 albedo) { return albedo / PI_; }
float pdf(float3 wo, float3 wi) { return 1.0 / PI_; }
BrdfSample sample_brdf(float3 wo, float2 urand, float3 albedo) {
  BrdfSample s;
  float r = sqrt(urand.x), phi = 2 * PI_ * urand.y;
  s.wi = float3(r * cos(phi), r * sin(phi), sqrt(1 - urand.x));
  s.pdf = 1.0 / PI_;
  s.value = albedo / PI_;
  s.value_over_pdf = albedo;
  s.is_valid = s.wi.z > 1e-6;
  return s;
}
)",
                                 "kajiya.hlsl");
  expect_consistent(f, 0, false);
  ASSERT_EQ(f.joint->values().size(), 2u);
  EXPECT_EQ(f.joint->values()[1].kind, SampleValue::weight);
  expect_consistent(f, 1, true);
}

TEST(Joint, AStateThatIsAnArgumentIsReplaced) {
  std::string text = kPlain;
  const auto swap = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  swap("brdfSample(vec2 u, ", "brdfSample(inout uint seed, ");
  swap("  float r = sqrt(u.x)", "  vec2 u = vec2(uniform01(seed), uniform01(seed));\n  float r = sqrt(u.x)");
  swap("const float kPi",
       "float uniform01(inout uint s) { s = s * 747796405u + 1u; return float(s >> 8u) / "
       "16777216.0; }\nconst float kPi");
  const Function f = function_in(text);
  expect_consistent(f, 0, false);
  std::vector<Draw> draws(1);
  std::vector<double> u(f.joint->randoms(), 0.25);
  f.joint->draw(f.defaults(), kViewer, u, false, draws);
  EXPECT_EQ(draws[0].used, 2u);
  EXPECT_NEAR(draws[0].wi.y, 0.5, 1e-12);
}

TEST(Joint, LinesOfTheFileNameTheFunctions) {
  std::string text = kPlain;
  const auto rename = [&](const std::string& from, const std::string& to) {
    for (std::size_t at; (at = text.find(from)) != text.npos;) text.replace(at, from.size(), to);
  };
  rename("brdfSample", "chooseLight");
  rename("brdfPdf", "likelihood");
  EXPECT_FALSE(function_in(text).joint);
  const Function f = function_in("//: sample chooseLight\n//: pdf likelihood\n//: sample returns f\n" + text);
  expect_consistent(f, 0, false);
  EXPECT_EQ(f.joint->values()[0].kind, SampleValue::f);
  const Function g =
      function_in(text, "test.glsl", {.file = "", .sample = "chooseLight", .pdf = "likelihood"});
  expect_consistent(g, 0, false);
  EXPECT_THAT(refusal("//: sample missing\n" + text), HasSubstr("has no such function"));
  EXPECT_THAT(refusal("//: sample likelihood\n" + text), HasSubstr("returns no direction"));
  EXPECT_THAT(refusal("//: sample returns light\n" + text),
              HasSubstr("must be one of f, f*cos_i, f*cos_i/pdf"));
}

TEST(Joint, AnUnknownArgumentIsReported) {
  std::string text = kPlain;
  const std::string from = "brdfSample(vec2 u, vec3 V, vec3 N, float albedo";
  text.replace(text.find(from), from.size(), from + ", float share");
  const std::string used = "pdf = L.z / kPi;";
  text.replace(text.find(used), used.size(), "pdf = share * L.z / kPi;");
  const Function f = function_in(text);
  ASSERT_TRUE(f.joint);
  EXPECT_FALSE(f.joint->has_sampler());
  EXPECT_THAT(f.joint->missing(), testing::ElementsAre(HasSubstr("share is not among the arguments")));
  const Function g = function_in("//: param share 0 1 0.5\n" + text);
  EXPECT_TRUE(g.joint->has_sampler());
}

std::string with_names(const std::string& eval, const std::string& sample, const std::string& pdf) {
  std::string text = kPlain;
  for (const auto& [from, to] : {std::pair{std::string("float brdf("), "float " + eval + "("},
                                 {"float brdfSample(", "float " + sample + "("},
                                 {"float brdfPdf(", "float " + pdf + "("}})
    text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(Joint, NamesOfOtherStyles) {
  expect_consistent(function_in(with_names("f_diffuse", "Sample_diffuse", "Pdf_diffuse")), 0, false);
  expect_consistent(function_in(with_names("fDiffuse", "generateDiffuse", "pdfDiffuse")), 0, false);
  std::string text = kPlain;
  for (const auto& [from, to] : {std::pair{std::string("vec2 u,"), "vec2 sample2,"},
                                 {"sqrt(u.x)", "sqrt(sample2.x)"},
                                 {"* u.y", "* sample2.y"},
                                 {"- u.x", "- sample2.x"}})
    text.replace(text.find(from), from.size(), to);
  expect_consistent(function_in(text), 0, false);
}

TEST(Joint, OnePairOfALobeServesAReflectanceWithoutAStem) {
  const std::string text = with_names("brdf", "sampleCosine", "pdfCosine");
  expect_consistent(function_in(text), 0, false);
  // Two pairs, and a pair of another lobe than that of the reflectance, are not taken.
  const std::string second = text.substr(text.find("float pdfCosine"));
  std::string other = second;
  for (std::size_t at; (at = other.find("Cosine")) != other.npos;) other.replace(at, 6, "Second");
  const Function two = function_in(text + other);
  EXPECT_FALSE(two.joint && two.joint->has_sampler());
  const Function apart = function_in(with_names("evalSpecular", "sampleCosine", "pdfCosine"));
  EXPECT_FALSE(apart.joint && apart.joint->has_sampler());
}

TEST(Joint, TheSamplerMayCallTheReflectance) {
  const Function f = function_in(R"(
//: param albedo 0 1 0.7
float lobeEval(vec3 L, vec3 V, float albedo, out float pdf) { pdf = max(L.z, 0.0); return albedo * 0.3; }
float DisneyEval(vec3 L, vec3 V, float albedo, out float pdf) { return lobeEval(L, V, albedo, pdf); }
float DisneySample(vec2 u, vec3 V, float albedo, out vec3 L, out float pdf) {
  L = normalize(vec3(u, 1.0));
  return DisneyEval(L, V, albedo, pdf);
}
)");
  EXPECT_THAT(f.entry, HasSubstr("DisneyEval"));
  ASSERT_TRUE(f.joint);
  EXPECT_TRUE(f.joint->has_sampler());
}

TEST(Joint, TheDensityOfTheWholeComesBeforeThoseOfLobes) {
  const Function f = function_in(R"(
//: param albedo 0 1 0.7
struct Record { float specularPdf; float pdf; vec3 direction; };
float brdf(vec3 L, vec3 V, float albedo) { return albedo * 0.3; }
float brdfPdf(vec3 L, vec3 V, float albedo) { return 0.25; }
Record brdfSample(vec2 u, vec3 V, float albedo) {
  return Record(0.0, 0.25, normalize(vec3(u, 1.0)));
}
)");
  ASSERT_TRUE(f.joint);
  EXPECT_EQ(f.joint->pdf_name(), "pdf");
}

TEST(Joint, HelpersAreNotTakenForTheSampler) {
  EXPECT_FALSE(function_in(R"(
vec3 sampleDisk(vec2 u) { return vec3(u, 0.0); }
float distributionPdf(float NdotH) { return NdotH; }
float brdf(vec3 L, vec3 V) { return 0.3 + 0.0 * sampleDisk(L.xy).x * distributionPdf(V.z); }
)")
                   .joint);
}

}  // namespace
}  // namespace brdf::shader
