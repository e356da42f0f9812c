// The tracing scalar records the formula once, as the library computes it.
#include "brdf/trace.h"
#include "brdf/forms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string statements(Traced value) {
  return Trace::current().statements({value.node()}, "return %0;", true);
}

struct Tracing : testing::Test {
  Trace trace;
  Trace::Scope scope{trace};
  Traced x = Traced::input("x"), y = Traced::input("y");
};

TEST_F(Tracing, SharesEqualExpressions) {
  EXPECT_EQ(statements((x + y) * (x + y)),
            "  precise float t0 = x + y;\n  precise float t1 = t0 * t0;\n  return t1;\n");
}

TEST_F(Tracing, KeepsTheOrderOfOperands) {
  EXPECT_THAT(statements(x - y), HasSubstr("x - y"));
  EXPECT_THAT(statements(y - x), HasSubstr("y - x"));
  EXPECT_NE((x + y).node(), (y + x).node());
}

TEST_F(Tracing, FoldsConstantsInFloat) {
  // 1 + 2^-25 equals 1 in float and exceeds 1 in double.
  EXPECT_EQ((Traced(1.0) + Traced(0x1p-25)).node(), Traced(1.0).node());
  EXPECT_EQ((Traced(1.0) / Traced(3.0)).node(), Traced(double(1.0f / 3.0f)).node());
  EXPECT_EQ(sqrt(Traced(2.0)).node(), Traced(double(std::sqrt(2.0f))).node());
  EXPECT_EQ(exp(Traced(1.5)).node(), Traced(double(kernels::exp(1.5f))).node());
}

TEST_F(Tracing, DoesNotFoldToInfinity) {
  EXPECT_THAT(statements(Traced(1.0) / Traced(0.0)), HasSubstr("1.0 / 0.0"));
}

TEST_F(Tracing, LiteralsReadBackExactly) {
  for (const float value : {0.1f, 1.0f / 3.0f, 1e-30f, 16777217.0f, -2.5f}) {
    const std::string text = trace[Traced(double(value)).node()].code;
    EXPECT_EQ(std::stof(text), value) << text;
    EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text << " is an integer in GLSL";
  }
}

TEST_F(Tracing, ChoicesAreExpressions) {
  EXPECT_EQ(statements(larger(x, y)), "  bool t0 = x < y;\n  precise float t1 = t0 ? y : x;\n  return t1;\n");
}

TEST(Glsl, EveryFloatOfEveryFormIsPrecise) {
  const auto count = [](const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
  };
  for (const Reflectance& form : catalogue()) {
    const std::string text = glsl_kernels() + form->glsl();
    EXPECT_GT(count(text, "\n  precise float t"), 50u) << form.info().name;
    EXPECT_EQ(count(text, "\n  float t"), 0u) << form.info().name;
    EXPECT_EQ(count(form->glsl({.precise = false}), "precise"), 0u) << form.info().name;
  }
}

struct TracingForBrowsers : testing::Test {
  Trace trace{GlslDialect::es};
  Trace::Scope scope{trace};
  Traced x = Traced::input("x"), y = Traced::input("y"), z = Traced::input("z");
  bool guarded(Traced value) {
    return trace.statements({value.node()}, "return %0;", false).find("^ brdf_zero") != std::string::npos;
  }
};

TEST_F(TracingForBrowsers, WhatCompilersRearrangeIsHiddenFromThem) {
  EXPECT_EQ(trace.statements({((x + Traced(1.0)) - Traced(1.0)).node()}, "return %0;", false),
            "  float t0 = x + 1.0;\n  uint t1 = floatBitsToUint(t0);\n  uint t2 = t1 ^ brdf_zero;\n"
            "  float t3 = uintBitsToFloat(t2);\n  float t4 = t3 - 1.0;\n  return t4;\n");
  EXPECT_TRUE(guarded(Traced(3.0) * (Traced(2.0) * x)));
  EXPECT_TRUE(guarded((x * Traced(2.0)) / Traced(3.0)));
  EXPECT_TRUE(guarded((x + y) - x));
  EXPECT_TRUE(guarded(y - (y - x)));
  EXPECT_TRUE(guarded(x * y + z * x));
}

TEST_F(TracingForBrowsers, WhatTheyLeaveAloneStandsAsItIs) {
  EXPECT_FALSE(guarded(x + y + z));
  EXPECT_FALSE(guarded(Traced(2.0) * x + Traced(1.0)));
  EXPECT_FALSE(guarded(x * y + z * z));
  EXPECT_FALSE(guarded((x + Traced(1.0)) * Traced(2.0)));
}

TEST(GlslForBrowsers, KnowsNoPreciseAndAddsNoConstantToRound) {
  const GlslOptions es{.dialect = GlslDialect::es};
  const std::string kernels = glsl_kernels(es);
  EXPECT_THAT(kernels, HasSubstr("roundEven("));
  EXPECT_THAT(kernels, Not(HasSubstr("12582912.0")));
  for (const Reflectance& form : catalogue())
    EXPECT_THAT(form->glsl(es), Not(HasSubstr("precise"))) << form.info().name;
}

TEST(Glsl, ArgumentsFollowTheTables) {
  EXPECT_THAT(Reflectance(cook_torrance{})->glsl(),
              HasSubstr("vec3 brdf_eval_cos_cook_torrance(vec3 wi, vec3 wo, float alpha_x, float alpha_y, "
                        "vec3 kd, vec3 ks, vec3 f0) {\n"));
  EXPECT_THAT(Reflectance(lambert{})->glsl(),
              HasSubstr("vec3 brdf_eval_lambert(vec3 wi, vec3 wo, vec3 rho) {\n"));
}

TEST(Glsl, UsesNoFunctionOfTheShadingLanguageThatRoundsFreely) {
  for (const Reflectance& form : catalogue()) {
    const std::string text = glsl_kernels() + form->glsl();
    for (const char* name :
         {" exp(", " log(", " pow(", " inversesqrt(", " fma(", " mix(", " dot(", " normalize("})
      EXPECT_THAT(text, Not(HasSubstr(name))) << form.info().name;
  }
}

TEST(Glsl, IsTheSameTextEachTime) {
  for (const Reflectance& form : catalogue()) EXPECT_EQ(form->glsl(), form->glsl());
}

}  // namespace
}  // namespace brdf
