// The parts of the window that work without a window: commands, layout, mouse input, light by mouse, names
// of files.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "io/csv/csv.h"
#include "io/files/error.h"
#include "io/samples/degrees.h"
#include "io/samples/samples.h"
#include "render/job.h"
#include "render/viewer/beside.h"
#include "render/viewer/commands.h"
#include "render/viewer/file_names.h"
#include "render/viewer/fit_task.h"
#include "render/viewer/hand.h"
#include "render/viewer/messages.h"
#include "render/viewer/panels.h"
#include "render/viewer/sliders.h"
#include "render/viewer/typing.h"

namespace brdf::render {
namespace {

TEST(Commands, EachHasAKeyOfItsOwnAndSaysWhatItDoes) {
  std::set<std::pair<int, int>> keys;
  std::set<std::string_view> names;
  for (const Command& c : commands()) {
    EXPECT_FALSE(c.does.empty()) << c.name;
    EXPECT_FALSE(c.keys.empty()) << c.name;
    EXPECT_TRUE(names.insert(c.name).second) << c.name;
    if (c.key == 0) continue;
    EXPECT_TRUE(keys.insert({c.key, c.mods}).second) << c.name;
    EXPECT_EQ(command_of(c.key, c.mods), &c) << c.name;
    EXPECT_TRUE(c.edit || c.request != Request::none) << c.name;
  }
  EXPECT_EQ(command_of(GLFW_KEY_ESCAPE, 0)->request, Request::dismiss);
  EXPECT_EQ(command_of(GLFW_KEY_EQUAL, GLFW_MOD_SHIFT), &command("brighter"));
  EXPECT_EQ(command_of(GLFW_KEY_F1, 0), &command("help"));
  EXPECT_EQ(command_of(GLFW_KEY_W, 0), nullptr);
}

TEST(Commands, HelpFoldsItsLinesAndNamesAll) {
  const std::string help = command_help(60);
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 62u) << line;
  for (const Command& c : commands()) EXPECT_NE(help.find(c.name), std::string::npos) << c.name;
}

TEST(Commands, HelpNamesKeysAsTheyArePrinted) {
  EXPECT_EQ(readable_keys(command("brighter")), "=");
  EXPECT_EQ(readable_keys(command("help")), "?");
  EXPECT_EQ(readable_keys(command("save state")), "ctrl+s");
  for (const char* name : {"equal", "minus:", "question", "Escape"})
    EXPECT_EQ(command_help(100).find(name), std::string::npos) << name;
}

TEST(Typing, ANumberIsAppliedOnEnterOrAfterAPauseOnly) {
  Typing typing;
  EXPECT_FALSE(typing.follow(1, true, 0.0, 10));  // "0", on the way to "0.25"
  EXPECT_FALSE(typing.follow(1, true, 0.2, 10.3));
  EXPECT_FALSE(typing.follow(2, false, std::nullopt, 10.4)) << "another field";
  EXPECT_FALSE(typing.follow(1, true, 0.25, 10.6));
  EXPECT_EQ(typing.follow(1, false, std::nullopt, 10.7), 0.25) << "Enter closes the field";
  EXPECT_FALSE(typing.follow(1, false, std::nullopt, 10.8)) << "once";
  EXPECT_FALSE(typing.follow(1, true, 3.0, 20));
  EXPECT_FALSE(typing.follow(1, true, std::nullopt, 20 + 0.9 * Typing::kPause));
  EXPECT_EQ(typing.follow(1, true, std::nullopt, 20 + 1.1 * Typing::kPause), 3.0) << "a pause";
  EXPECT_FALSE(typing.follow(1, false, std::nullopt, 22));
}

TEST(Sliders, TheNumberDoesNotLieUnderTheKnob) {
  constexpr float kWidth = 200, kKnob = 12, kSpace = 4;
  for (const float text : {20.0f, 60.0f, 90.0f})
    for (float knob = 8; knob <= 192; knob += 1) {
      const int spaces = spaces_beside_knob(kWidth, knob, kKnob, text, kSpace);
      const float middle = kWidth / 2 - float(spaces) * kSpace / 2;
      EXPECT_GE(std::abs(middle - knob), (text + kKnob) / 2) << text << " at " << knob;
      EXPECT_GE(middle - text / 2, 0) << text << " at " << knob;
      EXPECT_LE(middle + text / 2, kWidth) << text << " at " << knob;
    }
}

TEST(Messages, AnErrorEndsWithTheNextActionOtherMessagesStay) {
  Messages messages([] {});
  messages.say("saved");
  messages.forget_error();
  EXPECT_EQ(messages.last(), "saved");
  EXPECT_FALSE(messages.attempt([] { throw InputError("absent.json: no such file"); }));
  EXPECT_TRUE(messages.is_error());
  messages.forget_error();
  EXPECT_FALSE(messages.is_error());
  EXPECT_EQ(messages.last(), "");
}

TEST(Residuals, TheScaleFollowsTheDifferences) {
  const auto range = [](double difference) {
    std::vector<double> cells(100, std::nan(""));
    for (std::size_t k = 0; k < 60; ++k) cells[k] = std::log1p(k % 2 ? difference : -difference);
    return residual_range(cells);
  };
  EXPECT_EQ(range(0), 0.01);
  EXPECT_EQ(range(0.013), 0.02);
  EXPECT_EQ(range(0.049), 0.05);
  EXPECT_EQ(range(0.3), 0.5);
  EXPECT_EQ(range(0.9), 0.5);
  std::vector<double> one(40, 0.0);
  one[3] = 2;
  EXPECT_EQ(residual_range(one), 0.01) << "a single cell";
  EXPECT_EQ(residual_range({}), 0.5);
}

TEST(Probe, NamesWhoseValueItShows) {
  Shown::Probe probe;
  EXPECT_EQ(probe_lines(probe), (std::vector<std::string>{"probe: background"}));
  probe.a.hit = true;
  probe.a.wi = probe.a.wo = {0, 0, 1};
  probe.a.value = glm::vec3(0.0653f);
  EXPECT_EQ(probe_lines(probe).back(), "A: f_r (0.0653, 0.0653, 0.0653) 1/sr");
  probe.b = Pictures::ProbedValue{{0.5f, 0.25f, 0.125f}, true};
  EXPECT_EQ(probe_lines(probe).back(), "B: f_r (0.5, 0.25, 0.125) 1/sr");
  probe.b->known = false;
  EXPECT_EQ(probe_lines(probe).back(), "B: f_r (0.5, 0.25, 0.125) 1/sr, not measured here");
}

TEST(Layout, PanelsAndPictureFillTheWindowWithoutOverlap) {
  for (const VkExtent2D size :
       {VkExtent2D{800, 600}, VkExtent2D{1280, 720}, VkExtent2D{1920, 1080}, VkExtent2D{64, 64}})
    for (const float scale : {1.0f, 2.0f})
      for (const bool plot : {false, true}) {
        const Layout l = layout_of(size, scale, true, plot);
        const float covered = l.panel.width * l.panel.height + l.plot.width * l.plot.height +
                              l.head.width * l.head.height + l.status.width * l.status.height +
                              l.picture.width * l.picture.height;
        EXPECT_NEAR(covered, float(size.width) * float(size.height), 1) << size.width << " at " << scale;
        EXPECT_GE(l.picture.width, 0.3f * float(size.width));
        EXPECT_GE(l.picture.height, 0.45f * float(size.height));
        EXPECT_EQ(plot, l.plot_in_panel || l.plot.width > 0);
      }
  const Layout bare = layout_of({800, 600}, 1, false, true);
  EXPECT_EQ(bare.picture.width, 800);
  EXPECT_EQ(bare.picture.height, 600);
}

ViewState some_state() {
  ViewState state;
  state.scene = material_scene({any_material()});
  return state;
}

TEST(Hand, AClickTremblesADragTurnsTheCameraOrTheLight) {
  ViewState state = some_state();
  const ViewState before = state;
  const Area picture{100, 0, 400, 300};
  Hand hand;
  hand.move(state, picture, 300, 150);
  hand.press(state, picture, GLFW_MOUSE_BUTTON_LEFT, 0);
  hand.move(state, picture, 302, 151);
  EXPECT_EQ(hand.release(), Hand::Release::click);
  EXPECT_EQ(state, before);
  hand.press(state, picture, GLFW_MOUSE_BUTTON_LEFT, GLFW_MOD_CONTROL);
  hand.move(state, picture, 350, 150);
  EXPECT_EQ(hand.release(), Hand::Release::nothing);
  EXPECT_EQ(state.scene.camera, before.scene.camera);
  EXPECT_NE(state.scene.lights, before.scene.lights);
  EXPECT_NEAR(glm::length(state.scene.lights[0].vector), glm::length(before.scene.lights[0].vector), 1e-5f);
  state = before;
  hand.press(state, picture, GLFW_MOUSE_BUTTON_LEFT, 0);
  hand.move(state, picture, 250, 150);
  hand.release();
  EXPECT_EQ(state.scene.lights, before.scene.lights);
  EXPECT_NEAR(glm::length(state.scene.camera.position), glm::length(before.scene.camera.position), 1e-4f);
  EXPECT_NE(state.scene.camera.position, before.scene.camera.position);
}

TEST(Hand, TheLineOfASplitGoesWhereThePointerIs) {
  ViewState state = some_state();
  state.display = Display::split;
  const Area picture{100, 0, 400, 300};
  Hand hand;
  hand.move(state, picture, 304, 150);
  hand.press(state, picture, GLFW_MOUSE_BUTTON_LEFT, 0);
  hand.move(state, picture, 200, 150);
  EXPECT_NEAR(state.split, 0.25f, 1e-6f);
}

TEST(Light, ThatFollowsTheCameraStaysInItsFrame) {
  ViewState state = some_state();
  const Camera before = state.scene.camera;
  orbit(state.scene.camera, 0.7f, 0.2f);
  follow_camera(state.scene, before);
  const auto seen = [](const Scene& scene) {
    const glm::vec3 back = glm::normalize(scene.camera.position - scene.camera.target);
    const glm::vec3 right = glm::normalize(glm::cross(scene.camera.up, back));
    const glm::vec3 light = glm::normalize(scene.lights[0].vector);
    return glm::vec3(glm::dot(light, right), glm::dot(light, glm::cross(back, right)), glm::dot(light, back));
  };
  EXPECT_LT(glm::length(seen(state.scene) - seen(some_state().scene)), 1e-5f);
}

TEST(Light, ThatFollowsTheCameraStaysWhereOnlyThePicturesSizeChanges) {
  ViewState state = some_state();
  orbit(state.scene.camera, 0.7f, 0.2f);
  const ViewState before = state;
  for (int size = 100; size < 400; size += 7) {
    const Camera then = state.scene.camera;
    state.scene.camera.width = size;
    state.scene.camera.height = 500 - size;
    follow_camera(state.scene, then);
  }
  EXPECT_EQ(state.scene.lights, before.scene.lights);
}

TEST(Light, AnEnvironmentTurnsWithTheHandByTheSameAngle) {
  Scene scene = some_state().scene;
  scene.environment = Environment{"studio", 170};
  turn_light(scene, glm::radians(30.0f), 0);
  EXPECT_NEAR(scene.environment->rotation, -160, 1e-3f);
}

TEST(Frame, LeavesTheGroundOutAndTakesOneObjectAlone) {
  Scene scene = material_scene({any_material(), any_material()});
  Object ground = scene.objects[0];
  ground.mesh = "plane";
  ground.scale = glm::vec3(50);
  scene.objects.push_back(ground);
  const PreparedScene prepared = prepare(scene);
  const glm::vec4 all = bounds_of(prepared, std::nullopt), one = bounds_of(prepared, 0),
                  floor = bounds_of(prepared, 2);
  EXPECT_NEAR(all.x, 0, 1e-3f);
  EXPECT_LT(all.w, 4);
  EXPECT_NEAR(one.x, -1.1f, 1e-3f);
  EXPECT_LT(one.w, 1.8f);
  EXPECT_GT(floor.w, 20);
}

TEST(FileNames, CompleteAsFarAsTheyAgreeAndListWhatCanBeOpened) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "window_names";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / "copper.d");
  for (const char* name : {"copper_a.json", "copper_b.csv", "copper.log", ".hidden.json", "brass.json"})
    std::ofstream(folder / name) << "x";
  const std::string start = folder.string() + "/";
  EXPECT_EQ(completed(start + "c"), start + "copper");
  EXPECT_EQ(completed(start + "copper_a"), start + "copper_a.json");
  EXPECT_EQ(completed(start + "tin"), start + "tin");
  EXPECT_EQ(names_that_go_on(start),
            (std::vector<std::string>{start + "brass.json", start + "copper.d/", start + "copper_a.json",
                                      start + "copper_b.csv"}));
  EXPECT_EQ(names_that_go_on(start + ".").size(), 1u);
  EXPECT_TRUE(names_that_go_on("/no such folder/x").empty());
}

TEST(FileNames, TheLastOpenedComesFirstOnceAndTenStay) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "window_state_home";
  std::filesystem::remove_all(folder);
  setenv("XDG_STATE_HOME", folder.c_str(), 1);
  EXPECT_TRUE(recent_files().empty());
  for (int k = 0; k < 12; ++k) remember_file("/x/" + std::to_string(k));
  remember_file("/x/5");
  const std::vector<std::string> files = recent_files();
  ASSERT_EQ(files.size(), 10u);
  EXPECT_EQ(files[0], "/x/5");
  EXPECT_EQ(std::count(files.begin(), files.end(), "/x/5"), 1);
  EXPECT_EQ(files[1], "/x/11");
}

TEST(FitTask, ReturnsWhatTheSolverFoundAndStops) {
  FitTask task;
  const Material from = any_material().second;
  Solver solver;
  solver.fit = [](const Material& m, const io::SampleTable&, const std::atomic<bool>& stop) {
    while (!stop) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return Fitted{m, {}, "best so far"};
  };
  task.start(solver, from, {});
  EXPECT_TRUE(task.running());
  EXPECT_FALSE(task.take());
  task.stop();
  std::optional<Fitted> found;
  while (!(found = task.take())) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(found->words, "best so far");
  EXPECT_EQ(found->material, from);
  EXPECT_FALSE(task.running());
}

// Writes samples of this material in the plane of incidence.
void write_samples_of(const Material& material, const std::filesystem::path& file) {
  io::SampleTable table;
  table.channels = material.channels;
  table.values.resize(material.channels.size());
  std::vector<double> f(material.channels.size());
  for (double theta = 0; theta < 80; theta += 5) {
    table.add_directions(40, 0, theta, 180);
    eval(material, io::unit_vector(40, 0), io::unit_vector(theta, 180), f);
    for (std::size_t c = 0; c < f.size(); ++c) table.values[c].push_back(f[c]);
  }
  io::write_samples(file, table);
}

TEST(Beside, IntervalsStandAtWhatWasFittedAlone) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "beside.csv";
  const Material material = any_material().second;
  write_samples_of(material, file);
  ViewState state;
  state.scene = material_scene({{"one", material}, {"two", material}});
  state.samples = file;
  Session session(state, "");
  Solver solver;
  solver.fit = [](const Material& m, const io::SampleTable&, const std::atomic<bool>&) {
    return Fitted{m, {Interval{}}, "found"};
  };
  Beside beside(solver);
  beside.look(session, false);
  beside.fit(session);
  while (beside.take(session).empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(beside.intervals(session).size(), 1u);
  session.state().selected = 1;
  EXPECT_TRUE(beside.intervals(session).empty());
  session.state().selected = 0;
  session.state().scene.objects[0].material_name = "another of the same form";
  EXPECT_TRUE(beside.intervals(session).empty());
}

TEST(Beside, ResidualsFollowTheMaterial) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "beside_residuals.csv";
  const Material material = any_material().second;
  write_samples_of(material, file);
  ViewState state;
  state.scene = material_scene({{"one", material}});
  Session session(state, "");
  Beside beside(Solver{});
  beside.look(session, false);
  EXPECT_EQ(beside.residuals(session), nullptr) << "nothing to compare with";
  session.state().samples = file;
  beside.look(session, false);
  const auto largest = [&] {
    double size = 0;
    for (const double v : *beside.residuals(session))
      if (!std::isnan(v)) size = std::max(size, std::abs(v));
    return size;
  };
  ASSERT_NE(beside.residuals(session), nullptr);
  EXPECT_LT(largest(), 1e-6);
  for (std::vector<double>& weights : session.state().scene.objects[0].material.terms[0].weights)
    for (double& w : weights) w *= 2;
  EXPECT_GT(largest(), 0.1);
}

}  // namespace
}  // namespace brdf::render
