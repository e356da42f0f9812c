#include "render/viewer/viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

#include <array>
#include <chrono>
#include <fstream>
#include <iterator>

#include "io/error.h"
#include "io/output.h"
#include "render/viewer/display_pass.h"
#include "render/viewer/panels.h"
#include "render/viewer/window.h"

namespace brdf::render {
namespace {

constexpr int kFramesAfterInput = 3;  // Dear ImGui settles within three

// Dear ImGui with its GLFW and Vulkan backends.
class Interface {
 public:
  Interface(Device& device, const Window& window, const Swapchain& swapchain) {
    constexpr std::array kBindings{Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
    pool_ = make_descriptor_pool(device, kBindings, 1, true);
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplGlfw_InitForVulkan(window.get(), true);
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = device.instance();
    info.PhysicalDevice = device.physical();
    info.Device = device.get();
    info.QueueFamily = device.queue_family();
    info.Queue = device.queue();
    info.DescriptorPool = pool_.get();
    info.MinImageCount = 2;
    info.ImageCount = std::max(2u, swapchain.image_count());
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    ImGui_ImplVulkan_Init(&info, swapchain.render_pass());
    device.run([](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
  }
  ~Interface() {
    ImGui_ImplVulkan_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

 private:
  Owned<VkDescriptorPool> pool_;
};

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
        pictures_(device_, options.gbuffer_bits),
        display_(device_, swapchain_.render_pass()) {
    // Callbacks first: Dear ImGui's backend chains to those that are there.
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
      for (int k = 0; k < count; ++k) of(w).open(files[k]);
    });
    glfwSetWindowRefreshCallback(window_.get(), [](GLFWwindow* w) { of(w).wake(); });
    interface_.emplace(device_, window_, swapchain_);
  }

  unsigned run() {
    for (int drawn = 0; !glfwWindowShouldClose(window_.get()); ++drawn) {
      if (options_.frames > 0 && drawn >= options_.frames) break;
      const bool busy = state_.turntable || awake_ > 0 || options_.frames > 0;
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
    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
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
          ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
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
      message_ = error.what();
      state_ = *good_;
      pictures_.update(state_, size);
    }
    if (pictures_.images_changed()) {
      display_.show(pictures_.a().color(), pictures_.b_image(),
                    pictures_.has_targets() ? &pictures_.a() : nullptr);
    }
  }

  void obey(const PanelRequests& requests) {
    if (requests.reset_camera) camera() = home_;
    if (requests.fit_camera) fit(camera(), pictures_.prepared().bounds);
    if (requests.screenshot) screenshot();
    if (requests.save) save();
    if (requests.load) open(options_.state_file);
    if (!requests.open.empty()) open(requests.open);
    if (ImGui::GetIO().WantCaptureMouse || ImGui::IsAnyItemActive()) wake();
  }

  // Runs what may fail for want of a good file and says so in the window.
  template <class Action>
  void attempt(Action action) {
    try {
      action();
    } catch (const InputError& error) {
      message_ = error.what();
    } catch (const EnvironmentError& error) {
      message_ = error.what();
    }
    wake();
  }

  void open(const std::filesystem::path& file) {
    attempt([&] {
      open_file(state_, file);
      home_ = camera();
      message_ = "opened " + file.string();
    });
  }
  void save() {
    attempt([&] {
      io::write_file_atomically(options_.state_file, state_text(state_));
      message_ = "saved " + options_.state_file.string();
    });
  }
  void screenshot() {
    attempt([&] {
      write_png(options_.screenshot, pictures_.capture(state_));
      message_ = "wrote " + options_.screenshot.string();
    });
  }

  void next_form(bool by_family) {
    std::vector<AnyForm> forms;
    for_each_form([&](auto f) { forms.emplace_back(f); });
    Term& term = state_.scene.objects[state_.selected].material.terms[0];
    std::size_t k = term.form.index();
    const std::string_view family = info(term.form).family;
    do k = (k + 1) % forms.size();
    while (by_family && info(forms[k]).family == family);
    switch_form(term, forms[k]);
  }

  template <class Enum, std::size_t N>
  static void advance(Enum& value, const std::array<const char*, N>&) {
    value = Enum((std::size_t(value) + 1) % N);
  }
  void toggle(Display display) { state_.display = state_.display == display ? Display::picture : display; }

  void key(int key, int mods) {
    wake();
    if (ImGui::GetIO().WantTextInput) {
      if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) panels_.accept();
      return;
    }
    const bool control = mods & GLFW_MOD_CONTROL;
    constexpr float kTurn = 0.1f;
    switch (key) {
      case GLFW_KEY_ESCAPE:
      case GLFW_KEY_Q:
        glfwSetWindowShouldClose(window_.get(), GLFW_TRUE);
        break;
      case GLFW_KEY_N:
        next_form(mods & GLFW_MOD_SHIFT);
        break;
      case GLFW_KEY_M:
        advance(state_.scene.shading, kShadingNames);
        break;
      case GLFW_KEY_C:
        advance(state_.scene.tone_map, kToneMapNames);
        break;
      case GLFW_KEY_G:
        toggle(Display::gbuffer);
        break;
      case GLFW_KEY_D:
        toggle(Display::difference);
        break;
      case GLFW_KEY_B:
        toggle(Display::flip);
        break;
      case GLFW_KEY_K:
        advance(state_.other, kOtherNames);
        break;
      case GLFW_KEY_S:
        control ? save() : toggle(Display::split);
        break;
      case GLFW_KEY_O:
        panels_.ask_for_file();
        break;
      case GLFW_KEY_L:
        control ? open(options_.state_file) : void(state_.show_plot = !state_.show_plot);
        break;
      case GLFW_KEY_T:
        state_.turntable = !state_.turntable;
        break;
      case GLFW_KEY_H:
        state_.show_ui = !state_.show_ui;
        break;
      case GLFW_KEY_P:
        screenshot();
        break;
      case GLFW_KEY_R:
        camera() = home_;
        break;
      case GLFW_KEY_F:
        fit(camera(), pictures_.prepared().bounds);
        break;
      case GLFW_KEY_LEFT:
        orbit(camera(), -kTurn, 0);
        break;
      case GLFW_KEY_RIGHT:
        orbit(camera(), kTurn, 0);
        break;
      case GLFW_KEY_UP:
        orbit(camera(), 0, kTurn);
        break;
      case GLFW_KEY_DOWN:
        orbit(camera(), 0, -kTurn);
        break;
      case GLFW_KEY_KP_ADD:
      case GLFW_KEY_EQUAL:
        state_.scene.exposure = std::min(20.0f, state_.scene.exposure + 0.25f);
        break;
      case GLFW_KEY_KP_SUBTRACT:
      case GLFW_KEY_MINUS:
        state_.scene.exposure = std::max(-20.0f, state_.scene.exposure - 0.25f);
        break;
      default:
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
    if (action == GLFW_PRESS && (button == GLFW_MOUSE_BUTTON_MIDDLE || mods & GLFW_MOD_SHIFT)) {
      dragging_ = -1;
      probe_ = probe(pictures_.prepared(), int(cursor_[0]), int(cursor_[1]));
    }
  }

  void cursor(double x, double y) {
    wake();
    const float dx = float(x - cursor_[0]), dy = float(y - cursor_[1]);
    cursor_ = {x, y};
    const VkExtent2D size = window_.framebuffer_size();
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
  std::optional<Probe> probe_;
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
