#include "render/viewer/viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <utility>

#include "io/error.h"
#include "render/viewer/beside.h"
#include "render/viewer/display_pass.h"
#include "render/viewer/file_names.h"
#include "render/viewer/hand.h"
#include "render/viewer/interface.h"
#include "render/viewer/panels.h"
#include "render/viewer/prompts.h"
#include "render/viewer/shown.h"
#include "render/viewer/window.h"

namespace brdf::render {
namespace {

constexpr int kFramesAfterInput = 3;  // Dear ImGui settles within three
constexpr double kLook = 0.05;        // seconds between looks at what goes on by itself
constexpr std::size_t kWarming = 5;   // frames that are not counted
constexpr float kOrbit = 0.03f;       // radians per frame

float display_scale(const Window& window, float asked) {
  if (asked > 0) return asked;
  float x = 1, y = 1;
  glfwGetWindowContentScale(window.get(), &x, &y);
  return std::clamp(x, 0.5f, 4.0f);
}

class Viewer {
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
        beside_(options.solver) {
    listen();
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
    return {device_.validation_messages(), median_ms(), drawn};
  }

 private:
  static Viewer& of(GLFWwindow* window) { return *static_cast<Viewer*>(glfwGetWindowUserPointer(window)); }
  void wake() { awake_ = kFramesAfterInput; }
  ViewState& state() { return session_.state(); }
  Camera& camera() { return state().scene.camera; }

  // Dear ImGui hears of everything first: what is meant for it, it says.
  void listen() {
    GLFWwindow* window = window_.get();
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int code, int action, int mods) {
      of(w).interface_->key(key, code, action, mods);
      if (action != GLFW_RELEASE) of(w).key(key, mods);
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned letter) { of(w).letter(letter); });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
      of(w).interface_->scroll(x, y);
      of(w).scroll(y);
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { of(w).cursor(x, y); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
      of(w).interface_->button(button, action, mods);
      of(w).button(button, action, mods);
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** files) {
      of(w).open({files, files + count});
    });
    glfwSetCursorEnterCallback(window,
                               [](GLFWwindow* w, int entered) { of(w).interface_->entered(entered); });
    glfwSetWindowFocusCallback(window,
                               [](GLFWwindow* w, int focused) { of(w).interface_->focused(focused); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).wake(); });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
      glfwSetWindowShouldClose(w, GLFW_FALSE);
      of(w).request(Request::leave);
    });
  }

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
    const auto begun = std::chrono::steady_clock::now();
    const VkExtent2D size = window_.framebuffer_size();
    if (size.width == 0 || size.height == 0) return;
    layout_ = layout_of(size, scale_, state().show_ui, state().show_plot);
    draw_pictures();
    interface_->keep_letters(prompts_.asking() && !prompts_.takes_letters());
    interface_->begin_frame();
    const std::vector<Request> requests = panels_.draw(session_, layout_, info(), whereabouts());
    const bool asking = prompts_.asking();
    const Answers answers = prompts_.draw(scale_);
    if (asking && !prompts_.asking()) text_closing_ = 3;
    ImGui::Render();
    swapchain_.frame([&](VkCommandBuffer commands) { shown_.prepare(commands); },
                     [&](VkCommandBuffer commands) {
                       // A resize between the pictures and the swapchain: shown in the next frame.
                       const VkExtent2D now = swapchain_.extent();
                       if (now.width == size.width && now.height == size.height)
                         shown_.record(commands, state(), pixels_of(layout_.picture));
                       interface_->record(commands);
                     });
    frame_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
    if (options_.frames > 0) all_ms_.push_back(frame_ms_);
    for (const Request asked : requests) request(asked);
    obey(answers);
    opened_by_letter_ = false;
    if (text_closing_ > 0 && --text_closing_ == 0)
      for (const auto& [key, mods] : std::exchange(late_keys_, {})) this->key(key, mods);
    if (!held()) session_.record();
    if (ImGui::IsAnyItemActive()) wake();
    if (const std::string title = session_.title(); title != title_)
      glfwSetWindowTitle(window_.get(), (title_ = title).c_str());
  }

  Whereabouts whereabouts() const { return {home_, shown_.drawn() ? &shown_.drawn()->prepared() : nullptr}; }

  PanelInfo info() {
    beside_.look(session_, held());
    PanelInfo info{.pictures = shown_.drawn(), .samples = beside_.samples(), .frame_ms = frame_ms_};
    info.moving = shown_.moving();
    info.device = device_.name();
    info.message = message_;
    info.is_error = is_error_;
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
      complain(error);
      state() = *good_;
      camera_ = camera();
      shown_.update(state(), size, false);
    }
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
        attempt([&] {
          write_png(options_.screenshot, shown_.capture(state()));
          say("wrote " + options_.screenshot.string());
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
        attempt([&] {
          beside_.fit(session_);
          say("fitting; ctrl+x stops, the best so far stays");
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
    say(what.empty() ? nothing : words + what);
    camera_ = camera();
  }

  void obey(const Answers& answers) {
    if (!answers.open.empty()) open({answers.open});
    if (!answers.save_material.empty())
      attempt([&] {
        session_.save_material(answers.save_material);
        remember_file(answers.save_material);
        say("saved the material as " + answers.save_material);
      });
    if (answers.leave || (answers.save_and_leave && save_state())) leave();
  }

  void leave() { glfwSetWindowShouldClose(window_.get(), GLFW_TRUE); }

  void fitted() {
    attempt([&] {
      const std::string words = beside_.take(session_);
      if (!words.empty()) say(words);
    });
  }

  void say(const std::string& message) {
    message_ = message;
    is_error_ = false;
    wake();
  }
  void complain(const std::exception& error) {
    say(error.what());
    is_error_ = true;
    std::cerr << "brdf: " << error.what() << std::endl;
  }
  // Runs what may fail for want of a good file and says so in the window and on the terminal.
  template <class Action>
  bool attempt(Action action) {
    try {
      action();
      return true;
    } catch (const InputError& error) {
      complain(error);
    } catch (const EnvironmentError& error) {
      complain(error);
    }
    return false;
  }

  // Each file in turn; one that cannot be shown leaves everything as it was, and its message stays.
  void open(const std::vector<std::filesystem::path>& files) {
    std::string failed;
    for (const std::filesystem::path& file : files) {
      const ViewState before = state();
      const VkExtent2D size = pixels_of(layout_.picture).extent;
      const bool good = attempt([&] {
        session_.open(file, [&] {
          camera().width = int(size.width);
          camera().height = int(size.height);
          shown_.update(state(), size, false);
          arrive(before);
        });
        remember_file(file);
        const std::string note = left_out_note(state());
        say("opened " + file.string() + (note.empty() ? "" : "; " + note));
      });
      if (!good && failed.empty()) failed = message_;
    }
    if (failed.empty()) return;
    message_ = failed;
    is_error_ = true;
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
    return attempt([&] {
      const VkExtent2D size = pixels_of(layout_.picture).extent;
      session_.save_state(options_.state_file, int(size.width), int(size.height));
      say("saved " + options_.state_file.string());
    });
  }

  void key(int key, int mods) {
    wake();
    // A question was answered, or closed, but Dear ImGui still wants text: what comes now is not for that.
    if (text_closing_ > 0 || prompts_.answered()) {
      late_keys_.emplace_back(key, mods);
      return;
    }
    if (prompts_.asking()) {
      prompts_.key(key);
      if (!prompts_.asking()) text_closing_ = 2;
      return;
    }
    if (ImGui::GetIO().WantTextInput) {
      if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER || key == GLFW_KEY_ESCAPE) text_closing_ = 3;
      return;
    }
    const Command* asked = command_of(key, mods);
    if (!asked) return;
    session_.record();
    if (asked->edit) asked->edit(session_, whereabouts());
    follow();
    if (asked->request != Request::none) request(asked->request);
    opened_by_letter_ = prompts_.asking() && !(mods & GLFW_MOD_CONTROL);
  }
  // The letter of the key that opened a question is not part of the answer.
  void letter(unsigned code) {
    wake();
    if (!std::exchange(opened_by_letter_, false)) interface_->letter(code);
  }

  void scroll(double y) {
    wake();
    if (ImGui::GetIO().WantCaptureMouse || !hand_.on(layout_.picture)) return;
    zoom(camera(), float(std::pow(0.9, y)));
    shown_.touch();
  }

  void button(int button, int action, int mods) {
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
    session_.record();
    hand_.press(state(), layout_.picture, button, mods);
  }
  // On an object: it is selected.
  void click() {
    const PixelProbe probe = shown_.probe(layout_.picture, hand_.place());
    if (!probe.hit || probe.object == state().selected) return;
    state().selected = probe.object;
    say("selected " + object_name(state().scene.objects[probe.object], probe.object));
  }

  void cursor(double x, double y) {
    wake();
    hand_.move(state(), layout_.picture, x, y);
  }

  double median_ms() const {
    if (all_ms_.size() <= kWarming) return 0;
    std::vector<double> ms(all_ms_.begin() + kWarming, all_ms_.end());
    const auto middle = ms.begin() + std::ptrdiff_t(ms.size() / 2);
    std::nth_element(ms.begin(), middle, ms.end());
    return *middle;
  }

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
  std::string message_, title_;
  bool is_error_ = false, opened_by_letter_ = false;
  int text_closing_ = 0;                        // frames, until keys are the window's again
  std::vector<std::pair<int, int>> late_keys_;  // with their modifiers
  std::optional<PixelProbe> probe_;
  glm::vec2 probe_at_{0};
  int awake_ = kFramesAfterInput;
  double frame_ms_ = 0;
  std::vector<double> all_ms_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

ViewerReport view(const ViewerOptions& options) {
  return Viewer(options).run();
}

}  // namespace brdf::render
