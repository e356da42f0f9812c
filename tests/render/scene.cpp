// Scene files: reading, writing, limits, error messages with the path of the faulty key, and the scenes of
// shapes and materials.
#include "render/scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "io/files/error.h"
#include "io/files/temporary.h"
#include "render/compare/state.h"
#include "render/scene/prepared.h"
#include "render/scene/scene_json.h"

namespace brdf::render {
namespace {

const std::string kMaterial =
    R"({"format":"brdf-material","version":1,"form":"lambert","channels":["r","g","b"],"weights":{"rho":[0,0.5,1]}})";

// Returns the text of a scene with additional keys and this object.
std::string scene_with(const std::string& keys, const std::string& object = "") {
  return R"({"format":"brdf-scene","version":1,)" + keys + R"("objects":[{"material":)" + kMaterial + object +
         "}]}";
}

Scene parsed(const std::string& text) {
  const io::Json json = io::parse_json(text, "s.json");
  return scene_from_json({json, "s.json"}, ".");
}

std::string message_of(const std::string& text) {
  try {
    prepare(parsed(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Scene, ReadsAnEnvironment) {
  const Scene once = parsed(scene_with(R"("environment":{"picture":"sky","rotation":-30,"intensity":2.5},)"));
  ASSERT_TRUE(once.environment);
  EXPECT_EQ(*once.environment, (Environment{"sky", -30, 2.5f, true}));
  EXPECT_EQ(parsed(io::to_text(to_json(once))), once);
  EXPECT_EQ(prepare(once).environment->width(), 1024);
  EXPECT_EQ(prepare(parsed(scene_with(""))).environment, nullptr);
  Scene other = once;
  other.environment->rotation = 0;
  EXPECT_NE(other, once);
  // A background that is given explicitly is kept and written.
  const Scene hidden = parsed(scene_with(R"("background":[1,0,0],"environment":{"picture":"uniform"},)"));
  EXPECT_FALSE(hidden.environment->shown);
  EXPECT_EQ(parsed(io::to_text(to_json(hidden))), hidden);
}

TEST(Scene, RefusesEnvironmentsThatAreNone) {
  const auto refusal = [](const std::string& inside) {
    return message_of(scene_with("\"environment\":{" + inside + "},"));
  };
  EXPECT_THAT(refusal(""), testing::HasSubstr("environment"));
  EXPECT_THAT(refusal(R"("picture":"")"), testing::HasSubstr("studio, sky, uniform"));
  EXPECT_THAT(refusal(R"("picture":"sky","rotation":400)"), testing::HasSubstr("environment.rotation"));
  EXPECT_THAT(refusal(R"("picture":"sky","intensity":-1)"), testing::HasSubstr("environment.intensity"));
  EXPECT_THAT(refusal(R"("picture":"sky","colour":1)"), testing::HasSubstr("colour"));
  EXPECT_THAT(refusal(R"("picture":"nowhere.hdr")"), testing::HasSubstr("nowhere.hdr: no such file"));
}

TEST(Scene, ReadsWhatItWrote) {
  const std::string text = scene_with(
      R"("shadow":true,"camera":{"position":[1,2,3],"vertical_fov":40,"width":64,"height":32},"ambient":[0.1,0.2,0.3],
         "background":{"horizon":[1,1,1],"zenith":[0,0,1]},"lights":[{"type":"point","position":[1,2,3],"intensity":2},
         {"type":"directional","direction":[0,-1,0],"color":[1,0,0]}],"shading":"phong","as_coded":true,)",
      R"(,"mesh":"icosphere:2","rotation":[10,20,30],"scale":[1,2,1])");
  const Scene once = parsed(text);
  Scene again = parsed(io::to_text(to_json(once)));
  EXPECT_EQ(again, once);
  again.objects[0].material.terms[0].weights[1][0] += 1e-12;
  EXPECT_NE(again, once);
  again = once;
  again.lights[0].color.g = 0.5f;
  EXPECT_NE(again, once);
  EXPECT_TRUE(once.as_coded);
  EXPECT_TRUE(once.shadow);
  EXPECT_EQ(once.tone_map, ToneMap::none);  // the articles' colours are displayed unchanged
  EXPECT_EQ(once.lights.size(), 2u);
  EXPECT_TRUE(once.sky_zenith.has_value());
}

TEST(Scene, ABackdropIsNoSky) {
  const Scene once = parsed(scene_with(R"("background":{"bottom":[1,1,1],"top":[0,0,0.5]},)"));
  EXPECT_EQ(once.backdrop_top, glm::vec3(0, 0, 0.5f));
  EXPECT_FALSE(once.sky_zenith);
  EXPECT_EQ(parsed(io::to_text(to_json(once))), once);
  EXPECT_NE(message_of(scene_with(R"("background":{"bottom":[1,1,1],"zenith":[0,0,1]},)")).find("zenith"),
            std::string::npos);
  EXPECT_NE(message_of(scene_with(R"("background":{"top":[1,1,1]},)")).find("bottom"), std::string::npos);
}

TEST(Scene, RefusesWhatItDoesNotKnowByItsPath) {
  EXPECT_NE(message_of(scene_with(R"("colour":1,)")).find("s.json: $: unknown key \"colour\""),
            std::string::npos);
  EXPECT_NE(message_of(scene_with(R"("lights":[{"type":"spot"}],)")).find("$.lights[0].type"),
            std::string::npos);
  EXPECT_NE(
      message_of(scene_with(R"("lights":[{"type":"point","position":[0,1]}],)")).find("$.lights[0].position"),
      std::string::npos);
  EXPECT_NE(message_of(scene_with(R"("lights":[{"type":"directional","direction":[0,0,0]}],)"))
                .find("must not be zero"),
            std::string::npos);
  EXPECT_NE(message_of(scene_with(R"("camera":{"width":0},)")).find("$.camera.width"), std::string::npos);
  EXPECT_NE(message_of(scene_with("", R"(,"scale":0)")).find("$.objects[0].scale"), std::string::npos);
  EXPECT_NE(message_of(scene_with("", R"(,"textures":{"albedo":"absent.png"})"))
                .find("absent.png: no such texture"),
            std::string::npos);
  EXPECT_NE(message_of(scene_with("", R"(,"mesh":"sphere:many")")).find("sphere:many"), std::string::npos);
}

TEST(Scene, AScaleHasOneRangeHoweverItIsWritten) {
  for (const char* scale : {"1e300", "[1,1,1e300]", "-1e7"})
    EXPECT_NE(message_of(scene_with("", std::string(R"(,"scale":)") + scale))
                  .find("must be between -1e+06 and 1e+06"),
              std::string::npos)
        << scale;
  EXPECT_EQ(parsed(scene_with("", R"(,"scale":1e6)")).objects[0].scale.x, 1e6f);
}

TEST(Scene, AMaterialMayComeThroughAPipe) {
  const io::TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe.json";
  std::ofstream(folder.path() / "s.json")
      << R"({"format":"brdf-scene","version":1,"objects":[{"material":"pipe.json"}]})";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << kMaterial; });
  const Scene scene = load_scene(folder.path() / "s.json");
  writer.join();
  EXPECT_EQ(scene.objects[0].material, parsed(scene_with("")).objects[0].material);
}

TEST(Scene, TrianglesOfAllObjectsTogetherAreLimited) {
  // A mesh that is made once and drawn ten times counts ten times.
  const auto scene_of = [](int spheres) {
    const std::string object = R"({"mesh":"sphere:2000000","material":)" + kMaterial + "}";
    std::string objects = object;
    for (int k = 1; k < spheres; ++k) objects += "," + object;
    return R"({"format":"brdf-scene","version":1,"objects":[)" + objects + "]}";
  };
  const std::size_t each = make_mesh("sphere:2000000", "").triangles();
  const auto fit = int(kMostTriangles / each);
  EXPECT_EQ(message_of(scene_of(fit)), "accepted");
  EXPECT_EQ(
      message_of(scene_of(fit + 1)),
      "$.objects[" + std::to_string(fit) + "]: with this object the scene has more than 20000000 triangles");
}

TEST(Scene, AnErrorInsideAViewsSceneHasItsWholePlace) {
  const io::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "view.json";
  const auto message = [&](const std::string& scene) -> std::string {
    std::ofstream(file) << R"({"format":"brdf-view","version":1,"scene":)" << scene << "}";
    try {
      load_state(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  std::string broken = scene_with("");
  broken.replace(broken.find("[0,0.5,1]"), 9, "[0,0.5,-1]");
  EXPECT_EQ(message(broken).find(file.string() + ": $.scene.objects[0].material.weights.rho"), 0u)
      << message(broken);
  EXPECT_EQ(message(scene_with(R"("camera":{"width":0},)")).find(file.string() + ": $.scene.camera.width: "),
            0u);
}

TEST(Scene, AStateIsReadAsItWasWritten) {
  const io::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "state.json";
  ViewState state;
  state.scene = parsed(scene_with(R"("exposure":1.5,)"));
  state.scene.folder.clear();
  state.material = make_material(*find_form("ward"));
  state.material_name = "w";
  state.other = Other::material;
  state.display = Display::difference;
  state.plot_solo = 2;
  std::ofstream(file) << state_text(state);
  ViewState back;
  open_file(back, file);
  EXPECT_EQ(back, state);
  back.split = 0.25f;
  EXPECT_NE(back, state);
}

TEST(Scene, EveryShippedSceneLoads) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BRDF_SOURCE_DIR "/data/scenes")) {
    if (entry.path().extension() != ".json") continue;
    SCOPED_TRACE(entry.path().string());
    EXPECT_NO_THROW(prepare(load_scene(entry.path())));
    ++count;
  }
  EXPECT_GE(count, 10);
}

TEST(Scene, ObjectsOfShippedScenesThatShowMaterialsAreLabelled) {
  for (const char* name : {"six_families", "material_balls", "shader_balls", "draped_cloth", "vase", "car",
                           "brushed_metal", "grazing", "rusty_metal_families"}) {
    const Scene scene = load_scene(std::string(BRDF_SOURCE_DIR "/data/scenes/") + name + ".json");
    EXPECT_TRUE(std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& object) {
      return !object.label.empty();
    })) << name;
    const io::Json written = to_json(scene);
    const Scene again = scene_from_json({written, "memory"}, scene.folder);
    for (std::size_t k = 0; k < scene.objects.size(); ++k)
      EXPECT_EQ(again.objects[k].label, scene.objects[k].label);
  }
}

TEST(Scene, AShapeIsAsLargeAsTheSphereAndDressedWhereItHasParts) {
  const Material material = make_material(*find_form("ward"));
  const auto bounds_of = [](const Scene& scene) { return prepare(scene).bounds; };
  for (const char* shape : {"vase", "cloth", "icosphere:2"}) {
    SCOPED_TRACE(shape);
    const Scene scene = shape_scene(shape, {{"m", material}});
    ASSERT_EQ(scene.objects.size(), 1u);
    const glm::vec4 bounds = bounds_of(scene);
    EXPECT_LT(glm::length(glm::vec3(bounds)), 1e-4);
    EXPECT_NEAR(bounds.w, std::sqrt(3.0f), 1e-3);  // of the box around a unit sphere
  }
  const Scene cars = shape_scene("sedan", {{"a", material}, {"b", make_material(*find_form("lambert"))}});
  ASSERT_EQ(cars.objects.size(), 10u);
  EXPECT_EQ(cars.objects[0].material, material);
  EXPECT_EQ(cars.objects[5].mesh, "sedan:body");
  EXPECT_EQ(cars.objects[5].label, "b");
  EXPECT_NEAR(cars.objects[5].position.x - cars.objects[0].position.x, 2.2f, 1e-5f);
  // Windows and tyres are dark for any material.
  const Term& windows = cars.objects[1].material.terms[0];
  EXPECT_LT(windows.weights[0][std::size_t(info(windows.form).weight_index(Role::diffuse))], 0.02);
  EXPECT_THROW(shape_scene("no_such_shape", {{"m", material}}), InputError);
}

TEST(Scene, PerChannelShapesBecomeOneItemPerChannel) {
  Material material = make_material(*find_form("cook_torrance"));
  const auto shape = material.terms[0].shape[0];
  material.terms[0].shape = {shape, shape, shape};
  material.terms[0].shape[2][0] = 0.1;
  Scene scene = material_scene({{"m", material}});
  scene.objects[0].mesh = "icosphere:1";
  const PreparedScene prepared = prepare(scene);
  ASSERT_EQ(prepared.layers.size(), 3u);
  EXPECT_EQ(prepared.layers[0][0].weights[1][0], 0);
  EXPECT_EQ(prepared.layers[2][0].weights[2][0], 0.5f);
  EXPECT_EQ(prepared.layers[2][0].shape[0], 0.1f);
}

TEST(Scene, MaterialRowFitsIntoThePicture) {
  const Material material = make_material(*find_form("lambert"));
  for (std::size_t count = 1; count <= 12; ++count) {
    const Scene scene = material_scene(std::vector(count, std::pair{std::string("m"), material}));
    const float aspect = float(scene.camera.width) / float(scene.camera.height);
    const float reach =
        scene.camera.position.z * std::tan(glm::radians(scene.camera.vertical_fov) / 2) * aspect;
    EXPECT_GT(reach, scene.objects.back().position.x + 1) << count;
  }
}

}  // namespace
}  // namespace brdf::render
