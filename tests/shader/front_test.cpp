// How a text is read: what belongs to it, which language it is in, and what is told where it does not compile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>

#include "io/temporary_folder.h"
#include "shader/spirv/module.h"
#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// Files of one folder, and the message that refuses one of them, or "accepted".
class Tree {
 public:
  Tree& with(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_.path() / name).parent_path());
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
    return *this;
  }
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
  std::shared_ptr<const ShaderReflectance> load(const std::string& name, ShaderChoice choice = {}) const {
    choice.file = path(name).string();
    return load_shader(choice);
  }
  std::string refused(const std::string& name, const ShaderChoice& choice = {}) const {
    try {
      load(name, choice);
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  }

 private:
  io::TemporaryFolder folder_;
};

std::string notes_of(const std::shared_ptr<const ShaderReflectance>& shader) {
  std::string all;
  for (const std::string& note : shader->function().notes) all += note + "\n";
  return all;
}

TEST(Text, BackticksInAShadersCommentsAreWords) {
  const std::string glsl =
      "// it was `float brdf(vec3 L, vec3 V) { return 0.25; }` once\nconst float kScale = 4.0;\n"
      "float brdf(vec3 L, vec3 V, float k) { return kScale * k; } /* `k` is between 0 and 1 */\n";
  EXPECT_EQ(value_at(shader_of(glsl), 20, 0, 30, 0), 2);
  EXPECT_EQ(value_at(shader_of(glsl, {}, "a.frag"), 20, 0, 30, 0), 2);
  const std::string hlsl =
      "/* `export` of `k` */ static const float kScale = 4.0;\n"
      "float brdf(float3 L, float3 V, float k) { return kScale * k; }\n";
  EXPECT_EQ(value_at(shader_of(hlsl, {}, "a.hlsl"), 20, 0, 30, 0), 2);
}

TEST(Text, AScriptsCommentsAndQuotesHoldNoShader) {
  const auto value = [](const std::string& script) {
    return value_at(shader_of(script, {}, "chunk.js"), 20, 0, 30, 0);
  };
  const std::string old = "float brdf(vec3 L, vec3 V) { return 7.0; }";
  const std::string mine =
      "export const chunk = /* glsl */`\nfloat brdf(vec3 L, vec3 V) { return 3.0; }\n`;\n";
  EXPECT_EQ(value("// `" + old + "`\n" + mine), 3);
  EXPECT_EQ(value("/* `" + old + "` */\n" + mine), 3);
  EXPECT_EQ(value("const before = '`" + old + "`';\nconst it = /[`]/;\n" + mine), 3);
  // What is put in is the script's, with literals of its own.
  EXPECT_EQ(value("const w = `// ${[1, 2].map(x => `${x}`).join('}')}\n" + mine.substr(mine.find("float"))),
            3);
  EXPECT_EQ(value_at(shader_of(mine, {}, "chunk.ts"), 20, 0, 30, 0), 3);
}

TEST(Text, UnitysProgramsAreToldByTheirSuffix) {
  const std::string code = "float brdf(float3 L, float3 V) { return 0.5; }\n";
  EXPECT_EQ(value_at(shader_of("// CGPROGRAM\n// ENDCG\n" + code, {}, "a.hlsl"), 20, 0, 30, 0), 0.5);
  EXPECT_EQ(value_at(shader_of("// CGPROGRAM of old\nCGPROGRAM\n" + code + "ENDCG\n", {}, "a.shader"), 20, 0,
                     30, 0),
            0.5);
  EXPECT_THAT(refusal("CGPROGRAM\n" + code + "ENDCG\n", {}, "a.hlsl"),
              HasSubstr("give the file the suffix .shader"));
}

TEST(Text, NotesStandInLinesOfTheirOwn) {
  const std::string code = "float brdf(vec3 L, vec3 V, float k) { return k; }\n";
  EXPECT_EQ(shader_of("/*\n//: param k 0 4 3\n*/\n" + code)->function().parameters[0].max, 1);
  EXPECT_EQ(shader_of("  //: param k 0 4 3\n" + code)->function().parameters[0].max, 4);
  // A line that is continued is a comment still.
  EXPECT_EQ(
      value_at(shader_of("// a path C:\\\nfloat brdf(vec3 L, vec3 V) { return 9.0; }\n" + code), 0, 0, 0, 0),
      0.5);
}

TEST(Text, ByteOrderMarksAreNoPartOfIt) {
  const std::string code = "float brdf(float3 L, float3 V) { return 0.625; }\r\n";
  EXPECT_EQ(value_at(shader_of("\xEF\xBB\xBF" + code, {}, "a.hlsl"), 20, 0, 30, 0), 0.625);
  for (const bool big : {false, true}) {
    std::string wide = big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : code) wide += big ? std::string{'\0', c} : std::string{c, '\0'};
    EXPECT_EQ(value_at(shader_of(wide, {}, "a.hlsl"), 20, 0, 30, 0), 0.625) << big;
  }
  Tree tree;
  tree.with("part.h",
            "\xEF\xBB\xBF"
            "float part() { return 0.125; }")
      .with("a.hlsl", "#include \"part.h\"\nfloat brdf(float3 L, float3 V) { return part(); }\n");
  EXPECT_EQ(value_at(tree.load("a.hlsl"), 20, 0, 30, 0), 0.125);
  EXPECT_THAT(refusal(std::string("float\0x", 7)), HasSubstr("NUL"));
}

TEST(Languages, AreRefusedByNameWhereNothingCompiles) {
  const auto said = [](const std::string& text, const std::string& name) { return refusal(text, {}, name); };
  EXPECT_THAT(
      said("// `k`\nconst k: f32 = 2.0;\nfn lobe(L: vec3<f32>) -> f32 { return k; }", "a.wgsl"),
      AllOf(HasSubstr("a.wgsl:3: is WGSL (`fn lobe(`)"), HasSubstr("write the function in GLSL or HLSL")));
  EXPECT_THAT(said("@group(0) @binding(1) var<uniform> k: f32;", "a.wgsl"), HasSubstr("is WGSL (`@group(`)"));
  EXPECT_THAT(said("module own;\nimport shapes.lobe;\nfloat brdf(float3 L, float3 V) { return lobe(L, V); }",
                   "a.slang"),
              HasSubstr("a.slang:1: is Slang (`module own;`)"));
  EXPECT_THAT(
      said("interface ILobe { float at(float3 L); }\nfloat brdf(float3 L, float3 V) { return 1; }", "a.hlsl"),
      HasSubstr("a.hlsl:1: is Slang (or HLSL with interfaces) (`interface ILobe {`)"));
  EXPECT_THAT(said("float brdf(float3 L, float3 V) {\n  let k = dot(L, V);\n  return k;\n}", "a.hlsl"),
              HasSubstr("a.hlsl:2: is Slang (`let k =`)"));
  EXPECT_THAT(
      said("template<typename T> T twice(T x) { return x + x; }\nfloat brdf(float3 L, float3 V) { return "
           "twice(L.x); }",
           "a.hlsl"),
      AllOf(HasSubstr("is HLSL 2021 (`template<`)"), HasSubstr("HLSL 5.1")));
  EXPECT_THAT(said("float3 brdf(float3 L, float3 V) { return select(L > V, L, V); }", "a.hlsl"),
              HasSubstr("is HLSL 2021 (`select(`)"));
  EXPECT_THAT(
      said("struct S { float x; S operator+(S o) { S r; r.x = x + o.x; return r; } };\nfloat brdf(float3 L, "
           "float3 V) { return 1; }",
           "a.hlsl"),
      HasSubstr("is HLSL 2021 (`operator+`)"));
  EXPECT_THAT(said("mdl 1.6;\nimport ::df::*;\nexport material m() = material();", "a.mdl"),
              HasSubstr("is MDL (`mdl 1"));
  EXPECT_THAT(said("surface own(color c = 1) { Ci = c * diffuse(N); }", "a.osl"),
              HasSubstr("is Open Shading Language"));
}

TEST(Languages, TheirWordsAreNamesInOthers) {
  const auto value = [](const std::string& text, const std::string& name) {
    return value_at(shader_of(text, {}, name), 20, 0, 30, 0);
  };
  EXPECT_EQ(
      value("float select(bool c, float a, float b) { return c ? a : b; }\n"
            "// import scene; interface I { } fn f(x: f32) template<T>\n"
            "float brdf(vec3 L, vec3 V) { float let = 2.0, fn = 1.0, module = 0.5, operator_ = 1.0; return "
            "select(let > fn, module, operator_); }",
            "a.glsl"),
      0.5);
  EXPECT_EQ(
      value("struct extension { float var; };\nstatic const float mdl = 0.25, shader_type = 1;\n"
            "float brdf(float3 L, float3 V) { extension e; e.var = mdl; float surface = e.var * shader_type; "
            "return surface; }",
            "a.hlsl"),
      0.25);
  EXPECT_EQ(value("struct fn { float x; };\nfn make(float x) { return fn(x); }\n"
                  "float brdf(vec3 L, vec3 V) { fn let = make(0.75); return let.x; }",
                  "a.glsl"),
            0.75);
  // What fails for another reason is not taken for another language.
  EXPECT_THAT(refusal("float brdf(vec3 L, vec3 V) { float let; let = 2.0; return missing(let); }"),
              HasSubstr("'missing'"));
}

TEST(Globals, WithValuesCompileUnderAnyName) {
  const std::string hlsl =
      "static float kBase = 0.2, kTwice = 2.0 * kBase;\nfloat brdf(float3 L, float3 V, float k) {\n  if (L.z "
      "<= 0.0) {\n"
      "    return 0.0;\n  }\n  return kTwice * k;\n}\n";
  const std::string glsl =
      "float base = 0.2, parts[2] = float[2](base, 2.0 * base);\nfloat brdf(vec3 L, vec3 V, float k) {\n  "
      "for (int i = 0; "
      "i < 2; ++i) {\n    if (parts[i] > 0.3) {\n      return parts[i] * k;\n    }\n  }\n  return 0.0;\n}\n";
  for (std::size_t length = 1; length < 60; length += 3) {
    const std::string name(length, 's');
    EXPECT_NEAR(value_at(shader_of(hlsl, {}, name + ".hlsl"), 20, 0, 30, 0), 0.2, 1e-12) << length;
    EXPECT_NEAR(value_at(shader_of(glsl, {}, name + ".glsl"), 20, 0, 30, 0), 0.2, 1e-12) << length;
  }
}

// A compiler that ends as it is told wherever places are asked for.
Translated crashes_with_scopes(const Source& source, Places places) {
  if (places == Places::scopes) raise(SIGSEGV);
  return translate(source, places);
}
Translated crashes_with_lines(const Source& source, Places places) {
  if (places != Places::none) raise(SIGSEGV);
  return translate(source, places);
}
Translated crashes_always(const Source&, Places) {
  raise(SIGSEGV);
  return {};
}
Translated takes_all_memory(const Source&, Places) {
  std::vector<std::string> all;
  for (;;) all.emplace_back(std::size_t(1) << 24, 'x');
}
Translated takes_all_time(const Source&, Places) {
  volatile bool goes_on = true;
  while (goes_on) {
  }
  return {};
}

TEST(Crashes, AreToldFromTooSlowAndTooLarge) {
  const Source source = parse_source("a.glsl", "float brdf(vec3 L, vec3 V) {\n  return 1.0;\n}\n");
  const auto refused = [&](Translate by) -> std::string {
    try {
      compile(source, by);
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refused(crashes_always),
              AllOf(HasSubstr("a.glsl: the shader compiler crashes on this text (signal 11"),
                    Not(HasSubstr("needs"))));
  EXPECT_THAT(refused(takes_all_memory), HasSubstr("needs more than 1 GiB for this text: it is too large"));
  EXPECT_THAT(refused(takes_all_time), HasSubstr("needs more than 4 s for this text: it is too slow"));
}

TEST(Crashes, AreFollowedByOtherWaysOfTranslating) {
  // Braces within braces, and a global with a value: each is read without harm whatever is asked of places.
  const Source source = parse_source("a.glsl",
                                     "float base = 0.2;\nfloat brdf(vec3 L, vec3 V) {\n  if (L.x > 2.0) {\n  "
                                     "  { return 1.0; }\n  }\n  return base;\n}\n");
  const Compiled with_scopes = compile(source), with_lines = compile(source, crashes_with_scopes),
                 without = compile(source, crashes_with_lines);
  const auto line_of_return = [](const Compiled& c) {
    const spirv::Module module = spirv::parse(c.spirv);
    for (const auto& [id, f] : module.functions)
      if (f.name == "brdf") return f.blocks.back().code.back().line;
    return 99u;
  };
  EXPECT_EQ(line_of_return(with_scopes), 6u);
  EXPECT_EQ(line_of_return(with_lines), 6u);
  EXPECT_EQ(line_of_return(without), 0u);
  EXPECT_TRUE(with_lines.notes.empty());
  EXPECT_THAT(without.notes, testing::Contains(HasSubstr("so none are named")));
}

TEST(Supplied, NothingThatAnIncludedFileDefines) {
  Tree tree;
  tree.with("shared.glsl",
            "const float PI = 3.0;\n#define saturate(x) clamp(x, 0.0, 0.5)\nvec3 sq(vec3 x) { return x; }\n")
      .with("a.glsl",
            "#include \"shared.glsl\"\nfloat brdf(vec3 L, vec3 V, float k) { return shade(k) / PI; }\n")
      .with("b.glsl",
            "#include \"shared.glsl\"\nfloat brdf(vec3 L, vec3 V, float k) { return PI * saturate(k + 1.0) * "
            "INV_PI * "
            "sq(L).z; }\n");
  // The first attempt's error, and no other.
  EXPECT_THAT(tree.refused("a.glsl"), AllOf(HasSubstr("a.glsl:2: 'shade'"), Not(HasSubstr("shared.glsl"))));
  const auto b = tree.load("b.glsl");
  EXPECT_NEAR(value_at(b, 0, 0, 30, 0), 3 * 0.5 / kPi, 1e-6);
  EXPECT_THAT(notes_of(b),
              AllOf(HasSubstr("INV_PI, which the file does not define"), Not(HasSubstr("saturate"))));
  tree.with("c.glsl", "#ifndef PI\n#define PI 2.0\n#endif\nfloat brdf(vec3 L, vec3 V) { return PI; }\n");
  EXPECT_EQ(value_at(tree.load("c.glsl"), 0, 0, 30, 0), 2);
}

TEST(Supplied, IncludedFilesMayHaveFunctionsThatDoNotCompile) {
  Tree tree;
  tree.with("engine/tools.glsl",
            "uniform sampler2D table;\nvec4 look(vec2 at) {\n  return texture(table, at, 1.0, 2, 3);\n}\n"
            "float third(float x) { return x / 3.0; }\nvec4 twice(vec2 at) { return 2.0 * look(at); }\n")
      .with("a.glsl",
            "#include \"engine/tools.glsl\"\nfloat brdf(vec3 L, vec3 V, float k) { return third(k); }\n")
      .with("b.glsl",
            "#include \"engine/tools.glsl\"\nfloat brdf(vec3 L, vec3 V, float k) { return look(vec2(k)).x; "
            "}\n");
  const auto a = tree.load("a.glsl");
  EXPECT_NEAR(value_at(a, 0, 0, 30, 0), 0.5 / 3, 1e-12);
  EXPECT_THAT(notes_of(a), HasSubstr("without look(), twice()"));
  EXPECT_THAT(notes_of(a), HasSubstr("engine/tools.glsl:3: 'texture'"));
  EXPECT_THAT(tree.refused("b.glsl"), HasSubstr("engine/tools.glsl:3: 'texture'"));
}

TEST(Includes, ThatAreMissingAreNamedWhateverFails) {
  Tree tree;
  tree.with("a.glsl", "#include <basis>\n#include <more/lobes>\n")
      .with("b.glsl", "#include <basis>\nfloat brdf(vec3 L, vec3 V) { return basisScale; }\n")
      .with("c.glsl", "#include <basis>\nfloat brdf(vec3 L, vec3 V) { return 1.0 }\n")
      .with(
          "d.glsl",
          "#include <basis>\nfloat outside(float x);\nfloat brdf(vec3 L, vec3 V) { return outside(1.0); }\n");
  EXPECT_THAT(tree.refused("a.glsl"),
              AllOf(HasSubstr("has no function brdf"), HasSubstr("('basis', 'more/lobes' are no files")));
  for (const std::string name : {"b.glsl", "c.glsl", "d.glsl"})
    EXPECT_THAT(tree.refused(name), HasSubstr("'basis' is no file of the shader's own folder")) << name;
}

TEST(Overloads, AreToldApartOrRefused) {
  const std::string two =
      "float brdf(vec3 L, vec3 V, float a) { return a; }\nfloat brdf(vec3 L, vec3 V, float a, float b) { "
      "return 3.0 * b; }\n";
  EXPECT_THAT(refusal(two), AllOf(HasSubstr("has 2 functions brdf: "), HasSubstr("--entry 'brdf(L, V, a)'")));
  EXPECT_EQ(value_at(shader_of(two, {.file = "", .entry = "brdf(L, V, a)"}), 0, 0, 30, 0), 0.5);
  EXPECT_EQ(value_at(shader_of("//: entry brdf(L, V, a, b)\n" + two), 0, 0, 30, 0), 1.5);
  // The one that nobody calls is meant, and said.
  const auto outer = shader_of(
      "float brdf(float NdotL, float a) { return a * NdotL; }\nfloat brdf(vec3 L, vec3 V, vec3 N, float a) { "
      "return "
      "brdf(dot(N, L), a); }\n");
  EXPECT_EQ(value_at(outer, 0, 0, 30, 0), 0.5);
  EXPECT_THAT(notes_of(outer),
              HasSubstr("of 2 functions brdf the reflectance is float brdf(vec3 L, vec3 V, vec3 N"));
}

TEST(Recursion, IsRefusedWithItsLine) {
  EXPECT_THAT(
      refusal(
          "float deep(float x) {\n  return x < 1.0 ? x\n    : deep(x - 1.0);\n}\nfloat brdf(vec3 L, vec3 V, "
          "float k) { return deep(k); }\n"),
      HasSubstr("test.glsl:3: deep() calls itself"));
  EXPECT_THAT(refusal("float b(float x);\nfloat a(float x) { return b(x); }\nfloat b(float x) { return a(x); "
                      "}\nfloat brdf(vec3 "
                      "L, vec3 V, float k) { return a(k); }\n"),
              AllOf(HasSubstr("which leads back to it"), HasSubstr("recursion")));
}

}  // namespace
}  // namespace brdf::shader
