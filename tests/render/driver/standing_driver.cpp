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

// A pace that stops as soon as this many milliseconds have passed; each look at the clock takes `step`.
Pace stepping(double step) {
  return Pace([now = 0.0, step]() mutable { return now += step; });
}

// Draws until the plan is complete.
void complete(Standing& standing, const PreparedScene& scene) {
  Pace pace = stepping(0);
  while (!standing.finished()) {
    pace.begin_frame();
    standing.go_on(scene, pace, nullptr);
  }
}

TEST(Standing, AddsUpToTheSavedPicture) {
  Device device;
  const PreparedScene scene = prepare(ball());
  Renderer renderer(device, scene);
  Standing standing(device, renderer, {});
  complete(standing, scene);
  const Picture shown = picture_from(40, 40, read_rgba(device, standing.shown()));
  const Picture saved = supersampled(scene, 4, [&](const PreparedScene& moved) {
    renderer.update(moved);
    renderer.draw();
    return picture_from(40, 40, renderer.read_color());
  });
  for (std::size_t k = 0; k < shown.pixels.size(); ++k)
    EXPECT_EQ(glm::vec3(shown.pixels[k]), glm::vec3(saved.pixels[k])) << k;
}

TEST(Standing, InAnEnvironmentTheLastPictureIsTheOneOfTheCommandLine) {
  Device device;
  ViewState state;
  state.scene = sphere_in(make_material(*find_form("cook_torrance")), "studio", 70).scene;
  Pictures window(device, {}, 64, {}, Effort::refining, [now = 0.0]() mutable { return now += 10; });
  int updates = 0;
  do window.update(state, {70, 70});
  while (window.unfinished() && ++updates < 10000);
  EXPECT_GT(updates, 32) << "the 17 pictures were not drawn in parts";
  Pictures whole(device, {}, 64);
  whole.update(state, {70, 70});
  const Picture shown = picture_from(70, 70, read_rgba(device, const_cast<Image&>(window.a_image())));
  for (std::size_t k = 0; k < shown.pixels.size(); ++k)
    EXPECT_EQ(glm::vec3(shown.pixels[k]), glm::vec3(whole.fine_a().pixels[k])) << k;
}

TEST(Standing, TwoMaterialsInAnEnvironmentAreRefinedAndCompared) {
  Device device;
  ViewState state;
  state.scene = sphere_in(make_material(*find_form("cook_torrance")), "studio", 40).scene;
  state.other = Other::material;
  state.material = make_material(*find_form("lambert"));
  state.display = Display::split;
  Pictures window(device, {}, 64, {}, Effort::refining, [] { return 0.0; });
  const auto rest = [&] {
    int count = 0;
    do window.update(state, {40, 40});
    while (++count < 1000 && window.unfinished());
    return count;
  };
  EXPECT_EQ(rest(), 10);  // a smooth picture and four runs of each material
  Pictures whole(device, {}, 64);
  whole.update(state, {40, 40});
  ASSERT_TRUE(window.difference());
  EXPECT_NEAR(window.difference()->rel_mse, whole.difference()->rel_mse, 1e-4 * whole.difference()->rel_mse);
  state.display = Display::picture;
  EXPECT_EQ(rest(), 17) << "B is not drawn if it is not shown";
}

TEST(Standing, PlansWholeRoundsOfPlacesWithAllSamples) {
  EXPECT_EQ(standing_plan(4, 0), (StandingPlan{16, 4, 1}));
  EXPECT_EQ(standing_plan(4, 64), (StandingPlan{16, 4, 4}));
  EXPECT_EQ(standing_plan(4, 256), (StandingPlan{16, 4, kRun}));
  EXPECT_EQ(standing_plan(4, 1024), (StandingPlan{64, 4, kRun}));
  EXPECT_EQ(standing_plan(1, 64), (StandingPlan{4, 1, kRun}));
  for (const int samples : {1, 63, 257, 1000, 1040}) {
    const StandingPlan plan = standing_plan(4, samples);
    EXPECT_GE(plan.pictures * plan.run, samples);
    EXPECT_EQ(plan.pictures % 16, 0);
    EXPECT_LE(plan.run, kRun);
  }
}

TEST(Standing, APictureInPartsHasTheBytesOfTheWholePicture) {
  Device device;
  const PreparedScene scene = sphere_in(make_material(*find_form("cook_torrance")), "studio", 150);
  Renderer whole(device, scene), parts(device, scene);
  ASSERT_GT(parts.parts(), 9) << "nine tiles and the mesh";
  for (const bool smooth : {false, true}) {
    smooth ? whole.draw_smooth() : whole.draw_samples(0, nullptr, 32, 4);
    smooth ? parts.begin_smooth() : parts.begin_run({4, 32, 1, 1});
    for (int part = 0; part < parts.parts(); part += 2)
      parts.draw_parts(part, std::min(2, parts.parts() - part));
    EXPECT_EQ(whole.read_color(), parts.read_color()) << smooth;
  }
}

// The mean relative distance of two pictures' colours, over the pixels with light.
double distance(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0, size = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (k % 4 == 3) continue;
    sum += std::abs(double(a[k]) - double(b[k]));
    size += double(b[k]);
  }
  return sum / size;
}

TEST(Standing, TheSmoothPictureIsNearTheExactOneAndHasNoNoise) {
  Device device;
  for (const char* name : {"cook_torrance", "ward", "phong", "oren_nayar", "lambert"}) {
    const PreparedScene scene = sphere_in(make_material(*find_form(name)), "studio", 24);
    Renderer renderer(device, scene), seeded(device, scene, {.seed = 77});
    renderer.draw_smooth();
    seeded.draw_smooth();
    const std::vector<float> smooth = renderer.read_color();
    EXPECT_EQ(smooth, seeded.read_color()) << "depends on random numbers: " << name;
    EXPECT_EQ(renderer.samples(), 0);
    renderer.draw_samples(1024);
    EXPECT_LT(distance(smooth, renderer.read_color()), 0.25) << name;
  }
}

TEST(Standing, TheSmoothPictureInUniformLightIsUniform) {
  Device device;
  const PreparedScene scene = sphere_in(make_material(*find_form("lambert")), "uniform", 24);
  Renderer renderer(device, scene);
  renderer.draw_smooth();
  const std::vector<float> smooth = renderer.read_color();
  renderer.draw_samples(1024);
  // The cosine's own directions are exact for a Lambertian surface in uniform light.
  EXPECT_LT(distance(smooth, renderer.read_color()), 0.01);
}

TEST(Pace, DrawsAsManyPartsAsTheFrameHasTimeFor) {
  double now = 0;
  Pace pace([&] { return now; });
  PartTimes times;
  pace.begin_frame();
  const int first = pace.next(times, 0, 100);
  EXPECT_GE(first, 1);
  EXPECT_LE(first, 10) << "parts that were never drawn are not assumed to be free";
  now += 4.0 * first;
  pace.took(times, 0, first);
  EXPECT_EQ(times.of(0), 4);
  for (int part = 0; part < 100; ++part) times.set(part, 4);
  pace.begin_frame();
  EXPECT_EQ(pace.next(times, 0, 100), int(Pace::kPatience / 4));
  now += Pace::kPatience;
  pace.took(times, 0, int(Pace::kPatience / 4));
  EXPECT_EQ(pace.next(times, 6, 100), 0) << "the frame's time is spent";
  pace.begin_frame();
  for (int part = 0; part < 100; ++part) times.set(part, 1000);
  EXPECT_EQ(pace.next(times, 0, 100), 1) << "each frame makes progress";
  EXPECT_EQ(pace.next(times, 99, 99), 0);
}

TEST(Pace, MovementsAreCoarserIfAPictureTakesMoreThanAFrame) {
  Coarseness coarseness;
  EXPECT_EQ(coarseness.across(), 2);
  coarseness.took(9000);  // compiles shaders
  EXPECT_EQ(coarseness.across(), 2);
  for (int k = 0; k < 10; ++k) coarseness.took(10);
  EXPECT_EQ(coarseness.across(), 2);
  for (int k = 0; k < 100; ++k) coarseness.took(40);
  EXPECT_EQ(coarseness.across(), 4);
}

TEST(Standing, NoiseIsThatOfTheShownPicture) {
  Device device;
  const PreparedScene scene = sphere_in(make_material(*find_form("cook_torrance")), "studio", 24);
  Renderer renderer(device, scene);
  Standing few(device, renderer, {8, 4, kRun});
  complete(few, scene);
  const double noisy = few.noise();
  Standing many(device, renderer, {128, 4, kRun});
  Pace pace = stepping(0);
  double early = 0;
  while (!many.finished()) {
    pace.begin_frame();
    if (many.go_on(scene, pace, nullptr) && many.pictures() == 8) early = many.noise();
  }
  EXPECT_GT(noisy, 2 * many.noise());  // independent runs give a factor of 4
  EXPECT_LT(noisy, 10 * many.noise());
  EXPECT_GT(many.noise(), early) << "the smooth picture fades";
  EXPECT_GT(early, 0);
}

TEST(Standing, TheWindowRestsWhenItsPictureIsSmooth) {
  Device device;
  ViewState state;
  state.scene = ball();
  Pictures pictures(device, {}, 64, {}, Effort::refining, [] { return 0.0; });
  const auto updates = [&] {
    int count = 0;
    do pictures.update(state, {40, 40});
    while (++count < 1000 && pictures.unfinished());
    return count;
  };
  EXPECT_EQ(updates(), 17);  // at the pixels' centres, then through 16 places
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
