// In two thousand random shaders with planted violations the prover proves no property that is violated.
// It proves most of five hundred sound shaders within a second each.
#include <iostream>

#include <gtest/gtest.h>

#include "prove/shader/self_test.h"

namespace brdf::prove {
namespace {

TEST(Campaign, OfPlantedViolationsProvesNoneAndOfSoundShadersMost) {
  SelfTestOptions options;
  options.planted = 2000, options.sound = 500, options.samples = 2'000'000, options.seconds = 1,
  options.seed = 2026;
  const SelfTest t = self_test(options);
  EXPECT_EQ(t.planted, 2000);
  EXPECT_EQ(t.sound, 500);
  EXPECT_EQ(t.falsely_proved, 0);
  EXPECT_GE(t.sound_proved, 400);
  EXPECT_GE(t.samples_float, 1'000'000);
  EXPECT_GE(t.samples_double, 1'000'000);
  EXPECT_TRUE(t.good()) << (t.faults.empty() ? "" : t.faults.front());
  std::cout << t.sound_proved << " of " << t.sound << " sound shaders proved\n";
}

}  // namespace
}  // namespace brdf::prove
