#include "render/viewer/prompts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "render/viewer/file_names.h"

namespace brdf::render {
namespace {

constexpr std::size_t kLongestName = 1024;
constexpr float kWidth = 460, kListHeight = 220;  // at scale 1

int put_text(ImGuiInputTextCallbackData* data) {
  auto& text = *static_cast<std::optional<std::string>*>(data->UserData);
  if (!text) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, text->c_str());
  text.reset();
  return 0;
}

}  // namespace

void Prompts::ask(Asked what, const std::string& text) {
  asked_ = what;
  fresh_ = true;
  focused_ = complete_ = entered_ = replace_ = false;
  letter_ = 0;
  text_.assign(text.begin(), text.end());
  text_.resize(kLongestName, '\0');
  new_text_.reset();
  listed_for_ = "\n";  // no name contains it
}

void Prompts::ask_for_file() {
  recent_ = recent_files();
  ask(Asked::file, "");
}

void Prompts::ask_for_material(const std::string& name) {
  ask(Asked::material, name);
}

void Prompts::ask_to_leave() {
  ask(Asked::leave, "");
}

void Prompts::set_text(const std::string& text) {
  new_text_ = text.substr(0, kLongestName - 1);
}

void Prompts::key(int key) {
  if (key == GLFW_KEY_ESCAPE) return dismiss();
  if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) entered_ = true;
  if (key == GLFW_KEY_TAB) complete_ = true;
  letter_ = key;
}

bool Prompts::text_line() {
  ImGui::SetNextItemWidth(-1);
  if (fresh_) ImGui::SetKeyboardFocusHere();
  ImGui::InputText("##file", text_.data(), text_.size(), ImGuiInputTextFlags_CallbackAlways, put_text,
                   &new_text_);
  if (new_text_ && !ImGui::IsItemActive()) {  // the field is inactive: the callback is not called
    text_.assign(new_text_->begin(), new_text_->end());
    text_.resize(kLongestName, '\0');
    new_text_.reset();
  }
  focused_ = ImGui::IsItemActive();
  // The text now contains the letters typed before; Enter waits for the completion.
  if (std::exchange(complete_, false)) {
    set_text(completed(text_.data()));
    return false;
  }
  return std::exchange(entered_, false);
}

void Prompts::file_list(Answers& answers) {
  const std::string typed = text_.data();
  if (typed != listed_for_) {
    names_ = names_that_go_on(typed);
    listed_for_ = typed;
  }
  const auto choose = [&](const std::string& name) {
    if (!ImGui::Selectable(name.c_str())) return;
    if (name.ends_with('/'))
      set_text(name);
    else
      answers.open = name;
  };
  if (!recent_.empty()) ImGui::TextDisabled("recent files");
  for (const std::string& name : recent_) choose(name);
  ImGui::TextDisabled("in this folder");
  for (const std::string& name : names_) choose(name);
  if (names_.empty()) ImGui::TextDisabled("no file begins like this");
}

void Prompts::file(Answers& answers) {
  ImGui::TextUnformatted("Open a scene, material, samples, model or saved state");
  const bool entered = text_line();
  ImGui::BeginChild("names", ImVec2(0, kListHeight * ImGui::GetFontSize() / 15));
  file_list(answers);
  ImGui::EndChild();
  ImGui::TextDisabled("Tab completes, Enter opens, Esc closes");
  if (entered && text_[0] != '\0') answers.open = text_.data();
}

void Prompts::material(Answers& answers) {
  ImGui::TextUnformatted("Save the material as");
  const bool entered = text_line();
  const bool there = std::filesystem::exists(text_.data());
  if (there && replace_)
    ImGui::TextColored(ImVec4(1, 0.45f, 0.4f, 1), "the file exists: press Enter again to replace it");
  else
    ImGui::TextDisabled("Tab completes, Enter saves, Esc closes");
  if (!entered || text_[0] == '\0') return;
  if (there && !std::exchange(replace_, true)) return;
  answers.save_material = text_.data();
}

void Prompts::leave(Answers& answers) {
  ImGui::TextUnformatted("There are unsaved changes.");
  const int letter = std::exchange(letter_, 0);
  if (ImGui::Button("Save the state and leave (s)") || letter == GLFW_KEY_S) answers.save_and_leave = true;
  if (ImGui::Button("Leave without saving (x)") || letter == GLFW_KEY_X) answers.leave = true;
  if (ImGui::Button("Stay (Esc)")) dismiss();
}

Answers Prompts::draw(float scale) {
  Answers answers;
  constexpr const char* kName = "##question";
  if (asking() && fresh_) ImGui::OpenPopup(kName);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y * 0.2f), ImGuiCond_Always, ImVec2(0.5f, 0));
  ImGui::SetNextWindowSize(ImVec2(std::min(kWidth * scale, size.x), 0));
  if (!ImGui::BeginPopupModal(
          kName, nullptr,
          ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) {
    if (!fresh_) asked_ = Asked::nothing;
    return answers;
  }
  if (asked_ == Asked::file) file(answers);
  if (asked_ == Asked::material) material(answers);
  if (asked_ == Asked::leave) leave(answers);
  fresh_ = false;
  if (!answers.open.empty() || !answers.save_material.empty() || answers.leave || answers.save_and_leave)
    asked_ = Asked::nothing;
  if (!asking()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return answers;
}

}  // namespace brdf::render
