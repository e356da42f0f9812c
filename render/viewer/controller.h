// The window's loop: what the hand does becomes changes of the session, the session becomes pictures.
// controller.cpp draws, controller_input.cpp hears keys and the mouse, controller_requests.cpp does what is
// asked for.
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
  static constexpr int kFramesAfterInput = 3;  // Dear ImGui settles within three

  void wake() { awake_ = kFramesAfterInput; }
  ViewState& state() { return session_.state(); }
  Camera& camera() { return state().scene.camera; }

  void step();
  // Also between two frames, so that what is saved there is as it will be seen.
  void follow();
  bool edited() const;  // an edit goes on
  bool held() const;    // or something moves by itself
  void frame();
  Whereabouts whereabouts() const { return {home_, shown_.drawn() ? &shown_.drawn()->prepared() : nullptr}; }
  PanelInfo info();
  // Where the state cannot be drawn (a file has vanished, too little memory), the last good one comes back.
  void draw_pictures();
  // Ends an edit before the next begins. What cannot be drawn is no step of the history: it is tried first.
  void settle();

  void request(Request asked);
  // What a step of the history has changed.
  void went(const std::string& what, const std::string& words, const std::string& nothing);
  void obey(const Answers& answers);
  void leave();
  void fitted();
  // Each file in turn; one that cannot be shown leaves everything as it was, and its message stays.
  void open(const std::vector<std::filesystem::path>& files);
  // A file's own camera is the new home; a model is looked at as a whole.
  void arrive(const ViewState& before);
  // The picture's size is the one that is shown: `brdf render --state` makes the same picture.
  bool save_state();

  // Dear ImGui hears of everything first: what is meant for it, it says.
  void key(int key, int scancode, int action, int mods) override;
  void pressed(int key, int mods);
  // The letter of the key that opened a question is not part of the answer.
  void letter(unsigned code) override;
  void scroll(double x, double y) override;
  void button(int button, int action, int mods) override;
  // On an object: it is selected.
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
  std::optional<PixelProbe> probe_;
  glm::vec2 probe_at_{0};
  int awake_ = kFramesAfterInput;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace brdf::render
