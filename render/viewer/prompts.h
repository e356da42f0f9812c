// The questions that the window asks: which file to open, under which name to save, whether to leave.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace brdf::render {

struct Answers {
  std::string open, save_material;  // files' names; empty: none
  bool save_and_leave = false, leave = false;
};

class Prompts {
 public:
  void ask_for_file();
  void ask_for_material(const std::string& name);
  void ask_to_leave();
  // Whether a question is asked, or will be with the next frame: keys are for it alone.
  bool asking() const { return asked_ != Asked::nothing; }
  // Whether letters can be taken: before that they have to wait.
  bool takes_letters() const { return focused_; }
  // Whether an answer waits for the next frame: keys that come now are not for the question any more.
  bool answered() const { return entered_ && !complete_; }
  // Enter, Tab and letters while a question is asked; GLFW's.
  void key(int key);
  void dismiss() { asked_ = Asked::nothing; }

  // Between ImGui::NewFrame and ImGui::Render.
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
  std::optional<std::string> new_text_;  // takes the place of what is typed
  std::string listed_for_;
  std::vector<std::string> names_, recent_;
};

}  // namespace brdf::render
