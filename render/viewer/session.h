// What is open in the window: a state, what was done to it, and the file that it came from.
#pragma once

#include <functional>
#include <map>

#include "render/viewer/history.h"

namespace brdf::render {

class Session {
 public:
  // `file`: where the state came from; empty: nowhere.
  Session(ViewState state, std::filesystem::path file);

  ViewState& state() { return state_; }
  const ViewState& state() const { return state_; }
  const std::filesystem::path& file() const { return file_; }

  // Ends an edit: what differs from the last step becomes one.
  void record() { history_.record(state_); }
  // Whether there is one.
  bool edited() const { return !same_edit(state_, history_.now()); }
  // Go a step back or forth; say what changed, empty where there is no step.
  std::string undo();
  std::string redo();
  std::size_t steps() const { return history_.steps(); }

  // Opens a file of any kind; `check` draws it, and throws InputError where that cannot be done. Nothing has
  // then changed. Throws InputError.
  void open(const std::filesystem::path& file, const std::function<void()>& check);
  // As it was when the last file was opened.
  void revert();
  // Writes the whole state, with this picture's size; or the selected object's material. Throws as io's
  // writers.
  void save_state(const std::filesystem::path& file, int width, int height);
  void save_material(const std::filesystem::path& file);

  // Whether leaving would lose something: a material, an object, a light or B differs from what was opened or
  // saved. Looking around is no change.
  bool changed() const;
  // The window's: "brass.json*".
  std::string title() const;
  // What the selected object is called: its material's name, "(changed)" after it where its file has another.
  std::string name_of_a() const;
  // This term as the file has it; null where that has another form there.
  const Term* in_file(std::size_t term) const;

  // Gives a term of the selected object another form, with the values that it had when it last had this form.
  void switch_form(std::size_t term, const Reflectance& form);

 private:
  void arrived(const std::filesystem::path& file);

  ViewState state_;
  History history_;
  std::filesystem::path file_;
  ViewState opened_, kept_;  // as the last file had it; as it was last written or opened
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Term>> forms_;  // by object and term
};

// A name for an object in a list: its label, else its mesh's where that says more than "sphere", and its
// material's.
std::string object_name(const Object& object, std::size_t place);

}  // namespace brdf::render
