#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "render/viewer/controller.h"
#include "render/viewer/file_names.h"

namespace brdf::render {

void Controller::request(Request asked) {
  switch (asked) {
    case Request::leave:
      session_.changed() ? prompts_.ask_to_leave() : leave();
      break;
    case Request::save_state:
      save_state();
      break;
    case Request::load_state:
      open({options_.state_file});
      break;
    case Request::save_material:
      prompts_.ask_for_material(state().scene.objects[state().selected].material_name + ".json");
      break;
    case Request::open:
      prompts_.ask_for_file();
      break;
    case Request::screenshot:
      messages_.attempt([&] {
        write_png(options_.screenshot, shown_.capture(state()));
        messages_.say("wrote " + options_.screenshot.string());
      });
      break;
    case Request::undo:
      went(session_.undo(), "undone: ", "nothing to undo");
      break;
    case Request::redo:
      went(session_.redo(), "redone: ", "nothing to redo");
      break;
    case Request::revert:
      session_.revert();
      went("restored the state of the opened file", "", "");
      break;
    case Request::help:
      panels_.show_help();
      break;
    case Request::dismiss:
      if (!panels_.dismiss()) probe_.reset();
      break;
    case Request::fit_here:
      messages_.attempt([&] {
        beside_.fit(session_);
        messages_.say("fitting; ctrl+x stops and keeps the best values so far");
      });
      break;
    case Request::stop_fit:
      beside_.stop();
      break;
    case Request::none:
      break;
  }
  wake();
}

void Controller::went(const std::string& what, const std::string& words, const std::string& nothing) {
  messages_.say(what.empty() ? nothing : words + what);
  camera_ = camera();
}

void Controller::obey(const Answers& answers) {
  if (!answers.open.empty()) open({answers.open});
  if (!answers.save_material.empty())
    messages_.attempt([&] {
      session_.save_material(answers.save_material);
      remember_file(answers.save_material);
      messages_.say("saved the material as " + answers.save_material);
    });
  if (answers.leave || (answers.save_and_leave && save_state())) leave();
}

void Controller::leave() {
  glfwSetWindowShouldClose(window_.get(), GLFW_TRUE);
}

void Controller::fitted() {
  messages_.attempt([&] {
    const std::string words = beside_.take(session_);
    if (!words.empty()) messages_.say(words);
  });
}

void Controller::open(const std::vector<std::filesystem::path>& files) {
  std::string failed;
  for (const std::filesystem::path& file : files) {
    const ViewState before = state();
    const VkExtent2D size = pixels_of(layout_.picture).extent;
    const bool good = messages_.attempt([&] {
      session_.open(file, [&] {
        camera().width = int(size.width);
        camera().height = int(size.height);
        shown_.update(state(), size, false);
        arrive(before);
      });
      remember_file(file);
      const std::string note = left_out_note(state());
      messages_.say("opened " + file.string() + (note.empty() ? "" : "; " + note));
    });
    if (!good && failed.empty()) failed = messages_.last();
  }
  if (!failed.empty()) messages_.keep(failed);
}

void Controller::arrive(const ViewState& before) {
  const Camera &now = camera(), &then = before.scene.camera;
  const bool moved = now.position != then.position || now.target != then.target;
  const bool other_mesh =
      state().scene.objects[state().selected].mesh != before.scene.objects[before.selected].mesh;
  if (other_mesh && !moved) render::fit(camera(), shown_.drawn()->prepared().bounds);
  if (moved || other_mesh) home_ = camera();
  camera_ = camera();
}

bool Controller::save_state() {
  return messages_.attempt([&] {
    const VkExtent2D size = pixels_of(layout_.picture).extent;
    session_.save_state(options_.state_file, int(size.width), int(size.height));
    messages_.say("saved " + options_.state_file.string());
  });
}

}  // namespace brdf::render
