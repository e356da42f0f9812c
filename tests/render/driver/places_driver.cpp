// Pictures through several places of the pixels, added up on the device.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/error.h"
#include "render/compare/pictures.h"
#include "render/compare/supersample.h"
#include "tests/render/furnace.h"

namespace brdf::render {
namespace {

PreparedScene studio_ball(int size) {
  return sphere_in(make_material(*find_form("cook_torrance")), "studio", size, 30);
}

// The picture with one sample of the light, the k-th of the sequence, through a place.
std::vector<float> picture_of_sample(Renderer& renderer, PreparedScene scene, const glm::vec2& place, int k) {
  scene.scene.camera.offset = place;
  renderer.update(scene);
  renderer.draw_samples(1, nullptr, k, 1);
  return renderer.read_color();
}

void expect_near(const std::vector<float>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    ASSERT_NEAR(double(found[k]), expected[k], 1e-5 * std::abs(expected[k]) + 1e-6) << k;
}

TEST(Places, TheirSumIsTheMeanOfTheirPicturesAndTheDifferenceTheOneOfTheHalves) {
  Device device;
  for (const int across : {2, 3}) {  // four places, and an odd number
    PreparedScene scene = studio_ball(20);
    Renderer renderer(device, scene), single(device, scene);
    PlaceSums sums = renderer.place_sums();
    const std::vector<glm::vec2> places = sample_places(across);
    std::vector<double> mean(20 * 20 * 4), difference(mean.size());
    int first = 0;
    for (const int run : {1, 2, 3}) {  // weights 1, 2 and 3
      const StandingPlan plan{int(places.size()), across, run};
      for (int k = 0; k < plan.pictures; ++k) {
        const PlaceRun of_place = run_of(plan, k, first);
        scene.scene.camera.offset = places[std::size_t(k)];
        renderer.update(scene);
        renderer.draw_place(sums, of_place);
        for (int s = 0; s < run; ++s) {
          const std::vector<float> one =
              picture_of_sample(single, scene, places[std::size_t(k)], of_place.first + s * of_place.stride);
          for (std::size_t c = 0; c < one.size(); ++c) {
            mean[c] += double(one[c]);
            // The background has no samples.
            if (c % 4 < 3 && one[c / 4 * 4 + 3] > 0.5f)
              difference[c] += double(of_place.sign) * (2 * s < run ? 1 : -1) * double(one[c]);
          }
        }
      }
      first += run * plan.pictures;
    }
    for (double& value : mean) value /= first;
    for (double& value : difference) value /= first;
    expect_near(sums.mean(), mean);
    expect_near(sums.difference(), difference);
  }
}

TEST(Places, EveryPictureOfARoundHasItsOwnSamples) {
  for (const auto& [across, run] : {std::pair{4, 4}, {3, 5}, {2, 16}}) {
    const StandingPlan plan{2 * across * across, across, run};
    std::vector<int> drawn(std::size_t(plan.pictures * run + 7));
    float signs = 0;
    for (int k = 0; k < plan.pictures; ++k) {
      const PlaceRun one = run_of(plan, k, 7);
      signs += one.sign;
      for (int s = 0; s < one.samples; ++s) ++drawn.at(std::size_t(one.first + s * one.stride));
    }
    for (std::size_t s = 0; s < drawn.size(); ++s) EXPECT_EQ(drawn[s], s < 7 ? 0 : 1) << s;
    EXPECT_EQ(signs, run % 2 == 1 ? 0 : plan.pictures);
  }
}

// Returns the root mean square error of the surface over its mean.
double true_noise(const Picture& picture, const Picture& truth) {
  double squares = 0, sum = 0;
  for (std::size_t k = 0; k < truth.pixels.size(); ++k) {
    if (!is_surface(truth.pixels[k])) continue;
    for (int c = 0; c < 3; ++c) {
      squares += square(double(picture.pixels[k][c]) - double(truth.pixels[k][c]));
      sum += double(truth.pixels[k][c]);
    }
  }
  const auto count = double(3 * std::ranges::count_if(truth.pixels, is_surface));
  return std::sqrt(squares / count) / (sum / count);
}

TEST(Places, TheStatedNoiseIsNearTheTrueErrorAndNotBelowIt) {
  Device device;
  ViewState state;
  state.scene = studio_ball(64).scene;
  Pictures many(device, {}, 8192);
  many.update(state, {64, 64});
  const Picture truth = many.fine_a();
  for (const int samples : {16, 48, 64, 256}) {  // runs of 1, 3, 4 and 16
    Pictures few(device, {}, samples);
    few.update(state, {64, 64});
    const double stated = (few.fine_a(), few.noise()), found = true_noise(few.fine_a(), truth);
    RecordProperty("stated_" + std::to_string(samples), std::to_string(stated));
    RecordProperty("found_" + std::to_string(samples), std::to_string(found));
    EXPECT_EQ(few.samples_drawn(), samples);
    EXPECT_GT(stated, found) << samples;
    EXPECT_LT(stated, 2 * found) << samples;
  }
}

TEST(Places, TheSumsCountInTheMemoryThatIsCheckedFirst) {
  Scene scene = studio_ball(64).scene;
  EXPECT_EQ(picture_bytes(scene, {.has_places = true}) - picture_bytes(scene, {}), 2u * 64 * 64 * 16);
  Device device(
      {.memory_limit = picture_bytes(scene, {.has_places = true})});  // no room for the light's picture
  ViewState state;
  state.scene = scene;
  Pictures pictures(device, {}, 16);
  try {
    pictures.update(state, {64, 64});
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("a picture of 64 x 64 needs "));
  }
}

TEST(Places, ANoiseIsReachedOrTheLimitIsAndEveryPlaceIsDrawn) {
  Device device;
  ViewState state;
  state.scene = studio_ball(32).scene;
  const auto drawn = [&](double noise, int most) {
    Pictures pictures(device, {}, 16, {.noise = noise, .most_samples = most});
    pictures.update(state, {32, 32});
    pictures.fine_a();
    return std::pair(pictures.samples_drawn(), pictures.noise());
  };
  const auto [few, reached] = drawn(0.08, 1024);
  EXPECT_LE(reached, 0.08);
  EXPECT_GE(few, 16);
  EXPECT_LT(few, 256);
  const auto [most, missed] = drawn(0.001, 100);
  EXPECT_EQ(most, 96);  // whole sweeps of 16 places
  EXPECT_GT(missed, 0.001);
  EXPECT_EQ(drawn(0.001, 4).first, 16) << "one sample at each place";
}

TEST(Places, ASceneWithoutLightsEqualsTheOneWithALightOfNoPower) {
  Device device;
  const PreparedScene scene = studio_ball(40);
  PreparedScene with_light = scene;
  with_light.scene.lights.push_back({false, {0, -1, 0}, glm::vec3(0)});
  Renderer without(device, scene), with(device, with_light);
  without.draw_samples(kRun);
  with.draw_samples(kRun);
  EXPECT_EQ(without.read_color(), with.read_color());
}

}  // namespace
}  // namespace brdf::render
