// The questions that the window asks: the file to open, the name to save under, whether to leave.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace brdf::render {

struct Answers {
  std::string open, save_material;  // names of files; empty: no answer
  bool save_and_leave = false, leave = false;
};

class Prompts {
 public:
  void ask_for_file();
  void ask_for_material(const std::string& name);
  void ask_to_leave();
  // Returns whether a question is asked now or will be asked in the next frame; all keys then belong to the
  // question.
  bool asking() const { return asked_ != Asked::nothing; }
  // Returns whether the question accepts letters yet; earlier letters have to wait.
  bool takes_letters() const { return focused_; }
  // Returns whether an answer waits for the next frame; keys that arrive now no longer belong to the
  // question.
  bool answered() const { return entered_ && !complete_; }
  // Handles Enter, Tab and letters (GLFW's numbers) while a question is asked.
  void key(int key);
  void dismiss() { asked_ = Asked::nothing; }

  // Call between ImGui::NewFrame and ImGui::Render.
  Answers draw(float scale);

 private:
  enum class Asked { nothing, file, material, leave };
  void ask(Asked what, const std::string& text);
  bool text_line();  // true when a name was entered
  void file_list(Answers& answers);
  void file(Answers& answers);
  void material(Answers& answers);
  void leave(Answers& answers);
  void set_text(const std::string& text);

  Asked asked_ = Asked::nothing;
  bool fresh_ = false, focused_ = false, complete_ = false, entered_ = false, replace_ = false;
  int letter_ = 0;
  std::vector<char> text_;
  std::optional<std::string> new_text_;  // replaces the typed text
  std::string listed_for_;
  std::vector<std::string> names_, recent_;
};

}  // namespace brdf::render
