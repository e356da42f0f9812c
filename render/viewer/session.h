// The document that is open in the window: a state, its history, and the file from which it was read.
#pragma once

#include <functional>
#include <map>

#include "render/viewer/history.h"

namespace brdf::render {

class Session {
 public:
  // `file`: the source of the state; empty if the state does not come from a file.
  Session(ViewState state, std::filesystem::path file);

  ViewState& state() { return state_; }
  const ViewState& state() const { return state_; }
  const std::filesystem::path& file() const { return file_; }

  // Ends an edit: the changes since the last step become a step.
  void record() { history_.record(state_); }
  // Returns whether there are changes since the last step.
  bool edited() const { return !same_edit(state_, history_.now()); }
  // Go one step back or forth. Return a description of the changes; empty if there is no step.
  std::string undo();
  std::string redo();
  std::size_t steps() const { return history_.steps(); }

  // Opens a file of any kind. `check` draws the new state and throws InputError if this fails. Throws
  // InputError; the state is then unchanged.
  void open(const std::filesystem::path& file, const std::function<void()>& check);
  // Restores the state at the time when the last file was opened.
  void revert();
  // save_state() writes the whole state with this size of the picture, in pixels; save_material() writes
  // the material of the selected object. Throw the exceptions of io's writers.
  void save_state(const std::filesystem::path& file, int width, int height);
  void save_material(const std::filesystem::path& file);

  // Returns whether leaving would lose work: a material, an object, a light or B differs from the opened or
  // saved state. Changes of the view do not count.
  bool changed() const;
  // Returns the title of the window: "brass.json - brdf", preceded by "* " if there are unsaved changes.
  std::string title() const;
  // Returns the name of the selected object's material, followed by "(changed)" if the material differs
  // from the version that was last opened or saved.
  std::string name_of_a() const;
  // Returns this term as it was in the file, or null if the file has another form there.
  const Term* in_file(std::size_t term) const;

  // Gives a term of the selected object another form, with the values that the term had when it last had
  // this form.
  void switch_form(std::size_t term, const Reflectance& form);

 private:
  void arrived(const std::filesystem::path& file);

  ViewState state_;
  History history_;
  std::filesystem::path file_;
  ViewState opened_, kept_;  // state after the last opening; state after the last saving or opening
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Term>> forms_;  // by object and term
};

// Returns a name for an object in a list: its label, otherwise the name of its mesh (unless this is
// "sphere") and the name of its material, after its number.
std::string object_name(const Object& object, std::size_t place);

}  // namespace brdf::render
