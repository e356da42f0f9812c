// The search against facts known from other sources: it finds known violations and raises no false alarm.
#include "validate/form/checks.h"
#include "brdf/forms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/thorough.h"

namespace brdf::validate {
namespace {

Finding energy_of(const char* form, double max_theta = 89.5) {
  CheckOptions options;
  options.max_theta = max_theta;
  return check_energy(Subject::form(find_form(form).value()), options);
}

double parameter(const Finding& f, const std::string& name) {
  for (const auto* list : {&f.witness->parameters, &f.witness->angles})
    for (const auto& [key, value] : *list)
      if (key == name) return value;
  return NAN;
}

TEST(Energy, WorstCaseOfOrenNayarIsFound) {
  const Finding f = energy_of("oren_nayar", 90);
  EXPECT_NEAR(f.value, 1.015179, 1e-6);
  EXPECT_NEAR(parameter(f, "sigma"), 0.198533, 1e-3);
  EXPECT_NEAR(parameter(f, "theta"), 90, 1e-6);
}

TEST(Energy, WorstCaseOfWardDuerIsFound) {
  const Finding f = energy_of("ward_duer");
  EXPECT_NEAR(f.value, 13.39, 0.05);
  EXPECT_NEAR(parameter(f, "alpha_x"), 0.92, 0.02);
  EXPECT_LT(parameter(f, "alpha_y"), 2e-4);
  EXPECT_NE(f.statement.find("grows as 1/cos"), std::string::npos);
  ASSERT_TRUE(f.tied);
  EXPECT_NEAR(f.tied->value, 10.138, 0.005);
  const auto& widths = f.tied->witness.parameters;
  const auto width = [&](const std::string& name) {
    return std::find_if(widths.begin(), widths.end(), [&](const auto& p) { return p.first == name; })->second;
  };
  EXPECT_NEAR(width("alpha_x"), 0.617, 0.005);
  EXPECT_EQ(width("alpha_x"), width("alpha_y"));
}

TEST(Energy, WorstCaseOfBlinnPhongWithEightIsFound) {
  const Finding f = energy_of("blinn_phong_n8");
  EXPECT_NEAR(f.value, 1.075201, 2e-6);
  EXPECT_NEAR(parameter(f, "exponent"), 8.764, 0.1);
  EXPECT_NEAR(parameter(f, "theta"), 0, 0.5);
}

TEST(Energy, WorstCaseOfPiInPlaceOfFourIsFound) {
  EXPECT_NEAR(energy_of("cook_torrance_1982").value, 4 / kPi, 1e-4);
}

TEST(Energy, WorstCaseOfTheFullOrenNayarFormIsFound) {
  const Finding f = energy_of("oren_nayar_full", 90);
  EXPECT_NEAR(f.value, 1.051, 5e-4);
  EXPECT_NEAR(parameter(f, "sigma"), 0.304, 0.01);
}

TEST(Energy, OfConservingFormsRaisesNoAlarm) {
  for (const char* form : {"lambert", "phong", "blinn_phong", "cook_torrance", "cook_torrance_beckmann",
                           "ward_bounded", "oren_nayar_energy"}) {
    const Finding f = energy_of(form);
    EXPECT_EQ(f.outcome, Outcome::pass) << form << ": " << f.statement;
    EXPECT_NEAR(f.value, 1, 1e-6) << form;
  }
}

TEST(Reciprocity, OfThePrintedCookTorranceFormIsBroken) {
  const Finding f = check_reciprocity(Subject::form(cook_torrance_as_printed{}), {});
  EXPECT_EQ(f.outcome, Outcome::fail);  // not yet compared with the form's declaration
  EXPECT_GT(f.value, 0.9);
}

TEST(Reciprocity, OfCanonicalFormsHoldsToRounding) {
  for (const char* form : {"oren_nayar", "phong", "blinn_phong", "ward", "cook_torrance"}) {
    const Finding f = check_reciprocity(Subject::form(find_form(form).value()), {});
    EXPECT_LT(f.value, 1e-14) << form;
  }
}

TEST(NonNegative, TheFullOrenNayarFormIsNegativeSomewhere) {
  const Finding f = check_non_negative(Subject::form(oren_nayar_full{}), {});
  EXPECT_LT(f.value, -0.017);
  EXPECT_GT(f.value, -0.02);
}

TEST(Continuity, ALobeDividedByItsCosineJumpsAtTheHorizon) {
  EXPECT_EQ(check_continuity(Subject::form(phong_classic{}), {}).outcome, Outcome::fail);
  EXPECT_EQ(check_continuity(Subject::form(phong{}), {}).outcome, Outcome::pass);
}

TEST(Isotropy, AnAnisotropicMaterialIsSymmetricAboutItsTangent) {
  Material m = make_material(cook_torrance{});
  m.terms[0].shape = {{0.1, 0.4}};
  m.terms[0].tangent_phi = radians(0.4);
  const Finding f = check_isotropy(Subject::material("m.json", m), {});
  EXPECT_EQ(f.outcome, Outcome::pass) << f.value;
  EXPECT_NE(f.statement.find("22.9 degrees"), std::string::npos) << f.statement;
}

TEST(Judgement, FoundAndDeclaredIsKnown) {
  const auto findings = run_checks({Subject::form(blinn_phong_n8{})}, {});
  const auto energy =
      std::find_if(findings.begin(), findings.end(), [](const Finding& f) { return f.check == "energy"; });
  EXPECT_EQ(energy->outcome, Outcome::known_violation);
}

TEST(Judgement, EveryCheckOfEveryFormIsAsDeclared) {
  std::vector<Subject> subjects;
  for (std::size_t k = 0; k < catalogue().size(); k += thorough() ? 1 : 5)
    subjects.push_back(Subject::form(catalogue()[k]));
  for (const Finding& f : run_checks(subjects, {}))
    EXPECT_NE(f.outcome, Outcome::fail) << f.subject << " " << f.check << ": " << f.statement;
}

TEST(Judgement, AMaterialAboveOneFails) {
  Material m = make_material(lambert{});
  m.terms[0].weights[1][0] = 1.2;
  for (const Finding& f : run_checks({Subject::material("m.json", m)}, {}))
    EXPECT_EQ(f.outcome == Outcome::fail, f.check == "energy") << f.check;
}

TEST(Witness, ReproducesTheValue) {
  const Finding f = energy_of("blinn_phong_n8");
  EXPECT_EQ(
      f.witness->command.find("brdf albedo --form blinn_phong_n8 --set kd=0 --set ks=1 --set exponent="), 0u)
      << f.witness->command;
}

}  // namespace
}  // namespace brdf::validate
