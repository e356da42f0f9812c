// The window's loop: user input changes the session, and the session is drawn as pictures. controller.cpp
// draws, controller_input.cpp handles keys and the mouse, controller_requests.cpp executes requests.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/viewer/beside.h"
#include "render/viewer/display_pass.h"
#include "render/viewer/frame_times.h"
#include "render/viewer/hand.h"
#include "render/viewer/interface.h"
#include "render/viewer/late_keys.h"
#include "render/viewer/messages.h"
#include "render/viewer/panels.h"
#include "render/viewer/prompts.h"
#include "render/viewer/shown.h"
#include "render/viewer/viewer.h"
#include "render/viewer/window.h"

namespace brdf::render {

class Controller : private Listener {
 public:
  explicit Controller(const ViewerOptions& options);

  ViewerReport run();

 private:
  static constexpr int kFramesAfterInput = 3;  // Dear ImGui settles within three frames

  void wake() { awake_ = kFramesAfterInput; }
  ViewState& state() { return session_.state(); }
  Camera& camera() { return state().scene.camera; }

  void step();
  // Also called between two frames, so that a state saved there equals the state that will be shown.
  void follow();
  bool edited() const;  // whether an edit is in progress
  bool held() const;    // or something moves by itself
  void frame();
  Whereabouts whereabouts() const { return {home_, shown_.drawn() ? &shown_.drawn()->prepared() : nullptr}; }
  PanelInfo info();
  // If the state cannot be drawn (a file has vanished, too little memory), the last good state is restored.
  void draw_pictures();
  // Ends an edit before the next begins. A state that cannot be drawn must not enter the history; the state
  // is therefore drawn first.
  void settle();

  void request(Request asked);
  // Reports the changes of a step of the history.
  void went(const std::string& what, const std::string& words, const std::string& nothing);
  void obey(const Answers& answers);
  void leave();
  void fitted();
  // Opens the files one after another. A file that cannot be shown changes nothing, and its error message
  // remains.
  void open(const std::vector<std::filesystem::path>& files);
  // Makes the camera of an opened file the new home; a model is framed as a whole.
  void arrive(const ViewState& before);
  // Saves the state with the size of the picture shown, so that `brdf render --state` makes the same
  // picture.
  bool save_state();

  // Dear ImGui receives all events first and reports the events that it uses itself.
  void key(int key, int scancode, int action, int mods) override;
  void pressed(int key, int mods);
  // The letter of the key that opened a question is not part of the answer.
  void letter(unsigned code) override;
  void scroll(double x, double y) override;
  void button(int button, int action, int mods) override;
  // Selects the object under the mouse, if any.
  void click();
  void cursor(double x, double y) override;
  void drop(const std::vector<std::filesystem::path>& files) override { open(files); }
  void entered(int entered) override { interface_->entered(entered); }
  void focused(int focused) override { interface_->focused(focused); }
  void refresh() override { wake(); }
  void close() override { request(Request::leave); }

  ViewerOptions options_;
  Session session_;
  std::optional<ViewState> good_;
  Camera home_, camera_;  // camera_: of the last step
  Window window_;
  float scale_;
  Device device_;
  Swapchain swapchain_;
  Shown shown_;
  Beside beside_;
  std::optional<Interface> interface_;
  Panels panels_;
  Prompts prompts_;
  Hand hand_;
  Layout layout_;
  Messages messages_{[this] { wake(); }};
  LateKeys late_keys_;
  FrameTimes times_;
  std::string title_;
  bool opened_by_letter_ = false;
  std::optional<Shown::Probe> probe_;
  glm::vec2 probe_at_{0};
  int awake_ = kFramesAfterInput;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace brdf::render
