// A shader with eval, sample and pdf, and copies of it with one fault each: the checks that can see the fault
// fail, with its name, and the others pass. The same functions in HLSL give the same findings. ./test judges
// every third copy, ./test --full all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "cli/options/shader_options.h"
#include "io/files/content.h"
#include "io/files/temporary.h"
#include "tests/thorough.h"
#include "validate/joint/judge_sampler.h"

#ifdef BRDF_HAS_SHADER
namespace brdf::cli {
namespace {

using testing::Contains;
using testing::HasSubstr;
using validate::Finding;

const std::string kSound = io::read_content(BRDF_SOURCE_DIR "/tests/cli/samplers/coloured.glsl").bytes;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

using Findings = std::map<std::string, Finding>;

Findings judged(const std::string& text, std::uint64_t seed = 1, const std::string& suffix = ".glsl") {
  const io::TemporaryFolder folder;
  ShaderOptions options;
  options.file = (folder.path() / ("test" + suffix)).string();
  std::ofstream(options.file) << text;
  const auto shader = load(options, "validate", true);
  validate::OutsideFacts facts;
  facts.words = shader->words;
  const validate::Subject subject = validate::Subject::outside("test", shader->material, facts);
  validate::CheckOptions how;
  how.seed = seed;
  Findings out;
  if (!shader->sampler) return out;
  std::vector<Finding> findings = validate::judge_sampler(subject, *shader->sampler, how, 1 << 16);
  for (std::size_t k = 0; k < findings.size(); ++k)
    out[std::string(validate::kSamplerChecks[k])] = findings[k];
  return out;
}

std::vector<std::string> failed(const Findings& findings) {
  std::vector<std::string> out;
  for (const auto& [name, finding] : findings)
    if (finding.outcome == validate::Outcome::fail) out.push_back(name);
  return out;
}

void expect_passes(const Findings& findings) {
  EXPECT_EQ(findings.size(), std::size(validate::kSamplerChecks));
  for (const auto& [name, finding] : findings)
    EXPECT_EQ(finding.outcome, validate::Outcome::pass) << name << ": " << finding.statement;
}

TEST(SampledShader, TheSoundOnePasses) {
  for (const std::uint64_t seed : {1, 7})
    if (seed == 1 || thorough()) expect_passes(judged(kSound, seed));
}

TEST(SampledShader, TheSameInHlsl) {
  std::string text = kSound;
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"vec3", "float3"},
                                 {"const float kPi", "static const float kPi"},
                                 {"return float3(0.0)", "return 0.0.xxx"},
                                 {"float3(spec * dis", "(float3)(spec * dis"}})
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
      text.replace(at, from.size(), to);
  expect_passes(judged(text, 1, ".hlsl"));
  const Findings found = judged(replaced(text, "H.z / (4.0 * dot(V, H))", "H.z"), 1, ".hlsl");
  EXPECT_THAT(failed(found), testing::IsSupersetOf({"density_mass", "jacobian"}));
}

struct Mutation {
  const char *name, *from, *to;
  std::vector<std::string> checks;  // that fail, perhaps among others
  const char* word;                 // in the statement of the first
};

TEST(SampledShader, EveryMutationIsFound) {
  const Mutation mutations[] = {
      {"1 % in a quarter",
       "return p * lobe + (1.0 - p) * L.z / kPi;",
       "return (p * lobe + (1.0 - p) * L.z / kPi) * (L.x > 0.0 && L.y > 0.0 ? 1.01 : 1.0);",
       {"jacobian"},
       "differs from the density"},
      {"weight without its cosine", "* L.z / pdf;", "/ pdf;", {"sample_value", "sample_mean"}, "is not"},
      {"shares exchanged in the density",
       "return p * lobe + (1.0 - p)",
       "return (1.0 - p) * lobe + p",
       {"jacobian", "sample_mean", "sample_distribution"},
       "differs from the density"},
      {"no Jacobian", "H.z / (4.0 * dot(V, H))", "H.z", {"density_mass", "jacobian"}, "integrates to"},
      {"normals by D alone",
       "distribution(H, ax, ay) * H.z / (4.0",
       "distribution(H, ax, ay) / (4.0",
       {"density_mass", "jacobian"},
       "integrates to"},
      {"widths exchanged in the sampler",
       "vec3(ax * r * cos(phi), ay * r",
       "vec3(ay * r * cos(phi), ax * r",
       {"jacobian", "sample_distribution"},
       "differs from the density"},
      {"the choosing number used again",
       "float r = sqrt(u.x /",
       "u.x = u.z; float r = sqrt(u.x /",
       {"sample_distribution", "sample_mean"},
       "do not follow"},
      {"divided by the density of one lobe",
       "pdf = brdfPdf(L, V, N, X, base, spec, ax, ay);\n",
       "pdf = u.z < p ? p * distribution(normalize(L + V), ax, ay) : (1.0 - p) * L.z / kPi;\n",
       {"density_match"},
       "differ at"},
      {"samples below the horizon keep a density",
       "if (L.z <= 0.0) return vec3(0.0);\n  pdf =",
       "if (L.z <= 0.0) { pdf = 0.1; return vec3(0.0); }\n  pdf =",
       {"sample_range"},
       "below the horizon"},
      {"chosen by the mean, counted by the brightest",
       "if (u.z < p) {",
       "if (u.z < spec / (spec + (base.x + base.y + base.z) / 3.0)) {",
       {"jacobian", "sample_mean"},
       "differs from the density"},
      {"the half vector is not normalised",
       "vec3 H = normalize(vec3(ax * r",
       "vec3 H = (vec3(ax * r",
       {"sample_range"},
       "length"},
      {"half of the azimuth",
       "phi = 2.0 * kPi * u.y",
       "phi = kPi * u.y",
       {"sample_distribution", "jacobian", "sample_mean"},
       "do not follow"},
      {"infinite at 0",
       "float r = sqrt(u.x / max(1.0 - u.x, 1e-7));",
       "float r = 1.0 / sqrt(1.0 / u.x - 1.0) + 0.0 / u.x;",
       {"sample_range"},
       "the end of their range"},
      {"masking of one direction", "+ lambda(V, ax, ay))", ")", {}, ""},
      {"directions exchanged in the density",
       "(1.0 - p) * L.z / kPi",
       "(1.0 - p) * V.z / kPi",
       {"jacobian", "density_mass"},
       "differs from the density"},
      {"samples are lost",
       "if (L.z <= 0.0) return",
       "if (L.z <= 0.15) return",
       {"density_mass", "sample_distribution", "sample_mean"},
       "integrates to"},
  };
  const std::size_t step = thorough() ? 1 : 4;
  for (std::size_t k = 0; k < std::size(mutations); k += step) {
    const Mutation& m = mutations[k];
    const Findings found = judged(replaced(kSound, m.from, m.to));
    if (m.checks.empty()) {  // changes f, not how f is sampled
      EXPECT_THAT(failed(found), testing::IsEmpty()) << m.name;
      continue;
    }
    for (const std::string& check : m.checks) EXPECT_THAT(failed(found), Contains(check)) << m.name;
    if (found.empty()) continue;
    EXPECT_THAT(found.at(m.checks[0]).statement, HasSubstr(m.word)) << m.name;
    ASSERT_TRUE(found.at(m.checks[0]).witness) << m.name;
    EXPECT_THAT(found.at(m.checks[0]).witness->command, HasSubstr("--require " + m.checks[0])) << m.name;
  }
}

TEST(SampledShader, HarmlessChangesPass) {
  const std::pair<std::string, std::string> changes[] = {
      {"phi = 2.0 * kPi * u.y", "phi = 2.0 * kPi * (1.0 - u.y)"},
      {"max(1.0 - u.x, 1e-7)", "max(1.0 - u.x, 1e-6)"},
      {"if (u.z < p) {", "if (u.z > 1.0 - p) {"},
      {"* L.z / pdf;", "* (L.z / pdf);"}};
  for (std::size_t k = 0; k < std::size(changes); k += thorough() ? 1 : 2)
    expect_passes(judged(replaced(kSound, changes[k].first, changes[k].second)));
}

TEST(SampledShader, CausesAreNamed) {
  // A single lobe, so that one factor explains every direction.
  std::string lobe = replaced(kSound, "if (u.z < p)", "if (true)");
  lobe = replaced(lobe, "return p * lobe + (1.0 - p) * L.z / kPi;", "return lobe;");
  expect_passes(judged(lobe));
  const auto cause = [&](const std::string& from, const std::string& to) {
    return judged(replaced(lobe, from, to)).at("jacobian").statement;
  };
  EXPECT_THAT(cause("H.z / (4.0 * dot(V, H))", "H.z"), HasSubstr("the factor 1 / (4 dot(V, H)) is missing"));
  EXPECT_THAT(cause("vec3(ax * r * cos(phi), ay * r", "vec3(ay * r * cos(phi), ax * r"),
              HasSubstr("exchanged axes"));
  if (thorough()) {
    EXPECT_THAT(cause("* H.z / (4.0", "/ (4.0"), HasSubstr("lacks the cosine of the half vector"));
    EXPECT_THAT(cause("return lobe;", "return 0.5 * lobe;"),
                HasSubstr("wrong constant factor: the true density is 2 times"));
    EXPECT_THAT(cause("return lobe;", "return lobe * L.z;"),
                HasSubstr("has the factor cos_i once too often"));
  }
  EXPECT_THAT(failed(judged("//: pdf per half\n" + replaced(lobe, "H.z / (4.0 * dot(V, H))", "H.z"))),
              testing::Not(Contains("jacobian")));
}

TEST(SampledShader, WrongProbabilitiesOfLobesAreNamed) {
  const auto cause = [](const std::string& density) {
    return judged(replaced(kSound, "p * lobe + (1.0 - p) * L.z / kPi", density)).at("jacobian").statement;
  };
  EXPECT_THAT(cause("(1.0 - p) * lobe + p * L.z / kPi"), HasSubstr("they are exchanged"));
  if (thorough()) {
    EXPECT_THAT(cause("p * lobe + L.z / kPi"), HasSubstr("a factor is missing"));
    EXPECT_THAT(cause("lobe + L.z / kPi"), HasSubstr("both factors are missing"));
    const std::string same = cause("p * lobe + p * L.z / kPi");
    EXPECT_THAT(same, HasSubstr("weights the lobes with"));
    EXPECT_THAT(same, testing::Not(HasSubstr("missing")));
  }
  // The wrong width of one lobe is no wrong probability.
  EXPECT_THAT(judged(replaced(kSound, "distribution(H, ax, ay) * H.z", "distribution(H, 1.2 * ax, ay) * H.z"))
                  .at("jacobian")
                  .statement,
              HasSubstr("no known cause"));
}

TEST(SampledShader, WrongWidthsAndFramesAreNamed) {
  const std::string sound =
      io::read_content(BRDF_SOURCE_DIR "/tests/cli/samplers/visible_normals.hlsl").bytes;
  const auto cause = [&](const std::string& from, const std::string& to) {
    return judged(replaced(sound, from, to), 1, ".hlsl").at("jacobian").statement;
  };
  const std::string density = "distribution(H.z, alpha) / (1 + lambda(V.z, alpha)) / (4 * V.z)";
  EXPECT_THAT(cause(density, replaced(replaced(density, "z, alpha", "z, alpha * alpha"), "(V.z, alpha)",
                                      "(V.z, alpha * alpha)")),
              HasSubstr("with the root of alpha: the density squares it once more"));
  EXPECT_THAT(cause(density, replaced(replaced(density, "z, alpha", "z, sqrt(alpha)"), "(V.z, alpha)",
                                      "(V.z, sqrt(alpha))")),
              HasSubstr("with the square of alpha: the sampler squares it once more"));
  EXPECT_THAT(
      cause(density, "V.y <= 0.0 ? 1e-9 : distribution(H.y, alpha) / (1 + lambda(V.y, alpha)) / (4 * V.y)"),
      HasSubstr("a frame with the normal along Y"));
  EXPECT_THAT(cause("L = reflect(-V, H);", "L = reflect(-V, H).xzy;"),
              HasSubstr("fits if the sampled direction is in a frame with the normal along Y"));
}

}  // namespace
}  // namespace brdf::cli
#endif
