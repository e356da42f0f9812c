// A view at rest, as the window shows it.
#include <gtest/gtest.h>

#include "render/compare/pictures.h"
#include "render/compare/supersample.h"
#include "tests/render/furnace.h"

namespace brdf::render {
namespace {

Scene ball() {
  Scene scene = material_scene({{"m", make_material(*find_form("cook_torrance"))}});
  scene.camera.width = scene.camera.height = 40;
  return scene;
}

TEST(Standing, AddsUpToTheSavedPicture) {
  Device device;
  const PreparedScene scene = prepare(ball());
  Renderer renderer(device, scene);
  Standing standing(device, renderer);
  for (int k = 0; k < 16; ++k) standing.draw_next(scene, 4, nullptr);
  const Picture shown = picture_from(40, 40, read_rgba(device, standing.shown()));
  const Picture saved = supersampled(scene, 4, [&](const PreparedScene& moved) {
    renderer.update(moved);
    renderer.draw();
    return picture_from(40, 40, renderer.read_color());
  });
  for (std::size_t k = 0; k < shown.pixels.size(); ++k)
    EXPECT_EQ(glm::vec3(shown.pixels[k]), glm::vec3(saved.pixels[k])) << k;
}

TEST(Standing, BringsWholeRoundsOfPlaces) {
  EXPECT_EQ(Standing::wanted(4, 0), 16);
  EXPECT_EQ(Standing::wanted(4, 1000), 64);
  EXPECT_EQ(Standing::wanted(4, 1040), 80);
  EXPECT_EQ(Standing::wanted(1, 4 * kRun), 4);
}

TEST(Standing, BringsAllSamplesHoweverFewAtATime) {
  EXPECT_EQ(Standing::wanted(4, 1000, 1), 1008);
  Device device;
  const PreparedScene scene = sphere_in(make_material(*find_form("cook_torrance")), "studio", 24);
  Renderer renderer(device, scene);
  Standing whole(device, renderer), parts(device, renderer);
  for (int k = 0; k < 64; ++k) whole.draw_next(scene, 1, nullptr);
  for (int k = 0; k < 256; ++k) parts.draw_next(scene, 1, nullptr, 4);
  // The same 1,024 points, except for rounding, divided into other runs.
  const std::vector<float> a = read_rgba(device, whole.shown()), b = read_rgba(device, parts.shown());
  double sum = 0, apart = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_NEAR(a[k], b[k], 1e-4f + 5e-3f * std::abs(a[k])) << k;
    sum += double(a[k]);
    apart += double(a[k] - b[k]);
  }
  EXPECT_LT(std::abs(apart), 1e-4 * sum);
}

TEST(Pace, BringsAsManySamplesAsThereIsTimeFor) {
  Pace pace(true);
  const int first = pace.run();
  pace.begin();
  EXPECT_EQ(pace.run(), first);  // no time is known yet
  pace.took(1000.0 * first);
  EXPECT_EQ(pace.run(), first) << "the same for the whole picture";
  EXPECT_TRUE(pace.too_slow());
  pace.begin();
  EXPECT_EQ(pace.run(), 1);
  EXPECT_FALSE(pace.too_slow()) << "there is no less";
  pace.took(0.01);
  pace.begin();
  EXPECT_EQ(pace.run(), kRun);
  Pace fixed(false);
  fixed.took(1e6);
  fixed.begin();
  EXPECT_EQ(fixed.run(), kRun);
  EXPECT_FALSE(fixed.too_slow());
}

TEST(Standing, TellsLessNoiseWithMorePictures) {
  Device device;
  const PreparedScene scene = sphere_in(make_material(*find_form("cook_torrance")), "studio", 24);
  Renderer renderer(device, scene);
  Standing standing(device, renderer);
  const auto noise_after = [&](int pictures) {
    while (standing.pictures() < pictures) standing.draw_next(scene, 4, nullptr);
    return standing.noise();
  };
  const double few = noise_after(8), many = noise_after(128);  // independent runs give a factor of 4
  EXPECT_GT(few, 2 * many);
  EXPECT_LT(few, 10 * many);
  EXPECT_GT(many, 0);
}

TEST(Standing, TheWindowRestsWhenItsPictureIsSmooth) {
  Device device;
  ViewState state;
  state.scene = ball();
  Pictures pictures(device, {}, 64, {}, true);
  const auto updates = [&] {
    int count = 0;
    do pictures.update(state, {40, 40});
    while (++count < 1000 && pictures.unfinished());
    return count;
  };
  EXPECT_EQ(updates(), 17);  // at the pixels' centres, then through 16 positions
  EXPECT_EQ(updates(), 1);   // no change
  state.scene.camera.position.x += 1;
  EXPECT_EQ(updates(), 17);
  state.display = Display::difference;  // compared with Embree, at the centres again
  EXPECT_EQ(updates(), 1);
  ASSERT_TRUE(pictures.difference());
  EXPECT_LT(pictures.difference()->rel_mse, 1e-6);
  state.display = Display::picture;
  EXPECT_EQ(updates(), 17);
}

}  // namespace
}  // namespace brdf::render
