// Tests `brdf render` and `brdf view` through the executable: error cases and results.
#ifdef BRDF_HAS_RENDER
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "io/files/json.h"
#include "render/picture/picture.h"
#include "render/scene/camera_view.h"
#include "render/scene/texture.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kLambert =
    R"({"format":"brdf-material","version":1,"form":"lambert","channels":["r","g","b"],"weights":{"rho":[0.6,0.4,0.2]}})";

class RenderCli : public testing::Test {
 protected:
  void SetUp() override {
    write("m.json", kLambert);
    if (run("render m.json --width 8 --height 8 -o first.png").exit_code == 3)
      GTEST_SKIP() << "no Vulkan driver";
    std::filesystem::remove(folder_.path() / "first.png");
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  // Writes scene.json, a scene of one object with these additional keys.
  void write_scene(const std::string& keys) {
    write("scene.json", R"({"format":"brdf-scene","version":1,"camera":{"width":64,"height":64},)"
                        R"("lights":[{"type":"directional","direction":[1,-1,-1],"intensity":3}],)"
                        R"("objects":[{"material":)" +
                            kLambert + "," + keys + "}]}");
  }
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }
  std::set<std::string> names() {
    std::set<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      out.insert(entry.path().filename().string());
    return out;
  }
  // Expects one line on stderr that contains `what`, nothing on stdout, no new file, and the old picture
  // unchanged.
  void expect_refused(const std::string& arguments, int exit_code, const std::string& what) {
    write("x.png", "old");
    const auto before = names();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments << "\n" << outcome.err;
    EXPECT_THAT(outcome.err, testing::StartsWith("brdf: ")) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(what)) << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(names(), before) << arguments;
    EXPECT_EQ(file_text(folder_.path() / "x.png"), "old") << arguments;
  }
  io::TemporaryFolder folder_;
};

TEST_F(RenderCli, WithoutADriverOrADisplayTheEnvironmentIsToBlame) {
  {
    const Setting driver("VK_DRIVER_FILES", "/nonexistent"), older("VK_ICD_FILENAMES", "/nonexistent");
    expect_refused("render m.json -o x.png", 3, "no Vulkan driver");
  }
#ifdef BRDF_HAS_VIEWER
  const Setting display("DISPLAY", nullptr), wayland("WAYLAND_DISPLAY", nullptr);
  expect_refused("view m.json", 3, "no display");
#endif
}

TEST_F(RenderCli, BrokenTexturesAreNamed) {
  write_scene(R"("textures":{"albedo":"absent.png"})");
  expect_refused("render --scene scene.json -o x.png", 2, "absent.png: no such texture file");
  write("bad.png", "hello");
  write_scene(R"("textures":{"roughness":"bad.png"})");
  expect_refused("render --scene scene.json -o x.png", 2, "bad.png: cannot be read as PNG, JPEG, BMP or TGA");
  write("cut.png", file_text(BRDF_SOURCE_DIR "/docs/img/car.png").substr(0, 300));
  write_scene(R"("textures":{"normal":"cut.png"})");
  expect_refused("render --scene scene.json -o x.png", 2, "cut.png: cannot be read");
}

TEST_F(RenderCli, BrokenModelsAreNamed) {
  const auto refused = [&](const std::string& model, const std::string& what) {
    write("model.obj", model);
    write_scene(R"("mesh":"model.obj")");
    expect_refused("render --scene scene.json -o x.png", 2, "model.obj: " + what);
    expect_refused("render --scene scene.json --compare embree -o x.exr", 2, "model.obj: " + what);
  };
  refused("this is no model", "");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n", "cannot be read as a model");
  refused("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n", "has no triangle with an area");
  refused("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "vertex 1 is not finite");
  refused("v 1e39 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "vertex 1 is not finite");
}

TEST_F(RenderCli, TrianglesWithoutAreaAreLeftOut) {
  write("model.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 2\nf 1 2 3\nf 3 3 3\n");
  write_scene(R"("mesh":"model.obj")");
  const Outcome outcome = run("render --scene scene.json --compare embree --json -o x.exr");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const io::Json json = io::parse_json(outcome.out, "stdout");
  EXPECT_LT(json["rel_mse"].get<double>(), 1e-6);
  EXPECT_LE(json["coverage_mismatch"].get<double>(), 1e-3);
  const render::Picture picture = render::read_exr(folder_.path() / "x.exr", "");
  EXPECT_EQ(picture.at(32, 32).a, 1);
  for (const glm::vec4& p : picture.pixels) ASSERT_TRUE(std::isfinite(p.r + p.g + p.b));
}

TEST_F(RenderCli, AnEnvironmentLightsAMaterialAlone) {
  const Outcome outcome =
      run("render m.json --environment uniform --samples 100 --width 16 --height 16 --compare embree --json "
          "-o x.exr");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const io::Json json = io::parse_json(outcome.out, "stdout");
  EXPECT_EQ(json["samples"].get<int>(), 112);  // whole runs of 16
  EXPECT_GT(json["noise"].get<double>(), 0);
  EXPECT_LT(json["noise"].get<double>(), 0.05);
  const render::Picture picture = render::read_exr(folder_.path() / "x.exr", "");
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(picture.at(8, 8)[c], 0.6 - 0.2 * c, 0.02);
  EXPECT_EQ(picture.at(0, 0), glm::vec4(1, 1, 1, 0));
}

TEST_F(RenderCli, WhatIsNoEnvironmentIsRefused) {
  write("text.hdr", "text");
  expect_refused("render m.json --environment text.hdr -o x.png", 2,
                 "text.hdr: is neither a Radiance picture (.hdr) nor an OpenEXR one");
  expect_refused("render m.json --environment none.exr -o x.png", 2, "none.exr: no such file");
  expect_refused("render m.json --environment dusk -o x.png", 2, "dusk: no such file");
  expect_refused("render m.json --environment '' -o x.png", 2, "--environment: the value is empty");
  expect_refused("render m.json --environment " + std::string(300, 'a') + " -o x.png", 2,
                 ": cannot be used: File name too long");
  expect_refused("render m.json --hard-light --rotate 30 -o x.png", 2, "--rotate rotates an environment");
  expect_refused("render m.json --environment studio --forward -o x.png", 2, "the deferred path");
  expect_refused("render m.json --environment studio --shading phong -o x.png", 2, "needs the shading brdf");
}

TEST_F(RenderCli, OptionsWithoutEffectAreRefused) {
  for (const auto& [option, needed] :
       {std::pair{"--balls 3", "--balls requires --over"},
        std::pair{"--fps 30", "--fps requires --turntable"},
        std::pair{"--quality 9", "--quality requires --turntable"},
        std::pair{"--per-vertex", "--per-vertex: applies to the shadings of the articles"},
        std::pair{"--as-coded", "--as-coded: applies to the shadings of the articles"},
        std::pair{"--set ks=0.1", "--set: has no effect without --shader"},
        std::pair{"--split-at 0.4",
                  "--split-at: has no effect on a picture without --compare, --measured and --state"}})
    expect_refused(std::string("render m.json -o x.png ") + option, 2, needed);
  expect_refused("lobes m.json --body --solo 'A r' -o x.png", 2, "--solo: has no effect on a lobe's body");
  expect_refused("maps lookup --seed 2 -o x", 2, "--seed: has no effect on lookup");
}

TEST_F(RenderCli, TheOldSpellingsOfLobesAndMapsSayTheNewOnes) {
  const Outcome old = run("render m.json --lobe3d --width 60 -o old.png"),
                now = run("lobes m.json --body --width 60 -o now.png");
  EXPECT_EQ(old.exit_code, 0) << old.err;
  EXPECT_EQ(old.err, "brdf render --lobe3d: is `brdf lobes --body` now; the old spelling goes with 0.3\n");
  EXPECT_EQ(now.err, "");
  EXPECT_EQ(file_text(folder_.path() / "old.png"), file_text(folder_.path() / "now.png"));
  EXPECT_EQ(run("render --maps tiles --size 8 -o tiles").exit_code, 0);
  for (const auto& [command, option] :
       {std::pair{"render m.json --lobes --tone-map reinhard -o x.png", "--tone-map"},
        std::pair{"render m.json --lobes --maps tiles -o x.png", "--lobes"}}) {
    const Outcome refused = run(command);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr(std::string(option) + " is not an option of brdf"));
  }
}

TEST_F(RenderCli, TooLargeAPictureIsRefusedAtOnce) {
  expect_refused("render m.json --hard-light --width 16384 --height 16384 --memory-limit 1G -o x.png", 2,
                 "a picture of 16384 x 16384 needs 27648 MiB of device memory, but the limit is 1024 MiB");
  expect_refused("render m.json --memory-limit 1M -o x.png", 2, "the limit is 1 MiB");
}

TEST_F(RenderCli, WrongUsageIsExplained) {
  expect_refused("render m.json", 2, "-o is required");
  expect_refused("render m.json -o x.tiff", 2, "must end in .exr or .png");
  for (const char* name : {"nowhere/x.png", "nowhere/x.exr"})
    expect_refused("render m.json -o " + std::string(name), 2, std::string(name) + ": cannot be written");
  expect_refused("render m.json --show wrong -o x.png", 2, "must be one of picture, split");
  expect_refused("render m.json --show split -o x.png", 2, "needs --compare or --measured");
  expect_refused("render m.json --compare absent.json -o x.png", 2, "absent.json: cannot be read");
  expect_refused("render m.json --compare embree --shading phong -o x.png", 2, "needs the shading brdf");
  expect_refused("render m.json --gbuffer --shading phong -o x.png", 2, "without the seven targets");
  expect_refused("render m.json --probe 600,2", 2, "outside the picture of 512 x 512");
  expect_refused("lobes m.json --solo 'A q' -o x.png", 2, "must be one of A r, A g, A b");
  expect_refused("render --state m.json -o x.png", 2, "must be \"brdf-view\"");
  expect_refused("render --state m.json m.json -o x.png", 2, "give no other input with it");
  expect_refused("render m.json --exposure bright -o x.png", 2, "must be a finite number, or auto");
  expect_refused("render m.json --exposure 21 -o x.png", 2, "must be a number from -20 to 20");
  expect_refused("render m.json --supersample 0 -o x.png", 2, "0: must be a whole number from 1 to 16");
  expect_refused("parity", 2, "parity needs --all, --form or --shader");
}

TEST_F(RenderCli, AFittedMaterialHasItsHighlightWhereItBelongsAndNothingClipped) {
  for (const std::string name : {"cook_torrance_metal", "phong", "ward", "blinn_phong"}) {
    const std::string form = name.starts_with("cook") ? "cook_torrance" : name;
    ASSERT_EQ(
        run("fit '" BRDF_SOURCE_DIR "/data/synthetic/" + name + ".csv' --form " + form + " -o fitted.json")
            .exit_code,
        0);
    const Outcome outcome = run("render fitted.json --json --width 240 --height 240 -o x.exr");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_LT(io::parse_json(outcome.out, "stdout")["clipped"].get<double>(), 0.01) << name;
    const render::Picture picture = render::read_exr(folder_.path() / "x.exr", "");
    int best_x = 0, best_y = 0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        if (picture.at(x, y).a > 0.5f && picture.at(x, y).g > picture.at(best_x, best_y).g)
          best_x = x, best_y = y;
      }
    }
    // On the unit sphere the normal equals the point. The light travels along (1, -1, -1).
    render::Camera camera;
    camera.width = picture.width;
    camera.height = picture.height;
    const glm::vec3 ray = glm::normalize(
        make_view(camera).ray(render::pixel_center(best_x, best_y, camera.width, camera.height)));
    const float b = glm::dot(camera.position, ray);
    const glm::vec3 n =
        camera.position + ray * (-b - std::sqrt(b * b - glm::dot(camera.position, camera.position) + 1));
    const glm::vec3 h = glm::normalize(glm::normalize(glm::vec3(-1, 1, 1)) - ray);
    const double off = std::acos(double(glm::clamp(glm::dot(n, h), -1.0f, 1.0f))) * 180 / std::acos(-1.0);
    EXPECT_LT(off, 3) << name;
    RecordProperty(name + "_degrees", std::to_string(off));
  }
}

TEST_F(RenderCli, PicturesAreFinishedUnlessAskedNotTo) {
  const std::string size = "render m.json --hard-light --width 64 --height 64 ";
  const auto bytes = [&](const std::string& options) {
    const Outcome outcome = run(size + options + " -o out.png");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return render::load_texture(folder_.path() / "out.png").texels;
  };
  const auto usual = bytes("");
  EXPECT_EQ(usual, bytes("--supersample 4"));  // and the same picture again
  EXPECT_NE(usual, bytes("--no-dither"));
  EXPECT_NE(usual, bytes("--supersample 1"));
  EXPECT_NE(usual, bytes("--tone-map reinhard"));
  // Without dither, the bytes are the nearest to the values of the EXR file, which is exact.
  const auto plain = bytes("--supersample 1 --no-dither");
  ASSERT_EQ(run(size + "--supersample 1 -o out.exr").exit_code, 0);
  const render::Picture linear = render::read_exr(folder_.path() / "out.exr", "");
  const render::BytePicture shown = render::displayed(linear, render::ToneMap::neutral, 0);
  for (std::size_t k = 0; k < plain.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(plain[k][c], shown.pixels[k][c]);
  const Outcome bright = run(size + "--exposure auto --json -o out.png");
  ASSERT_EQ(bright.exit_code, 0) << bright.err;
  EXPECT_EQ(io::parse_json(bright.out, "stdout")["exposure"].get<float>(), render::exposure_from(linear));
  EXPECT_NE(run(size + "--exposure auto -o out.png").out.find("stops, from the picture"), std::string::npos);
}

TEST_F(RenderCli, MaterialsToLookAtStandInTheStudio) {
  const auto bytes = [&](const std::string& options) {
    const Outcome outcome = run("render m.json --width 32 --height 32 " + options + " -o out.png");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return render::load_texture(folder_.path() / "out.png").texels;
  };
  const auto usual = bytes("");
  EXPECT_EQ(usual, bytes("--environment studio"));
  EXPECT_EQ(bytes("--samples 64"), bytes("--environment studio --samples 64"));
  EXPECT_NE(usual, bytes("--hard-light"));
  // Pictures that measure or decompose the reflectance keep the single light.
  EXPECT_EQ(bytes("--forward"), bytes("--forward --hard-light"));
  EXPECT_EQ(run("render m.json --hard-light --environment sky -o x.png").exit_code, 2);
}

TEST_F(RenderCli, SamplesAreDrawnUntilTheNoiseIsReachedOrTheLimitIs) {
  const std::string size = "render m.json --width 12 --height 12 ";
  const auto words = [&](const std::string& options) {
    const Outcome outcome = run(size + options + " -o out.png");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  // The noise is always printed; the target only if it was requested.
  EXPECT_THAT(words("--samples 64"),
              HasSubstr("64 samples of the environment's light per pixel: remaining noise"));
  EXPECT_THAT(words(""), Not(HasSubstr("requested")));
  EXPECT_THAT(words("--noise 20%"), HasSubstr("(requested: 20 %)"));
  EXPECT_THAT(words("--noise 20%"), Not(HasSubstr("not reached")));
  const std::string missed = words("--noise 0.0001%");
  EXPECT_THAT(missed, HasSubstr("4096 samples"));
  EXPECT_THAT(missed, HasSubstr("not reached within the limit of 4096 samples"));
  EXPECT_THAT(missed, Not(HasSubstr("(requested")));
  EXPECT_THAT(words("--supersample 1 --samples 16"), HasSubstr("the remaining noise is not known"));
  EXPECT_THAT(words("--supersample 1 --noise 20%"), HasSubstr("(requested: 20 %)"));
  for (const char* wrong : {"1", "0%", "-1%", "101%", "x%", "%"})
    expect_refused(size + "--noise " + wrong + " -o x.png", 2, "must be a percentage above 0%");
  expect_refused(size + "--noise 1% --samples 64 -o x.png", 2, "--samples");
  expect_refused(size + "--noise 1% --hard-light -o x.png", 2, "has no effect without an environment");
}

// A mean over values that are not finite is not known: neither a noise nor a difference is stated.
TEST_F(RenderCli, ValuesThatAreNotFiniteAreReported) {
  write(
      "nan.glsl",
      "float brdf(vec3 L, vec3 V, vec3 N, float kd) { return kd * (0.1 + 0.1 * sqrt(N.z * L.z - 0.5)); }\n");
  const Outcome outcome = run("render --shader nan.glsl --width 48 --height 48 -o n.png");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(" % of the surface without a finite value"));
  EXPECT_THAT(outcome.out, HasSubstr("the remaining noise is not known, because not all values"));
  const io::Json json = io::parse_json(
      run("render --shader nan.glsl --compare embree --width 48 --height 48 --json -o m.png").out, "stdout");
  EXPECT_GT(json["not_finite"].get<double>(), 0);
  EXPECT_TRUE(json["rel_mse"].is_null());
}

TEST_F(RenderCli, ComparisonsOfTwoMaterialsCarryTheirNames) {
  write("red.json", R"({"format":"brdf-material","version":1,"form":"lambert","channels":["r","g","b"],)"
                    R"("weights":{"rho":[0.8,0.1,0.1]}})");
  const std::string size = " --width 120 --height 100 --supersample 2 ";
  const auto picture = [&](const std::string& arguments) {
    const Outcome outcome = run("render m.json --compare red.json" + size + arguments + " -o out.png");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return render::load_texture(folder_.path() / "out.png");
  };
  ASSERT_EQ(run("render m.json --hard-light" + size + "-o a.png").exit_code, 0);
  ASSERT_EQ(run("render red.json --hard-light" + size + "-o b.png").exit_code, 0);
  const render::Texture a = render::load_texture(folder_.path() / "a.png"),
                        b = render::load_texture(folder_.path() / "b.png");
  const render::Texture split = picture("--split --no-labels"), flip = picture("--show flip --no-labels");
  EXPECT_EQ(flip.texels, b.texels);
  for (std::size_t y = 0; y < 100; ++y) {
    EXPECT_EQ(split.texels[y * 120 + 10], a.texels[y * 120 + 10]);
    EXPECT_EQ(split.texels[y * 120 + 110], b.texels[y * 120 + 110]);
  }
  const render::Texture labelled = picture("--split");
  EXPECT_NE(labelled.texels, split.texels);
  EXPECT_TRUE(std::equal(labelled.texels.begin(), labelled.texels.begin() + 120 * 70, split.texels.begin()));
  EXPECT_EQ(picture("").width, 3 * 120);
  EXPECT_EQ(picture("--show difference").width, 120);
  EXPECT_EQ(picture("--gbuffer").width, 4 * 120);
}

TEST_F(RenderCli, ProbeAndTimesNeedNoPicture) {
  write_scene(R"("mesh":"sphere")");
  const Outcome outcome = run("render --scene scene.json --probe 32,32 --times --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const io::Json json = io::parse_json(outcome.out, "stdout");
  const double f = json["probe"]["f_r"].at(0).get<double>();
  EXPECT_NEAR(f, 0.6 / std::acos(-1.0), 1e-6);
  const double cosine = json["probe"]["wi"].at(2).get<double>();
  EXPECT_NEAR(json["probe"]["picture"].at(0).get<double>(), 3 * f * cosine, 1e-3);
  EXPECT_EQ(json["passes"].size(), 3u);
  const Outcome text = run("render --scene scene.json --probe 0,0 --times");
  EXPECT_THAT(text.out, HasSubstr("probe: background\n"));
  EXPECT_THAT(text.out, HasSubstr("lighting "));
}

TEST_F(RenderCli, LobePlotsShowBothMaterialsOrOneCurve) {
  const auto plot = [&](const std::string& arguments) {
    const Outcome outcome = run("lobes m.json " + arguments + " --width 300 -o lobes.png");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return render::load_texture(folder_.path() / "lobes.png");
  };
  const render::Texture all = plot("--theta 30"), turned = plot("--theta 60"), solo = plot("--solo 'A g'"),
                        two = plot("--compare m.json");
  EXPECT_EQ(all.width, 300);
  EXPECT_NE(all.texels, turned.texels);
  EXPECT_NE(all.texels, solo.texels);
  EXPECT_NE(all.texels, two.texels);
  // The lobe of Lambert's law is a half circle: the red curve passes straight above the origin at the full
  // radius.
  std::set<std::size_t> red_rows;
  for (std::size_t y = 0; y < std::size_t(all.height); ++y) {
    const auto& t = all.texels[y * 300 + 152];
    if (t[0] > 180 && t[1] < 130) red_rows.insert(y);
  }
  ASSERT_FALSE(red_rows.empty());
  EXPECT_LE(*red_rows.rbegin() - *red_rows.begin(), 4u);
}

TEST_F(RenderCli, SamplesAreDrawnInLobesAndAlone) {
  std::string rows = "theta_i,phi_i,theta_o,phi_o,r,g,b\n";
  for (int theta_i = 0; theta_i <= 60; theta_i += 20)
    for (int theta_o = 0; theta_o <= 80; theta_o += 10)
      for (int phi = 0; phi <= 180; phi += 30)
        rows += std::to_string(theta_i) + ",180," + std::to_string(theta_o) + "," + std::to_string(phi) +
                ",0.2,0.1,0.1\n";
  write("s.csv", rows);
  const auto picture = [&](const std::string& arguments, const std::string& name,
                           const std::string& verb = "lobes") {
    const Outcome outcome = run(verb + " " + arguments + " -o " + name);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << outcome.err;
    return file_text(folder_.path() / name);
  };
  // The points are drawn for the measured angle nearest to 45 degrees, unless --theta requests another one.
  const std::string bare = picture("m.json --width 200 --theta 40", "bare.png"),
                    points = picture("m.json --measured s.csv --width 200", "points.png");
  EXPECT_NE(bare, points);
  EXPECT_EQ(points, picture("m.json s.csv --width 200 --theta 40", "same.png"));
  EXPECT_NE(picture("m.json --body --width 200 --theta 40", "body.png"),
            picture("m.json --measured s.csv --body --width 200 --theta 40", "body_points.png"));
  expect_refused("lobes m.json --measured s.csv --theta 30 -o x.png", 2,
                 "no row with incidence within 1 degree of --theta 30; the nearest is 20");
  expect_refused("lobes s.csv -o x.png", 2, "a lobe plot needs a MATERIAL in addition to the samples");
  expect_refused("render s.csv s.csv -o x.png", 2, "a second table of samples");
  // Samples can be rendered alone. Light that is left out is reported.
  const Outcome alone = run("render s.csv --width 32 --height 32 -o alone.png");
  EXPECT_EQ(alone.exit_code, 0);
  EXPECT_EQ(alone.out.find("relative MSE"), std::string::npos) << alone.out;
  EXPECT_THAT(alone.err, HasSubstr("ambient light is omitted"));
  EXPECT_THAT(run("render m.json --measured s.csv --width 64 --height 64 -o both.png").out,
              HasSubstr("% of the surface"));
  EXPECT_NE(picture("m.json --measured s.csv --split --width 64 --height 64", "split.png", "render"),
            picture("m.json --measured s.csv --split --split-at 0.6 --width 64 --height 64", "split_at.png",
                    "render"));
}

}  // namespace
}  // namespace brdf
#endif
