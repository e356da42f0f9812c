#include "render/viewer/interface.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "render/text/font.h"

namespace brdf::render {
namespace {

constexpr float kLetters = 15;  // pixels at scale 1

void add_font(float scale) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  static const ImWchar ranges[] = {0x20,   0x17F,  0x370,  0x3FF,  0x2010, 0x2044,
                                   0x2190, 0x21FF, 0x2200, 0x22FF, 0};
  const float size = std::round(kLetters * scale);
  if (const std::filesystem::path font = Font::plain(); std::filesystem::exists(font))
    fonts.AddFontFromFileTTF(font.c_str(), size, nullptr, ranges);
  else
    ImGui::GetIO().FontGlobalScale = scale;  // the built-in font
}

void set_style(float scale) {
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = style.PopupRounding = 0;
  style.FrameRounding = 3;
  style.WindowBorderSize = 0;
  style.GrabMinSize = 6;  // leaves the number on the slider legible
  style.Colors[ImGuiCol_WindowBg] = ImVec4(0.13f, 0.13f, 0.15f, 1);
  style.Colors[ImGuiCol_SliderGrab] = ImVec4(0.36f, 0.60f, 0.95f, 0.7f);
  style.Colors[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0);
  style.ScaleAllSizes(scale);
}

}  // namespace

Interface::Interface(Device& device, const Window& window, const Swapchain& swapchain, float scale)
    : window_(window.get()) {
  constexpr std::array kBindings{Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
  pool_ = make_descriptor_pool(device, kBindings, 1, true);
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  add_font(scale);
  set_style(scale);
  ImGui_ImplGlfw_InitForVulkan(window.get(), false);
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

Interface::~Interface() {
  ImGui_ImplVulkan_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void Interface::begin_frame() {
  for (const KeyEvent& event : std::exchange(due_, std::exchange(late_, {})))
    ImGui_ImplGlfw_KeyCallback(window_, event.key, event.scancode, GLFW_RELEASE, event.mods);
  pressed_.clear();
  if (!keep_letters_)
    for (const unsigned code : std::exchange(letters_, {})) ImGui_ImplGlfw_CharCallback(window_, code);
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Interface::key(int key, int scancode, int action, int mods) {
  if (action == GLFW_PRESS) pressed_.push_back(key);
  if (action == GLFW_RELEASE && std::ranges::find(pressed_, key) != pressed_.end())
    late_.push_back({key, scancode, mods});
  else
    ImGui_ImplGlfw_KeyCallback(window_, key, scancode, action, mods);
}

void Interface::letter(unsigned code) {
  letters_.push_back(code);
}

void Interface::scroll(double x, double y) {
  ImGui_ImplGlfw_ScrollCallback(window_, x, y);
}

void Interface::button(int button, int action, int mods) {
  ImGui_ImplGlfw_MouseButtonCallback(window_, button, action, mods);
}

void Interface::entered(int entered) {
  ImGui_ImplGlfw_CursorEnterCallback(window_, entered);
}

void Interface::focused(int focused) {
  ImGui_ImplGlfw_WindowFocusCallback(window_, focused);
}

void Interface::record(VkCommandBuffer commands) {
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
}

}  // namespace brdf::render
