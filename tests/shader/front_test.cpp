// How a text is read: which parts belong to the function, which language it is in, and which message
// appears if it does not compile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>

#include "io/columns/supplied.h"
#include "io/files/temporary.h"
#include "shader/spirv/module.h"
#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// The files of one folder, and the message that refuses one of them, or "accepted".
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
  // An interpolated expression belongs to the script and may contain literals of its own.
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
              HasSubstr("rename the file to the suffix .shader"));
}

TEST(Text, NotesStandInLinesOfTheirOwn) {
  const std::string code = "float brdf(vec3 L, vec3 V, float k) { return k; }\n";
  EXPECT_EQ(shader_of("/*\n//: param k 0 4 3\n*/\n" + code)->function().parameters[0].max, 1);
  EXPECT_EQ(shader_of("  //: param k 0 4 3\n" + code)->function().parameters[0].max, 4);
  // The continuation of a comment line is still a comment.
  EXPECT_EQ(
      value_at(shader_of("// a path C:\\\nfloat brdf(vec3 L, vec3 V) { return 9.0; }\n" + code), 0, 0, 0, 0),
      0.5);
}

TEST(Text, NotesThatContradictEachOtherAreRefusedWithTheLine) {
  const std::string code = "float brdf(vec3 L, vec3 V, float k) { return k; }\n";
  const auto refusal = [&](const std::string& notes) -> std::string {
    try {
      parse_source("s.glsl", notes + code);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal("//: param k 0 1 0.5\n//: returns f\n"), "accepted");
  EXPECT_THAT(refusal("//: param k 0 1 0.5\n//: param k 0 2 0.5\n"),
              HasSubstr("s.glsl:2: the parameter k is there twice"));
  EXPECT_THAT(refusal("//: returns f\n//: returns f*cos_i\n"),
              HasSubstr("s.glsl:2: //: returns is there twice"));
  EXPECT_THAT(refusal("//: returns foo\n"), HasSubstr("s.glsl:1: returns 'foo': must be one of"));
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
           "float3 V) { S s; s.x = L.x; return (s + s).x; }",
           "a.hlsl"),
      HasSubstr("a.hlsl:1: is HLSL 2021 (`operator+`)"));
  // A text that does not need HLSL 2021 is read as before.
  const auto beside = shader_of(
      "template<typename T> T twice(T x) { return x + x; }\nfloat brdf(float3 L, float3 V) { return 0.375; }",
      {}, "a.hlsl");
  EXPECT_EQ(value_at(beside, 20, 0, 30, 0), 0.375);
  EXPECT_THAT(notes_of(beside), HasSubstr("omitted twice()"));
  EXPECT_THAT(said("float f<T : ILobe>(T x) { return 1; }\nfloat brdf(float3 L, float3 V) { return f(L); }",
                   "a.hlsl"),
              HasSubstr("a.hlsl:1: is Slang (`f<T`)"));
  EXPECT_THAT(said("public float brdf(float3 L, float3 V) { return 1; }", "a.hlsl"),
              HasSubstr("is Slang (`public"));
  EXPECT_THAT(
      said("enum Kind { a, b };\nfloat brdf(float3 L, float3 V) { Kind k = Kind::a; return 1; }", "a.hlsl"),
      HasSubstr("is HLSL newer than 5.1 (`enum Kind`)"));
  EXPECT_THAT(said("float brdf(float3 L, float3 V) { return 1 }", "a.slang"),
              HasSubstr("is Slang (`.slang`)"));
  EXPECT_THAT(said("mdl 1.6;\nimport ::df::*;\nexport material m() = material();", "a.mdl"),
              HasSubstr("is MDL (`mdl 1"));
  EXPECT_THAT(said("surface own(float k = 1) { Ci = k * diffuse(N); }", "a.osl"),
              HasSubstr("is Open Shading Language"));
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
  // An error with another cause is not reported as another language.
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

// A translator that crashes if scopes are requested. The next ones crash if any places are requested, crash
// always, or exhaust memory or time.
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
  for (;;) all.emplace_back().reserve(std::size_t(1) << 24);  // not written to, which would take time
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
  EXPECT_THAT(refused(takes_all_memory), HasSubstr("needs more than 1 GiB for this text"));
  EXPECT_THAT(refused(takes_all_time), HasSubstr("needs more than 4 s for this text"));
}

TEST(Crashes, AreFollowedByOtherWaysOfTranslating) {
  // Nested braces and a global with a value: the text is translated correctly for every kind of places.
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
  EXPECT_THAT(without.notes, testing::Contains(HasSubstr("so messages have no line numbers")));
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
  // The message reports the error of the first attempt only.
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
  EXPECT_THAT(notes_of(a), HasSubstr("omitted look(), twice()"));
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
              AllOf(HasSubstr("has no function brdf"), HasSubstr("('basis', 'more/lobes' are not files")));
  for (const std::string name : {"b.glsl", "c.glsl", "d.glsl"})
    EXPECT_THAT(tree.refused(name), HasSubstr("'basis' is not a file of the shader's own folder")) << name;
}

TEST(Overloads, AreToldApartOrRefused) {
  const std::string two =
      "float brdf(vec3 L, vec3 V, float a) { return a; }\nfloat brdf(vec3 L, vec3 V, float a, float b) { "
      "return 3.0 * b; }\n";
  EXPECT_THAT(refusal(two), AllOf(HasSubstr("has 2 functions brdf: "), HasSubstr("--entry 'brdf(L, V, a)'")));
  EXPECT_EQ(value_at(shader_of(two, {.file = "", .entry = "brdf(L, V, a)"}), 0, 0, 30, 0), 0.5);
  EXPECT_EQ(value_at(shader_of("//: entry brdf(L, V, a, b)\n" + two), 0, 0, 30, 0), 1.5);
  // The function that no other function calls is chosen, and a note reports the choice.
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

TEST(Refused, FunctionsOfTheLanguageByTheirNames) {
  const auto said = [](const std::string& value) {
    return refusal("float brdf(vec3 L, vec3 V, float k) {\n  return " + value + ";\n}\n");
  };
  EXPECT_THAT(said("inverse(mat3(2.0))[0][0] * inverse(mat3(k))[1][1]"),
              HasSubstr("test.glsl:2: calls inverse()"));
  EXPECT_THAT(said("ldexp(k, 2)"), HasSubstr("test.glsl:2: calls ldexp()"));
  EXPECT_THAT(said("unpackUnorm4x8(floatBitsToUint(k)).x"), HasSubstr("test.glsl:2: calls unpackUnorm4x8()"));
  EXPECT_EQ(
      value_at(shader_of("float brdf(vec3 L, vec3 V, float k) { return float(clamp(int(10.0 * k), 1, 3)); }"),
               0, 0, 0, 0),
      3);
  EXPECT_THAT(refusal(std::string("\x03\x02\x23\x07\0\0\1\0", 8)), HasSubstr("is not valid SPIR-V"));
}

TEST(Lines, OfIncludedFilesAreNotTakenForTheShadersOwn) {
  Tree tree;
  tree.with("part.glsl", "\n\n\n\n\nfloat part(float x) {\n  return 1.0 / (x - x);\n}\n")
      .with("a.glsl",
            "#include \"part.glsl\"\nfloat brdf(vec3 L, vec3 V, float k) {\n  return part(k);\n}\n");
  const auto shader = tree.load("a.glsl");
  for (const Stretch& stretch : shader->function().as_written.stretches)
    for (const Step& step : stretch.steps) EXPECT_LE(step.line, 4u);
}

TEST(Directions, NeitherOfLightNorOfViewerIsRefused) {
  EXPECT_THAT(refusal("float brdf(vec3 p, vec3 q, float s) { return dot(p, q) * s; }"),
              AllOf(HasSubstr("no argument of float brdf(vec3 p, vec3 q, float s) is recognised as the "
                              "direction to the light or to the viewer"),
                    HasSubstr("--entry 'brdf(L, V, N, ...)'")));
  // One direction is known, and a vector may be the other direction.
  EXPECT_THAT(refusal("float brdf(vec3 L, vec3 q, float s) { return dot(L, q) * s; }"),
              AllOf(HasSubstr("the direction to the viewer, which q may be"), HasSubstr("`//: color q")));
  EXPECT_EQ(refusal("float brdf(vec3 p, vec3 q, float s) { return dot(p, q) * s; }",
                    {.file = "", .entry = "brdf(L, V, s)"}),
            "accepted");
  // A uniformly scattering reflectance needs no direction to the viewer.
  EXPECT_EQ(refusal("vec3 brdf(vec3 L, vec3 N, vec3 tint) { return 0.3 * tint; }"), "accepted");
}

TEST(Parts, ThatAreNotKnownStopIt) {
  const auto both = shader_of(
      "void brdf(vec3 L, vec3 V, float k, out float diffTerm, out float specTerm) { diffTerm = k; specTerm = "
      "0.125; }");
  EXPECT_EQ(value_at(both, 10, 0, 20, 0), 0.625);
  EXPECT_THAT(notes_of(both), HasSubstr("diffTerm + specTerm"));
  EXPECT_THAT(refusal("void brdf(vec3 L, vec3 V, float k, out vec3 diffusePart, out vec3 extra) { "
                      "diffusePart = vec3(k); extra = "
                      "vec3(0.125); }"),
              HasSubstr("gives several values (diffusePart, extra)"));
  // Outputs that are left out are named in a note.
  const auto one = shader_of(
      "void brdf(vec3 L, vec3 V, float k, out vec3 color, out vec3 direction_out) { color = vec3(k); "
      "direction_out = L; }");
  EXPECT_THAT(notes_of(one),
              HasSubstr("the reflectance is color of the results of brdf, without direction_out"));
  const auto beside =
      shader_of("float brdf(vec3 L, vec3 V, float k, out float specular) { specular = 2.0; return k; }");
  EXPECT_THAT(notes_of(beside), HasSubstr("the reflectance is the value returned by brdf, without specular"));
  // A parameter of a lobe is not a lobe.
  EXPECT_EQ(value_at(shader_of("struct Lit { vec3 diffuse; vec3 specular; float specularRoughness; };\n"
                               "Lit brdf(vec3 L, vec3 V) { return Lit(vec3(0.25), vec3(0.5), 9.0); }"),
                     10, 0, 20, 0),
            0.75);
}

TEST(Vacuous, WhatDependsOnNothingIsSaidWithTheMacrosThatAreAskedFor) {
  const std::string text =
      "//: param gain 0 2 1\n//: param rest 0 1 0.5\nfloat brdf(vec3 L, vec3 V, float gain, float rest) {\n"
      "#if defined(HAS_COAT) && !defined(GL_ES)\n  return gain * L.z;\n#elif QUALITY_LEVEL > 1\n  return "
      "1.0;\n#else\n"
      "  return 0.0;\n#endif\n}\n#ifndef GUARD\n#define GUARD\n#endif\n";
  const auto nothing = shader_of(text);
  EXPECT_EQ(nothing->function().constant, 0.0);
  EXPECT_THAT(nothing->function().unread, testing::ElementsAre("gain", "rest"));
  EXPECT_THAT(nothing->function().asked_macros, testing::ElementsAre("HAS_COAT", "QUALITY_LEVEL"));
  EXPECT_THAT(notes_of(nothing),
              AllOf(HasSubstr("the value is always 0"), HasSubstr("does not depend on gain, rest"),
                    HasSubstr("(HAS_COAT, QUALITY_LEVEL)")));
  const auto coat = shader_of(text, {.file = "", .defines = {"HAS_COAT"}});
  EXPECT_EQ(coat->function().constant, std::nullopt);
  EXPECT_THAT(coat->function().unread, testing::ElementsAre("rest"));
  EXPECT_THAT(notes_of(coat), Not(HasSubstr("its value is 0")));
  // A computed value of zero is detected by evaluation. A constant other than zero is an ordinary
  // reflector.
  const auto product = shader_of("float brdf(vec3 L, vec3 V, float k) { return k * max(-L.z, 0.0); }");
  EXPECT_TRUE(product->function().zero_where_asked);
  EXPECT_THAT(notes_of(product), HasSubstr("the value is 0 at all directions that were tried"));
  EXPECT_THAT(notes_of(shader_of("float brdf(vec3 L, vec3 V) { return 0.25; }")),
              Not(HasSubstr("its value")));
}

TEST(Whole, IntegersAreAskedForTheirRangeAndStayWhole) {
  const std::string code = "float brdf(vec3 L, vec3 V, int kind, bool on) { return on ? float(kind) : 0.5; }";
  EXPECT_THAT(refusal(code),
              AllOf(HasSubstr("kind of float brdf("), HasSubstr("is a whole number without a range"),
                    HasSubstr("--param kind=MIN:MAX:DEFAULT")));
  const auto shader = shader_of("//: param kind 0 3 2\n//: bool on 1\n" + code);
  for (const ParameterInfo& p : shader->info().shape) EXPECT_TRUE(p.whole) << p.name;
  EXPECT_EQ(value_at(shader, 0, 0, 0, 0), 2);
  // A default that is not given is a whole number as well.
  EXPECT_EQ(shader_of(code, {.file = "", .parameters = {"kind=0:3"}})->info().shape[0].initial, 1);
  EXPECT_THAT(refusal("//: param kind 0 2.5 2\n" + code),
              HasSubstr("test.glsl:1: param kind: 2.5 must be a whole number"));
  EXPECT_THAT(refusal(code, {.file = "", .parameters = {"kind=0:3:1.5"}}),
              HasSubstr("--param kind: 1.5 must be a whole number"));
  EXPECT_THAT(refusal("//: param kind 0 3 1\n//: param on 0 2 1\n" + code),
              HasSubstr("test.glsl:2: param on: 2 must be 0 or 1"));
  const auto block = shader_of(
      "cbuffer Own { bool fast; float k; };\nfloat brdf(float3 L, float3 V) { return fast ? k : 0.125; }", {},
      "a.hlsl");
  EXPECT_EQ(value_at(block, 0, 0, 0, 0), 0.125);
}

TEST(Linear, PlacesWithoutAValueAreLeftOut) {
  // The root of a negative number occurs at a part of the places.
  const auto shader = shader_of(
      "//: param eta 1.1 2 1.5\nfloat brdf(vec3 L, vec3 V, float kd, float ks, float eta) {\n  float c = "
      "dot(L, V);\n"
      "  return kd + ks * sqrt(c - 0.2) * eta * eta;\n}\n");
  EXPECT_TRUE(shader->info().fittable());
  EXPECT_EQ(shader->info().weights.size(), 2u);
  EXPECT_THAT(notes_of(shader),
              testing::ContainsRegex("the value is not finite at [0-9]+ of 24 directions.*eta="));
  const auto without = shader_of("float brdf(vec3 L, vec3 V, float kd) { return kd * sqrt(-1.0 - L.z); }");
  EXPECT_FALSE(without->info().fittable());
  EXPECT_THAT(notes_of(without), HasSubstr("at 24 of 24 directions"));
  // A function that is not linear remains not fittable.
  EXPECT_FALSE(shader_of("float brdf(vec3 L, vec3 V, float kd) { return kd * kd * sqrt(dot(L, V) - 0.2); }")
                   ->info()
                   .fittable());
}

TEST(Defines, StandBeforeTheTextAndInIncludedFiles) {
  Tree tree;
  tree.with("own/a.glsl", "#include \"part.glsl\"\nfloat brdf(vec3 L, vec3 V) { return part(SCALE); }\n")
      .with("far/part.glsl",
            "#ifdef TWICE\nfloat part(float x) { return 2.0 * x; }\n#else\nfloat part(float x) { return x "
            "EMPTY; }\n#endif\n")
      .with("near/part.glsl", "float part(float x) { return 5.0 * x; }\n")
      .with("own/b.glsl",
            "#include \"../far/part.glsl\"\nfloat brdf(vec3 L, vec3 V) { return part(SCALE); }\n");
  const std::string far = tree.path("far").string(), near = tree.path("near").string();
  const auto value = [&](const std::string& name, std::vector<std::string> defines,
                         std::vector<std::string> folders) {
    return value_at(
        tree.load(name, {.file = "", .defines = std::move(defines), .include_folders = std::move(folders)}),
        10, 0, 20, 0);
  };
  EXPECT_EQ(value("own/a.glsl", {"SCALE=0.25", "EMPTY="}, {far}), 0.25);
  EXPECT_EQ(value("own/a.glsl", {"SCALE=0.25", "TWICE"}, {far}), 0.5);
  EXPECT_EQ(value("own/a.glsl", {"SCALE=0.25"}, {near, far}), 1.25);
  EXPECT_EQ(value("own/a.glsl", {"SCALE=0.25", "TWICE"}, {far, near}), 0.5);
  // A file outside the shader's folder is read if it lies below a folder that is named.
  EXPECT_THAT(tree.refused("own/b.glsl", {.file = "", .defines = {"SCALE=1.0", "TWICE"}}),
              HasSubstr("is not a file"));
  EXPECT_EQ(value("own/b.glsl", {"SCALE=0.25", "TWICE"}, {far}), 0.5);
  std::filesystem::create_symlink(tree.path("near/part.glsl"), tree.path("own/part.glsl"));
  EXPECT_THAT(tree.refused("own/a.glsl", {.file = "", .defines = {"SCALE=0.25"}}),
              HasSubstr("is not a file"));
  // The command line overrides a supplied constant.
  tree.with("own/c.glsl", "float brdf(vec3 L, vec3 V) { return PI; }\n");
  EXPECT_EQ(value("own/c.glsl", {"PI=0.5"}, {}), 0.5);
}

TEST(Defines, AreRefusedOrSaidWhereTheyDoNothing) {
  const std::string code = "#define KIND 3\nfloat brdf(vec3 L, vec3 V) { return float(KIND); }\n";
  const auto said = [&](std::vector<std::string> defines) {
    return refusal(code, {.file = "", .defines = std::move(defines)});
  };
  for (const std::string wrong : {"", "=1", "2x", "a b=1", "defined", "x(y)=y", "x=1\n#error"})
    EXPECT_THAT(said({wrong}), HasSubstr("must be NAME, NAME= or NAME=VALUE")) << wrong;
  EXPECT_THAT(said({"A=1", "A=2"}), HasSubstr("--define 'A=2': another --define gives 'A=1'"));
  EXPECT_EQ(said({"A=1", "A=1"}), "accepted");
  EXPECT_THAT(said({"KIND=4"}),
              AllOf(HasSubstr("test.glsl:1: "), HasSubstr("--define KIND=4 gives a different value")));
  EXPECT_THAT(refusal(code, {.file = "", .include_folders = {"/no/such/folder"}}),
              HasSubstr("-I '/no/such/folder': is not a folder"));
  EXPECT_THAT(notes_of(shader_of(code, {.file = "", .defines = {"KINDS=4"}})),
              HasSubstr("--define KINDS: no file uses this macro"));
  EXPECT_THAT(
      refusal(
          "#if !defined(TARGET)\n#error choose a target\n#endif\nfloat brdf(vec3 L, vec3 V) { return 1.0; }"),
      AllOf(HasSubstr("test.glsl:2: "), HasSubstr("not defined: TARGET; define a macro with --define NAME")));
  EXPECT_EQ(
      command_words({.file = "a.glsl", .defines = {"K=2.0 * x", "T"}, .include_folders = {"my folder"}}),
      "--shader a.glsl --define 'K=2.0 * x' --define T -I 'my folder'");
}

}  // namespace
}  // namespace brdf::shader
