#include "render/viewer/viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <array>
#include <chrono>
#include <iostream>

#include "io/error.h"
#include "io/output.h"
#include "render/viewer/display_pass.h"
#include "render/viewer/interface.h"
#include "render/viewer/keys.h"
#include "render/viewer/panels.h"
#include "render/viewer/window.h"

namespace brdf::render {
namespace {

constexpr int kSplitLine = GLFW_MOUSE_BUTTON_LAST + 1;  // what is dragged, beside the mouse's buttons
constexpr double kNearLine = 8;                         // pixels
constexpr int kFramesAfterInput = 3;                    // Dear ImGui settles within three

class Viewer {
 public:
  explicit Viewer(const ViewerOptions& options)
      : options_(options),
        state_(options.state),
        home_(state_.scene.camera),
        window_(options.width, options.height, "brdf"),
        device_({.instance_extensions = window_.instance_extensions(),
                 .memory_limit = options.memory_limit,
                 .validation = options.validation}),
        swapchain_(device_, window_),
        pictures_(device_, {.gbuffer_bits = options.gbuffer_bits}, options.samples, {}, true),
        display_(device_, swapchain_.render_pass()) {
    glfwSetWindowUserPointer(window_.get(), this);
    glfwSetKeyCallback(window_.get(), [](GLFWwindow* w, int key, int, int action, int mods) {
      if (action != GLFW_RELEASE) of(w).key(key, mods);
    });
    glfwSetScrollCallback(window_.get(), [](GLFWwindow* w, double, double y) { of(w).scroll(y); });
    glfwSetCursorPosCallback(window_.get(), [](GLFWwindow* w, double x, double y) { of(w).cursor(x, y); });
    glfwSetMouseButtonCallback(window_.get(), [](GLFWwindow* w, int button, int action, int mods) {
      of(w).button(button, action, mods);
    });
    glfwSetDropCallback(window_.get(), [](GLFWwindow* w, int count, const char** files) {
      of(w).open({files, files + count});
    });
    glfwSetWindowRefreshCallback(window_.get(), [](GLFWwindow* w) { of(w).wake(); });
    interface_.emplace(device_, window_, swapchain_);
  }

  unsigned run() {
    for (int drawn = 0; !glfwWindowShouldClose(window_.get()); ++drawn) {
      if (options_.frames > 0 && drawn >= options_.frames) break;
      const bool busy = state_.turntable || awake_ > 0 || options_.frames > 0 || pictures_.unfinished();
      busy ? glfwPollEvents() : glfwWaitEvents();
      if (awake_ > 0) --awake_;
      step();
      frame();
    }
    return device_.validation_messages();
  }

 private:
  static Viewer& of(GLFWwindow* window) { return *static_cast<Viewer*>(glfwGetWindowUserPointer(window)); }
  void wake() { awake_ = kFramesAfterInput; }
  Camera& camera() { return state_.scene.camera; }

  void step() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    if (seconds > 0 && seconds < 1) frame_rate_ = 0.9f * frame_rate_ + 0.1f * float(1 / seconds);
    if (!state_.turntable) return;
    float& angle = state_.scene.objects[state_.selected].rotation.y;
    angle = std::fmod(angle + 45 * float(std::min(seconds, 0.1)), 360.0f);
  }

  void frame() {
    const VkExtent2D size = window_.framebuffer_size();
    if (size.width == 0 || size.height == 0) return;
    draw_pictures(size);
    interface_->begin_frame();
    const PanelRequests requests =
        panels_.draw(state_, {&pictures_, frame_rate_, device_.name(), message_, probe_});
    ImGui::Render();
    const VkExtent2D drawn = pictures_.a().color().extent();
    swapchain_.frame(
        [&](VkCommandBuffer commands) { pictures_.prepare_to_sample(commands); },
        [&](VkCommandBuffer commands) {
          ViewState shown = state_;
          if (shown.display == Display::gbuffer && !pictures_.has_targets()) {
            shown.display = Display::picture;
          }
          // A resize between the pictures and the swapchain: shown in the next frame.
          if (drawn.width == swapchain_.extent().width && drawn.height == swapchain_.extent().height) {
            display_.record(commands, shown, drawn, pictures_.extent(), pictures_.bits());
          }
          interface_->record(commands);
        });
    obey(requests);
  }

  // Where the state cannot be drawn (a file has vanished, too little memory), the last good one comes back.
  void draw_pictures(VkExtent2D size) {
    try {
      pictures_.update(state_, size);
      good_ = state_;
    } catch (const InputError& error) {
      if (!good_) throw;
      complain(error);
      state_ = *good_;
      pictures_.update(state_, size);
    }
    if (pictures_.images_changed()) {
      display_.show(pictures_.a_image(), pictures_.b_image(),
                    pictures_.has_targets() ? &pictures_.a() : nullptr);
    }
  }

  void obey(const PanelRequests& requests) {
    if (requests.reset_camera) camera() = home_;
    if (requests.fit_camera) fit(camera(), pictures_.prepared().bounds);
    if (requests.screenshot) screenshot();
    if (requests.save) save();
    if (requests.load) open({options_.state_file});
    if (!requests.open.empty()) open({requests.open});
    if (ImGui::GetIO().WantCaptureMouse || ImGui::IsAnyItemActive()) wake();
  }

  void say(const std::string& message) {
    message_ = message;
    wake();
  }
  void complain(const std::exception& error) {
    say(error.what());
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
      const ViewState before = state_;
      const bool good = attempt([&] {
        const VkExtent2D size = window_.framebuffer_size();
        if (size.width > 0 &&
            size.height > 0) {  // the split goes through the highlight as the window shows it
          camera().width = int(size.width);
          camera().height = int(size.height);
        }
        open_file(state_, file);
        if (size.width > 0 && size.height > 0) pictures_.update(state_, size);
        arrive(before);
        const std::string note = left_out_note(state_);
        say("opened " + file.string() + (note.empty() ? "" : "; " + note));
      });
      if (good) continue;
      state_ = before;
      if (failed.empty()) failed = message_;
    }
    if (!failed.empty()) message_ = failed;
  }
  // A file's own camera is the new home; a model is looked at as a whole.
  void arrive(const ViewState& before) {
    const Camera &now = camera(), &then = before.scene.camera;
    const bool moved = now.position != then.position || now.target != then.target;
    const bool other_mesh =
        state_.scene.objects[state_.selected].mesh != before.scene.objects[before.selected].mesh;
    if (other_mesh && !moved) fit(camera(), pictures_.prepared().bounds);
    if (moved || other_mesh) home_ = camera();
  }
  void save() {
    attempt([&] {
      // The picture's size is the window's: `brdf render --state` makes the same picture.
      const VkExtent2D size = window_.framebuffer_size();
      ViewState saved = state_;
      saved.scene.camera.width = int(std::max(1u, size.width));
      saved.scene.camera.height = int(std::max(1u, size.height));
      io::write_file_atomically(options_.state_file, state_text(saved));
      say("saved " + options_.state_file.string());
    });
  }
  void screenshot() {
    attempt([&] {
      write_png(options_.screenshot, pictures_.capture(state_));
      say("wrote " + options_.screenshot.string());
    });
  }

  void key(int key, int mods) {
    wake();
    if (ImGui::GetIO().WantTextInput || panels_.asking()) {
      if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) panels_.accept();
      return;
    }
    switch (press(state_, key, mods, {home_, pictures_.prepared().bounds})) {
      case KeyRequest::quit:
        glfwSetWindowShouldClose(window_.get(), GLFW_TRUE);
        break;
      case KeyRequest::save:
        save();
        break;
      case KeyRequest::load:
        open({options_.state_file});
        break;
      case KeyRequest::screenshot:
        screenshot();
        break;
      case KeyRequest::ask_for_file:
        panels_.ask_for_file();
        break;
      case KeyRequest::none:
        break;
    }
  }

  void scroll(double y) {
    wake();
    if (!ImGui::GetIO().WantCaptureMouse) zoom(camera(), float(std::pow(0.9, y)));
  }

  void button(int button, int action, int mods) {
    wake();
    glfwGetCursorPos(window_.get(), &cursor_[0], &cursor_[1]);
    if (ImGui::GetIO().WantCaptureMouse && action == GLFW_PRESS) return;
    dragging_ = action == GLFW_PRESS ? button : -1;
    if (dragging_ == GLFW_MOUSE_BUTTON_LEFT && on_split_line()) dragging_ = kSplitLine;
    if (action == GLFW_PRESS && (button == GLFW_MOUSE_BUTTON_MIDDLE || mods & GLFW_MOD_SHIFT)) {
      dragging_ = -1;
      probe_ = pixel_probe(pictures_.prepared(), int(cursor_[0]), int(cursor_[1]));
    }
  }

  bool on_split_line() const {
    const double line = double(state_.split) * window_.framebuffer_size().width;
    return state_.display == Display::split && std::abs(cursor_[0] - line) <= kNearLine;
  }

  void cursor(double x, double y) {
    wake();
    const float dx = float(x - cursor_[0]), dy = float(y - cursor_[1]);
    cursor_ = {x, y};
    const VkExtent2D size = window_.framebuffer_size();
    if (dragging_ == kSplitLine)
      state_.split = glm::clamp(float(x) / float(std::max(1u, size.width)), 0.0f, 1.0f);
    if (dragging_ == GLFW_MOUSE_BUTTON_LEFT) orbit(camera(), -dx * 0.008f, dy * 0.008f);
    if (dragging_ == GLFW_MOUSE_BUTTON_RIGHT) {
      pan(camera(), {dx / float(std::max(1u, size.width)), dy / float(std::max(1u, size.height))});
    }
  }

  ViewerOptions options_;
  ViewState state_;
  std::optional<ViewState> good_;
  Camera home_;
  Window window_;
  Device device_;
  Swapchain swapchain_;
  Pictures pictures_;
  DisplayPass display_;
  std::optional<Interface> interface_;
  Panels panels_;
  std::string message_;
  std::optional<PixelProbe> probe_;
  std::array<double, 2> cursor_{};
  int dragging_ = -1;
  int awake_ = kFramesAfterInput;
  float frame_rate_ = 0;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

unsigned view(const ViewerOptions& options) {
  return Viewer(options).run();
}

}  // namespace brdf::render
