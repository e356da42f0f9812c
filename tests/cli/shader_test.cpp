// Tests the shader source that users receive, and the proof that it computes the same values as the
// library.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "brdf/reflectance.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

#ifdef BRDF_GLSLC
bool compiles(const std::filesystem::path& file, const std::string& stage) {
  const std::string command = "'" BRDF_GLSLC "' --target-env=vulkan1.3 -Werror -fshader-stage=" + stage +
                              " '" + file.string() + "' -o /dev/null";
  return std::system(command.c_str()) == 0;
}

TEST(ExportedShader, OfEveryFormCompilesAsItIs) {
  io::TemporaryFolder folder;
  for (const Reflectance& form : catalogue()) {
    const std::string name(form.info().name);
    ASSERT_EQ(run_brdf("export --form " + name + " --to glsl -o form.glsl", folder.path()).exit_code, 0);
    EXPECT_TRUE(compiles(folder.path() / "form.glsl", "frag")) << name;
  }
}

TEST(ExportedShader, OfAMaterialCompilesInEveryStageAndWithinAnotherShader) {
  io::TemporaryFolder folder;
  const std::string command = "export --form ward --set alpha_x=0.1 --set tangent_phi=17 --to glsl -o m.glsl";
  ASSERT_EQ(run_brdf(command, folder.path()).exit_code, 0);
  for (const char* stage : {"vert", "frag", "comp"})
    EXPECT_TRUE(compiles(folder.path() / "m.glsl", stage)) << stage;

  ASSERT_EQ(run_brdf(command + " --include", folder.path()).exit_code, 0);
  std::ofstream(folder.path() / "user.glsl")
      << "#version 450\n#extension GL_GOOGLE_include_directive : require\n#include \"m.glsl\"\n"
         "layout(location = 0) out vec4 color;\n"
         "void main() { color = vec4(brdf_material(vec3(0.0, 0.6, 0.8), vec3(0.0, 0.0, 1.0)), 1.0); }\n";
  EXPECT_TRUE(compiles(folder.path() / "user.glsl", "frag"));
}
#endif

TEST(ExportedShader, ForBrowsersIsWrittenInTheirDialect) {
  io::TemporaryFolder folder;
  ASSERT_EQ(run_brdf("export --form ward --set alpha_x=0.1 --to glsl-es -o m.glsl", folder.path()).exit_code,
            0);
  const std::string text = file_text(folder.path() / "m.glsl");
  EXPECT_TRUE(text.starts_with("#version 300 es\n"));
  EXPECT_THAT(text, testing::HasSubstr("precision highp float;\n"));
  EXPECT_THAT(text, testing::HasSubstr("vec3 brdf_material(vec3 wi, vec3 wo) {"));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("precise ")));
}

}  // namespace
}  // namespace brdf
