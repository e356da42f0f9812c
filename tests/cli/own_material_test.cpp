// Tests materials with a user's shader as their form. A fit writes them, and every verb reads them without
// --shader.
#ifdef BRDF_HAS_SHADER
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

// A diffuse part and a lobe. The strength of the lobe is in another file; name and ranges are in comments
// outside of the function.
constexpr const char* kGlow =
    "//: param base 0 1 0.3\n"
    "//: param sheen 0 1 0.2\n"
    "//: param power 1 40 9 log\n"
    "#include \"strength.glsl\"\n"
    "float brdf(vec3 L, vec3 V, vec3 N, float base, float sheen, float power) {\n"
    "  vec3 H = normalize(L + V);\n"
    "  return base / 3.14159265 + sheen * strength() * pow(max(dot(N, H), 0.0), power);\n"
    "}\n";
constexpr const char* kStrength = "//: param base 0 2 1\nfloat strength() { return 0.25; }\n";
constexpr const char* kThreePairs = "theta_i,phi_i,theta_o,phi_o\n20,0,35,170\n65,10,5,0\n0,0,80,40\n";

class OwnMaterial : public testing::Test {
 protected:
  void SetUp() override {
    write("glow.glsl", kGlow);
    write("strength.glsl", kStrength);
    write("pairs.csv", kThreePairs);
    const Outcome o =
        run("synth --shader glow.glsl --set base=0.4 --set sheen=0.6 --set power=14 --grid in_plane --noise "
            "0 -o s.csv");
    ASSERT_EQ(o.exit_code, 0) << o.err;
  }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder() / name).parent_path());
    std::ofstream(folder() / name) << text;
  }
  Outcome run(const std::string& words) const { return run_brdf(words, folder()); }
  nlohmann::json fitted(const std::string& name, const std::string& more = "") const {
    const Outcome o = run("fit s.csv --shader glow.glsl -o " + name + " " + more);
    EXPECT_EQ(o.exit_code, 0) << o.err << o.out;
    return nlohmann::json::parse(file_text(folder() / name));
  }
  // Returns --set for all values of the material.
  static std::string settings(const nlohmann::json& material) {
    std::string words;
    for (const char* table : {"weights", "shape"})
      for (const auto& [name, value] : material[table].items())
        words += " --set " + name + "=" + (value.is_array() ? value[0] : value).dump();
    return words;
  }
  // Returns the output without the lines that name the command.
  static std::string numbers(const Outcome& o) {
    EXPECT_EQ(o.exit_code, 0) << o.err;
    return o.out.substr(std::min(o.out.find("# quantity"), o.out.size()));
  }
  const fs::path& folder() const { return folder_.path(); }
  io::TemporaryFolder folder_;
};

TEST_F(OwnMaterial, OfAFitIsReadAsTheShaderIsEvaluated) {
  const nlohmann::json m = fitted("m.json");
  EXPECT_EQ(m["form"], "glow");
  EXPECT_EQ(m["shader"]["file"], "glow.glsl");
  EXPECT_NEAR(m["weights"]["sheen"][0].get<double>(), 0.6, 1e-6);
  EXPECT_NEAR(m["shape"]["power"].get<double>(), 14, 1e-4);
  const std::string same = "--shader glow.glsl" + settings(m);
  EXPECT_EQ(numbers(run("eval --material m.json pairs.csv")), numbers(run("eval " + same + " pairs.csv")));
  const nlohmann::json here =
                           nlohmann::json::parse(run("albedo --material m.json --theta 0,50,80 --json").out),
                       there = nlohmann::json::parse(run("albedo " + same + " --theta 0,50,80 --json").out);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(here["results"][k]["value"], there["results"][k]["value"]);
}

TEST_F(OwnMaterial, IsJudged) {
  fitted("m.json");
  const Outcome o = run("validate m.json --require finite,non_negative,reciprocity,energy --json");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  for (const nlohmann::json& f : nlohmann::json::parse(o.out)["findings"])
    EXPECT_NE(f["verdict"], "fail") << f;
  EXPECT_EQ(run("prove m.json --property finite").exit_code, 0);
  const Outcome certified = run("prove m.json -o c.json");
  EXPECT_EQ(certified.exit_code, 2);
  EXPECT_THAT(certified.err, HasSubstr("a certificate covers forms of the catalogue, and m.json has glow"));
}

TEST_F(OwnMaterial, KeepsItsReportAndItsJson) {
  const Outcome o = run("fit s.csv --shader glow.glsl -o m.json --report r.html --json");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  const nlohmann::json best = nlohmann::json::parse(o.out)["ranking"][0];
  EXPECT_EQ(best["material"]["shader"]["file"], fs::weakly_canonical(folder() / "glow.glsl").string());
  EXPECT_GT(fs::file_size(folder() / "r.html"), 1000u);
  // The material is complete: the record of its fit is read with it.
  EXPECT_EQ(run("albedo --material m.json --theta 30").exit_code, 0);
}

TEST_F(OwnMaterial, IsFoundFromItsOwnFolder) {
  fs::create_directories(folder() / "out/deep");
  EXPECT_EQ(fitted("out/deep/m.json")["shader"]["file"], "../../glow.glsl");
  EXPECT_EQ(run("eval --material out/deep/m.json pairs.csv").exit_code, 0);
  EXPECT_EQ(run_brdf("eval --material deep/m.json ../pairs.csv", folder() / "out").exit_code, 0);
  const Outcome o = run("fit s.csv --shader '" + (folder() / "glow.glsl").string() + "' -o out/a.json");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_EQ(nlohmann::json::parse(file_text(folder() / "out/a.json"))["shader"]["file"],
            (folder() / "glow.glsl").string());
}

TEST_F(OwnMaterial, IsRefusedWhereItsShaderHasChangedOrIsMissing) {
  fitted("m.json");
  write("glow.glsl", std::string(kGlow) + "// another line\n");
  for (const char* verb :
       {"eval --material m.json pairs.csv", "albedo --material m.json --theta 0", "validate m.json"}) {
    const Outcome o = run(verb);
    EXPECT_EQ(o.exit_code, 2) << verb;
    EXPECT_THAT(o.err, HasSubstr("m.json: $.shader.sha256")) << verb;
    EXPECT_THAT(o.err, HasSubstr("has changed since this material was made: restore the old text, or fit"))
        << verb;
  }
  write("glow.glsl", kGlow);
  EXPECT_EQ(run("albedo --material m.json --theta 0").exit_code, 0);
  write("strength.glsl", "float strength() { return 0.5; }\n");
  EXPECT_THAT(run("albedo --material m.json --theta 0").err,
              HasSubstr("(or a file that it includes) has changed"));
  write("strength.glsl", kStrength);
  fs::remove(folder() / "glow.glsl");
  const Outcome o = run("albedo --material m.json --theta 0");
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_THAT(o.err, HasSubstr("m.json: $.shader.file: \"glow.glsl\" does not exist"));
  EXPECT_THAT(o.err, HasSubstr("--embed"));
}

TEST_F(OwnMaterial, HoldsItsTextWhereThatIsAskedFor) {
  const nlohmann::json m = fitted("m.json", "--embed");
  const std::string expected = numbers(run("eval --shader glow.glsl" + settings(m) + " pairs.csv"));
  const std::string text = m["shader"]["text"];
  EXPECT_THAT(text, HasSubstr("float strength() { return 0.25; }"));
  EXPECT_THAT(text, Not(HasSubstr("#include")));
  EXPECT_THAT(m["fit"].dump(), Not(HasSubstr("float strength")));  // once is enough
  fs::remove(folder() / "glow.glsl");
  fs::remove(folder() / "strength.glsl");
  EXPECT_EQ(numbers(run("eval --material m.json pairs.csv")), expected);
  nlohmann::json changed = m;
  changed["shader"]["text"] = text + " ";
  write("changed.json", changed.dump());
  EXPECT_THAT(run("eval --material changed.json pairs.csv").err,
              HasSubstr("does not match the text: one of the two was changed"));
}

TEST_F(OwnMaterial, IsRefusedBeforeTheSearch) {
  EXPECT_THAT(run("fit s.csv --shader glow.glsl --embed").err, HasSubstr("--embed: needs -o"));
  EXPECT_THAT(run("fit s.csv --form lambert --embed -o m.json").err,
              HasSubstr("--embed: has no effect without --shader"));
  write("latin.glsl", std::string(kGlow) + "// gr\xfcn\n");
  EXPECT_THAT(run("fit s.csv --shader latin.glsl --embed -o m.json").err, HasSubstr("is not UTF-8"));
  const Outcome own = run("fit s.csv --shader glow.glsl -o glow.glsl");
  EXPECT_EQ(own.exit_code, 2);
  EXPECT_EQ(file_text(folder() / "glow.glsl"), kGlow);
  const Outcome nowhere = run("fit s.csv --shader glow.glsl -o none/m.json");
  EXPECT_EQ(nowhere.exit_code, 2) << nowhere.err;
  EXPECT_EQ(nowhere.out, "");
}

TEST_F(OwnMaterial, SaysHowItsShaderWasChosen) {
  write("parts/strength.glsl", kStrength);
  write("many.hlsl",
        "#include \"strength.glsl\"\n"
        "float tone(float3 l, float3 v, float3 n, float base) { return base * TONE * strength() * dot(n, l); "
        "}\n"
        "float other(float3 l, float3 v, float3 n, float base) { return 1.0; }\n");
  const std::string choice =
      "--shader many.hlsl --entry 'tone(L, V, N, base)' --returns 'f*cos_i' --param base=0:3:0.5 --define "
      "TONE=0.5 -I parts";
  ASSERT_EQ(run("synth " + choice + " --set base=0.7 --grid in_plane --noise 0 -o t.csv").exit_code, 0);
  fs::remove(folder() / "strength.glsl");
  const Outcome o = run("fit t.csv " + choice + " -o m.json");
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const nlohmann::json shader = nlohmann::json::parse(file_text(folder() / "m.json"))["shader"];
  EXPECT_EQ(shader["entry"], "tone(L, V, N, base)");
  EXPECT_EQ(shader["returns"], "f*cos_i");
  EXPECT_EQ(shader["parameters"], nlohmann::json::array({"base=0:3:0.5"}));
  EXPECT_EQ(shader["defines"], nlohmann::json::array({"TONE=0.5"}));
  EXPECT_EQ(shader["include_folders"], nlohmann::json::array({"parts"}));
  EXPECT_EQ(numbers(run("eval --material m.json pairs.csv")),
            numbers(run("eval " + choice + settings(nlohmann::json::parse(file_text(folder() / "m.json"))) +
                        " pairs.csv")));
  const Outcome embedded = run("fit t.csv " + choice + " --embed -o e.json");
  ASSERT_EQ(embedded.exit_code, 0) << embedded.err;
  fs::remove_all(folder() / "parts");
  EXPECT_EQ(run("eval --material e.json pairs.csv").exit_code, 0);
  EXPECT_THAT(run("eval --material m.json pairs.csv").err,
              HasSubstr("$.shader.include_folders[0]: \"parts\" is not a folder"));
}

TEST_F(OwnMaterial, IsATermOfASum) {
  const nlohmann::json m = fitted("m.json");
  nlohmann::json sum{{"format", "brdf-material"},
                     {"version", 1},
                     {"form", "sum"},
                     {"channels", {"fr"}},
                     {"terms", nlohmann::json::array()}};
  nlohmann::json term = m;
  for (const char* key : {"fit", "format", "version"}) term.erase(key);
  sum["terms"].push_back(term);
  sum["terms"].push_back({{"form", "lambert"},
                          {"channels", {"fr"}},
                          {"weights", {{"rho", 0.1}}},
                          {"shape", nlohmann::json::object()}});
  sum["terms"][0]["channels"] = {"fr"};
  write("sum.json", sum.dump());
  const Outcome o = run("albedo --material sum.json --theta 40 --json"),
                alone = run("albedo --material m.json --theta 40 --json");
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const auto value = [](const Outcome& of) {
    return nlohmann::json::parse(of.out)["results"][0]["value"].get<double>();
  };
  EXPECT_NEAR(value(o), value(alone) + 0.1, 1e-6);
}

// The shader may have the name of a form, or the name `sum`. The key `shader` takes precedence.
TEST_F(OwnMaterial, MayBeCalledAsAFormIs) {
  for (const char* name : {"ward", "sum"}) {
    fs::copy_file(folder() / "glow.glsl", folder() / (std::string(name) + ".glsl"));
    const std::string file = std::string(name) + ".glsl";
    ASSERT_EQ(run("fit s.csv --shader " + file + " -o m.json").exit_code, 0);
    const nlohmann::json m = nlohmann::json::parse(file_text(folder() / "m.json"));
    EXPECT_EQ(m["form"], name);
    EXPECT_EQ(numbers(run("eval --material m.json pairs.csv")),
              numbers(run("eval --shader " + file + settings(m) + " pairs.csv")));
  }
}

TEST_F(OwnMaterial, IsDrawnAsTheShaderIs) {
  const nlohmann::json m = fitted("m.json");
  const Outcome o = run("render m.json --width 48 --height 48 -o a.png");
  if (o.exit_code == 3) GTEST_SKIP() << o.err;
  ASSERT_EQ(o.exit_code, 0) << o.err;
  ASSERT_EQ(run("render --shader glow.glsl" + settings(m) + " --width 48 --height 48 -o b.png").exit_code, 0);
  // Returns the pixels only, because the text before them names the command.
  const auto pixels = [&](const char* file) {
    const std::string bytes = file_text(folder() / file);
    return bytes.substr(bytes.find("IDAT"));
  };
  EXPECT_TRUE(pixels("a.png") == pixels("b.png"));
}

}  // namespace
}  // namespace brdf
#endif
