#include "render/viewer/viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "render/viewer/beside.h"
#include "render/viewer/display_pass.h"
#include "render/viewer/file_names.h"
#include "render/viewer/frame_times.h"
#include "render/viewer/hand.h"
#include "render/viewer/interface.h"
#include "render/viewer/late_keys.h"
#include "render/viewer/messages.h"
#include "render/viewer/panels.h"
#include "render/viewer/prompts.h"
#include "render/viewer/shown.h"
#include "render/viewer/window.h"

namespace brdf::render {
namespace {

constexpr int kFramesAfterInput = 3;  // Dear ImGui settles within three
constexpr double kLook = 0.05;        // seconds between looks at what goes on by itself
constexpr float kOrbit = 0.03f;       // radians per frame

float display_scale(const Window& window, float asked) {
  if (asked > 0) return asked;
  float x = 1, y = 1;
  glfwGetWindowContentScale(window.get(), &x, &y);
  return std::clamp(x, 0.5f, 4.0f);
}

class Viewer : private Listener {
 public:
  explicit Viewer(const ViewerOptions& options)
      : options_(options),
        session_(options.state, options.file),
        home_(options.state.scene.camera),
        camera_(home_),
        window_(options.width, options.height, session_.title()),
        scale_(display_scale(window_, options.scale)),
        device_({.instance_extensions = window_.instance_extensions(),
                 .memory_limit = options.memory_limit,
                 .validation = options.validation}),
        swapchain_(device_, window_),
        shown_(device_, swapchain_.render_pass(), options.gbuffer_bits, options.samples),
        beside_(options.solver),
        times_(options.frames > 0) {
    window_.listen(*this);
    interface_.emplace(device_, window_, swapchain_, scale_);
    if (!options.file.empty()) remember_file(options.file);
  }

  ViewerReport run() {
    int drawn = 0;
    for (; !glfwWindowShouldClose(window_.get()); ++drawn) {
      if (options_.frames > 0 && drawn >= options_.frames) break;
      const bool busy = session_.state().turntable || awake_ > 0 || options_.frames > 0 ||
                        shown_.unfinished() || interface_->waiting();
      if (busy)
        glfwPollEvents();
      else if (shown_.moving() || beside_.fitting())
        glfwWaitEventsTimeout(kLook);
      else
        glfwWaitEvents();
      if (awake_ > 0) --awake_;
      step();
      frame();
    }
    return {device_.validation_messages(), times_.median_ms(), drawn};
  }

 private:
  void wake() { awake_ = kFramesAfterInput; }
  ViewState& state() { return session_.state(); }
  Camera& camera() { return state().scene.camera; }

  void step() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    if (options_.orbit) orbit(camera(), kOrbit, 0);
    if (state().turntable) {
      float& angle = state().scene.objects[state().selected].rotation.y;
      angle = std::fmod(angle + 45 * float(std::min(seconds, 0.1)), 360.0f);
    }
    follow();
    fitted();
  }
  // Also between two frames, so that what is saved there is as it will be seen.
  void follow() {
    if (state().light_follows) follow_camera(state().scene, camera_);
    camera_ = camera();
  }

  bool held() const {
    return hand_.holds() != Hand::Holds::nothing || ImGui::IsAnyItemActive() || session_.state().turntable ||
           options_.orbit;
  }

  void frame() {
    const VkExtent2D size = window_.framebuffer_size();
    if (size.width == 0 || size.height == 0) return;
    times_.begin();
    layout_ = layout_of(size, scale_, state().show_ui, state().show_plot);
    draw_pictures();
    interface_->keep_letters(prompts_.asking() && !prompts_.takes_letters());
    interface_->begin_frame();
    const std::vector<Request> requests = panels_.draw(session_, layout_, info(), whereabouts());
    const bool asking = prompts_.asking();
    const Answers answers = prompts_.draw(scale_);
    if (asking && !prompts_.asking()) late_keys_.wait(3);
    ImGui::Render();
    swapchain_.frame([&](VkCommandBuffer commands) { shown_.prepare(commands); },
                     [&](VkCommandBuffer commands) {
                       // A resize between the pictures and the swapchain: shown in the next frame.
                       const VkExtent2D now = swapchain_.extent();
                       if (now.width == size.width && now.height == size.height)
                         shown_.record(commands, state(), pixels_of(layout_.picture));
                       interface_->record(commands);
                     });
    times_.end();
    for (const Request asked : requests) request(asked);
    obey(answers);
    opened_by_letter_ = false;
    for (const LateKey& late : late_keys_.after_frame()) pressed(late.key, late.mods);
    if (!held()) session_.record();
    if (ImGui::IsAnyItemActive()) wake();
    if (const std::string title = session_.title(); title != title_)
      glfwSetWindowTitle(window_.get(), (title_ = title).c_str());
  }

  Whereabouts whereabouts() const { return {home_, shown_.drawn() ? &shown_.drawn()->prepared() : nullptr}; }

  PanelInfo info() {
    beside_.look(session_, held());
    PanelInfo info{.pictures = shown_.drawn(), .samples = beside_.samples(), .frame_ms = times_.last_ms()};
    info.moving = shown_.moving();
    info.device = device_.name();
    info.message = messages_.last();
    info.is_error = messages_.is_error();
    info.probe = probe_;
    info.probe_at = probe_at_;
    info.intervals = &beside_.intervals(session_);
    info.fitting = beside_.fitting() ? beside_.seconds() : -1;
    info.can_fit = beside_.can_fit();
    info.error = beside_.error();
    info.error_before = beside_.error_before();
    return info;
  }

  // Where the state cannot be drawn (a file has vanished, too little memory), the last good one comes back.
  void draw_pictures() {
    const VkExtent2D size = pixels_of(layout_.picture).extent;
    camera().width = int(size.width);
    camera().height = int(size.height);
    try {
      shown_.update(state(), size, held());
      good_ = state();
    } catch (const InputError& error) {
      if (!good_) throw;
      messages_.complain(error);
      state() = *good_;
      camera_ = camera();
      shown_.update(state(), size, false);
    }
  }

  // Ends an edit before the next begins. What cannot be drawn is no step of the history: it is tried first.
  void settle() {
    if (good_) {
      ViewState seen = *good_;
      seen.scene.camera = camera();
      if (seen != state()) draw_pictures();
    }
    session_.record();
  }

  void request(Request asked) {
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
        went(session_.redo(), "done again: ", "nothing to do again");
        break;
      case Request::revert:
        session_.revert();
        went("all as it was opened", "", "");
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
          messages_.say("fitting; ctrl+x stops, the best so far stays");
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

  // What a step of the history has changed.
  void went(const std::string& what, const std::string& words, const std::string& nothing) {
    messages_.say(what.empty() ? nothing : words + what);
    camera_ = camera();
  }

  void obey(const Answers& answers) {
    if (!answers.open.empty()) open({answers.open});
    if (!answers.save_material.empty())
      messages_.attempt([&] {
        session_.save_material(answers.save_material);
        remember_file(answers.save_material);
        messages_.say("saved the material as " + answers.save_material);
      });
    if (answers.leave || (answers.save_and_leave && save_state())) leave();
  }

  void leave() { glfwSetWindowShouldClose(window_.get(), GLFW_TRUE); }

  void fitted() {
    messages_.attempt([&] {
      const std::string words = beside_.take(session_);
      if (!words.empty()) messages_.say(words);
    });
  }

  // Each file in turn; one that cannot be shown leaves everything as it was, and its message stays.
  void open(const std::vector<std::filesystem::path>& files) {
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
  // A file's own camera is the new home; a model is looked at as a whole.
  void arrive(const ViewState& before) {
    const Camera &now = camera(), &then = before.scene.camera;
    const bool moved = now.position != then.position || now.target != then.target;
    const bool other_mesh =
        state().scene.objects[state().selected].mesh != before.scene.objects[before.selected].mesh;
    if (other_mesh && !moved) render::fit(camera(), shown_.drawn()->prepared().bounds);
    if (moved || other_mesh) home_ = camera();
    camera_ = camera();
  }
  // The picture's size is the one that is shown: `brdf render --state` makes the same picture.
  bool save_state() {
    return messages_.attempt([&] {
      const VkExtent2D size = pixels_of(layout_.picture).extent;
      session_.save_state(options_.state_file, int(size.width), int(size.height));
      messages_.say("saved " + options_.state_file.string());
    });
  }

  // Dear ImGui hears of everything first: what is meant for it, it says.
  void key(int key, int scancode, int action, int mods) override {
    interface_->key(key, scancode, action, mods);
    if (action != GLFW_RELEASE) pressed(key, mods);
  }

  void pressed(int key, int mods) {
    wake();
    // A question was answered, or closed, but Dear ImGui still wants text: what comes now is not for that.
    if (late_keys_.waiting() || prompts_.answered()) {
      late_keys_.add({key, mods});
      return;
    }
    if (prompts_.asking()) {
      prompts_.key(key);
      if (!prompts_.asking()) late_keys_.wait(2);
      return;
    }
    if (ImGui::GetIO().WantTextInput) {
      if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER || key == GLFW_KEY_ESCAPE) late_keys_.wait(3);
      return;
    }
    const Command* asked = command_of(key, mods);
    if (!asked) return;
    settle();
    if (asked->edit) asked->edit(session_, whereabouts());
    follow();
    if (asked->request != Request::none) request(asked->request);
    opened_by_letter_ = prompts_.asking() && !(mods & GLFW_MOD_CONTROL);
  }
  // The letter of the key that opened a question is not part of the answer.
  void letter(unsigned code) override {
    wake();
    if (!std::exchange(opened_by_letter_, false)) interface_->letter(code);
  }

  void scroll(double x, double y) override {
    interface_->scroll(x, y);
    wake();
    if (ImGui::GetIO().WantCaptureMouse || !hand_.on(layout_.picture)) return;
    zoom(camera(), float(std::pow(0.9, y)));
    shown_.touch();
  }

  void button(int button, int action, int mods) override {
    interface_->button(button, action, mods);
    wake();
    double x = 0, y = 0;
    glfwGetCursorPos(window_.get(), &x, &y);
    if (action == GLFW_RELEASE) {
      if (hand_.release() == Hand::Release::click) click();
      return;
    }
    hand_.move(state(), layout_.picture, x, y);
    if (ImGui::GetIO().WantCaptureMouse || !hand_.on(layout_.picture)) return;
    probe_.reset();
    if (button == GLFW_MOUSE_BUTTON_MIDDLE || mods & GLFW_MOD_SHIFT) {
      probe_ = shown_.probe(layout_.picture, hand_.place());
      probe_at_ = hand_.place();
      return;
    }
    settle();
    hand_.press(state(), layout_.picture, button, mods);
  }
  // On an object: it is selected.
  void click() {
    const PixelProbe probe = shown_.probe(layout_.picture, hand_.place());
    if (!probe.hit || probe.object == state().selected) return;
    state().selected = probe.object;
    messages_.say("selected " + object_name(state().scene.objects[probe.object], probe.object));
  }

  void cursor(double x, double y) override {
    wake();
    hand_.move(state(), layout_.picture, x, y);
  }

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

}  // namespace

ViewerReport view(const ViewerOptions& options) {
  return Viewer(options).run();
}

}  // namespace brdf::render
