#include "render/viewer/controller.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "render/viewer/file_names.h"

namespace brdf::render {
namespace {

constexpr double kLook = 0.05;   // seconds between checks of background work
constexpr float kOrbit = 0.03f;  // radians per frame

float display_scale(const Window& window, float asked) {
  if (asked > 0) return asked;
  float x = 1, y = 1;
  glfwGetWindowContentScale(window.get(), &x, &y);
  return std::clamp(x, 0.5f, 4.0f);
}

}  // namespace

Controller::Controller(const ViewerOptions& options)
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

ViewerReport Controller::run() {
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

void Controller::step() {
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

void Controller::follow() {
  if (state().light_follows) follow_camera(state().scene, camera_);
  camera_ = camera();
}

bool Controller::edited() const {
  return hand_.holds() != Hand::Holds::nothing || ImGui::IsAnyItemActive() || options_.orbit;
}

bool Controller::held() const {
  return edited() || session_.state().turntable;
}

void Controller::frame() {
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
  swapchain_.frame(
      [&](VkCommandBuffer commands) { shown_.prepare(commands, state(), pixels_of(layout_.picture).extent); },
      [&](VkCommandBuffer commands) {
        // After a resize between the drawing of the pictures and the swapchain's frame, the
        // pictures are shown in the next frame.
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
  if (!edited()) session_.record();
  if (ImGui::IsAnyItemActive()) wake();
  if (const std::string title = session_.title(); title != title_)
    glfwSetWindowTitle(window_.get(), (title_ = title).c_str());
}

PanelInfo Controller::info() {
  beside_.look(session_, held());
  PanelInfo info{
      .pictures = shown_.drawn(), .samples = beside_.samples_in_colour(), .frame_ms = times_.last_ms()};
  if (state().show_plot && state().show_ui) info.residuals = beside_.residuals(session_);
  info.coarse = shown_.coarse();
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

void Controller::draw_pictures() {
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

void Controller::settle() {
  if (!session_.edited()) return;
  if (good_) {
    ViewState seen = *good_;
    seen.scene.camera = camera();
    if (seen != state()) draw_pictures();
  }
  session_.record();
}

}  // namespace brdf::render
