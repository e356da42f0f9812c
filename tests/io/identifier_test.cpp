// Names of materials and parameters as identifiers of other languages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/identifier.h"
#include "io/material/shader_language.h"

namespace brdf::io {
namespace {

TEST(Identifier, OfAnEmptyNameIsAWord) {
  for (const NameIn in : {NameIn::file, NameIn::cpp, NameIn::osl}) {
    EXPECT_EQ(identifier("", in), "material");
    EXPECT_EQ(identifier("--", in), "material");
  }
  EXPECT_EQ(identifier("", NameIn::argument), "argument");
}

TEST(Identifier, OfAnArgumentIsNoWordOfAShader) {
  for (const char* name : {"half", "float3", "register", "default", "pow", "wi", "N", "M_PI"})
    EXPECT_EQ(identifier(name, NameIn::argument), std::string("argument_") + name);
  for (const char* name : {"roughness", "kd", "alpha_x", "index", "gamma"})
    EXPECT_EQ(identifier(name, NameIn::argument), name);
  EXPECT_EQ(identifier("material.roughness", NameIn::argument), "material_roughness");
  EXPECT_EQ(identifier("2nd", NameIn::argument), "argument_2nd");
}

// Every argument of a function has a name of its own.
TEST(Identifier, OfArgumentsIsUnique) {
  const ParameterInfo shape[] = {{"a.b"}, {"half"}, {"a_b"}}, weights[] = {{"kd"}, {"a b"}};
  EXPECT_THAT(argument_names(shape, weights),
              testing::ElementsAre("a_b", "argument_half", "a_b_2", "kd", "a_b_3"));
}

}  // namespace
}  // namespace brdf::io
