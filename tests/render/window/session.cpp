// The effect of the window's commands on a state, tested without a window.
#include "render/viewer/session.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "io/files/error.h"
#include "io/material/material_json.h"
#include "render/gpu/reflectance_glsl.h"
#include "render/job.h"
#include "render/viewer/commands.h"

namespace brdf::render {
namespace {

ViewState edited_state() {
  ViewState state;
  state.scene = material_scene({any_material()});
  return state;
}

std::filesystem::path in_temp(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / name;
}

Term& first_term(Session& session) {
  return session.state().scene.objects.at(0).material.terms.front();
}

TEST(Session, AThousandEditsAreUndoneToTheFirstByteAndDoneAgain) {
  Session session(edited_state(), "");
  const std::string first = state_text(session.state());
  std::mt19937 random(7);
  const PreparedScene drawn = prepare(session.state().scene);
  std::vector<const Command*> edits;
  for (const Command& c : commands())
    if (c.edit) edits.push_back(&c);
  ASSERT_GT(edits.size(), 25u);
  for (int k = 0; k < 1000; ++k) {
    edits[random() % edits.size()]->edit(session, {session.state().scene.camera, &drawn});
    session.record();
  }
  const std::string last = state_text(session.state());
  EXPECT_NE(first, last);
  std::size_t back = 0, forth = 0;
  while (!session.undo().empty()) ++back;
  EXPECT_GT(back, 500u);
  EXPECT_EQ(state_text(session.state()), first);
  EXPECT_EQ(session.undo(), "");
  while (!session.redo().empty()) ++forth;
  EXPECT_EQ(forth, back);
  EXPECT_EQ(state_text(session.state()), last);
}

TEST(Session, SamplesBringTheLobePlotToTheNearestMeasuredLight) {
  const std::filesystem::path file = in_temp("plot_light.csv");
  std::ofstream(file) << "theta_i,phi_i,theta_o,phi_o,r,g,b\n"
                         "20,0,10,180,0.1,0.1,0.1\n60,0,10,180,0.1,0.1,0.1\n60,0,20,180,0.1,0.1,0.1\n";
  Session session(edited_state(), "");
  ASSERT_EQ(session.state().plot_theta, 45);
  session.open(file, [] {});
  EXPECT_EQ(session.state().plot_theta, 60);
  session.undo();
  EXPECT_EQ(session.state().plot_theta, 45);
}

TEST(Session, AnEditAfterUndoingForgetsWhatWasUndone) {
  Session session(edited_state(), "");
  session.state().scene.exposure = 1;
  session.record();
  EXPECT_EQ(session.undo(), "the view");
  EXPECT_EQ(session.state().scene.exposure, 0);
  session.state().plot_theta = 20;
  session.record();
  EXPECT_EQ(session.redo(), "");
}

TEST(Session, WhatTurnsByItselfIsNoEditButWhatIsDoneMeanwhileIs) {
  Session session(edited_state(), "");
  const std::string first = state_text(session.state());
  const auto turn = [&] {
    for (int k = 0; k < 5; ++k) {
      session.state().scene.objects[0].rotation.y += 3;
      session.record();
    }
  };
  command("turntable").edit(session, {});
  session.record();
  turn();
  EXPECT_FALSE(session.edited());
  EXPECT_EQ(session.steps(), 1u);
  session.state().scene.exposure = 1;
  EXPECT_TRUE(session.edited());
  turn();
  EXPECT_EQ(session.steps(), 2u);
  EXPECT_FALSE(session.undo().empty());
  EXPECT_EQ(session.state().scene.exposure, 0);
  turn();  // the turntable does not wait for the next key
  EXPECT_FALSE(session.undo().empty());
  EXPECT_EQ(state_text(session.state()), first);
  EXPECT_TRUE(session.undo().empty());
}

TEST(Session, AnotherSizeOfTheWindowIsNoEdit) {
  Session session(edited_state(), "");
  session.state().scene.camera.width = 333;
  session.record();
  EXPECT_EQ(session.steps(), 0u);
}

TEST(Session, OnceRoundAllFormsBringsTheValuesBack) {
  Session session(edited_state(), "");
  for (double& w : first_term(session).weights[0]) w = 0.123456789;
  for (double& s : first_term(session).shape[0]) s = 0.0314;
  const Term before = first_term(session);
  for (std::size_t k = 0; k < drawable_forms().size(); ++k) command("next form").edit(session, {});
  EXPECT_EQ(first_term(session), before);
}

TEST(Session, LookingAroundIsNoChangeAndTheTitleTellsChanges) {
  Session session(edited_state(), "some/brass.json");
  EXPECT_EQ(session.title(), "brass.json - brdf");
  command("turn left").edit(session, {});
  command("split").edit(session, {});
  command("brighter").edit(session, {});
  EXPECT_FALSE(session.changed());
  command("next family").edit(session, {});
  EXPECT_TRUE(session.changed());
  EXPECT_EQ(session.title(), "* brass.json - brdf");
  EXPECT_NE(session.name_of_a().find("(changed)"), std::string::npos);
  session.undo();
  EXPECT_FALSE(session.changed());
}

TEST(Session, RevertGoesBackToTheFileAndCanBeUndone) {
  Session session(edited_state(), "");
  const std::string opened = state_text(session.state());
  command("next form").edit(session, {});
  const std::string edited = state_text(session.state());
  session.revert();
  EXPECT_EQ(state_text(session.state()), opened);
  session.undo();
  EXPECT_EQ(state_text(session.state()), edited);
}

TEST(Session, AMaterialIsSavedAndOpenedAgain) {
  Session session(edited_state(), "");
  const std::filesystem::path file = in_temp("window_saved.json");
  first_term(session).weights[0][0] = 0.377;
  session.save_material(file);
  EXPECT_FALSE(session.changed());
  const Material saved = session.state().scene.objects[0].material;
  EXPECT_EQ(io::read_material_file(file).material, saved);
  command("next form").edit(session, {});
  session.open(file, [] {});
  EXPECT_EQ(session.state().scene.objects[0].material, saved);
  EXPECT_EQ(session.title(), "window_saved.json - brdf");
  ASSERT_NE(session.in_file(0), nullptr);
  EXPECT_EQ(session.in_file(0)->weights[0][0], 0.377);
}

TEST(Session, WhatCannotBeOpenedOrDrawnChangesNothing) {
  Session session(edited_state(), "");
  const std::filesystem::path broken = in_temp("window_broken.json"), good = in_temp("window_good.json");
  std::ofstream(broken) << "{";
  io::write_material_file(good, {make_material(catalogue().back()), {}});
  const std::string before = state_text(session.state());
  EXPECT_THROW(session.open(broken, [] {}), InputError);
  EXPECT_THROW(session.open(good, [] { throw InputError("cannot be drawn"); }), InputError);
  EXPECT_EQ(state_text(session.state()), before);
  EXPECT_EQ(session.steps(), 0u);
}

TEST(Session, ASavedStateKeepsWhatStandsInThePlotAndHowTheLightGoes) {
  Session session(edited_state(), "");
  command("keep in plot").edit(session, {});
  command("light follows").edit(session, {});
  const std::filesystem::path file = in_temp("window_state.json");
  session.save_state(file, 300, 200);
  const ViewState loaded = load_state(file);
  EXPECT_TRUE(loaded.light_follows);
  ASSERT_EQ(loaded.kept.size(), 1u);
  EXPECT_EQ(loaded.kept[0].second, session.state().scene.objects[0].material);
  EXPECT_EQ(loaded.scene.camera.width, 300);
}

TEST(Session, AMaterialIsReadFromASavedState) {
  Session session(edited_state(), "");
  first_term(session).weights[1][0] = 0.2345;
  const std::filesystem::path file = in_temp("window_holds.json");
  session.save_state(file, 10, 10);
  EXPECT_EQ(io::read_material(file), session.state().scene.objects[0].material);
}

}  // namespace
}  // namespace brdf::render
