// Everything that a user can ask the window for, with its keys: what the keyboard, the buttons, the help and
// the tests go by.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "render/viewer/session.h"

namespace brdf::render {

// What is asked for beyond a change of the state.
enum class Request {
  none,
  leave,
  save_state,
  load_state,
  save_material,
  open,
  screenshot,
  undo,
  redo,
  revert,
  help,
  dismiss,
  fit_here,
  stop_fit
};

struct Whereabouts {
  Camera home;                           // where the camera goes back to
  const PreparedScene* drawn = nullptr;  // what is framed; null: nothing
};

struct Command {
  std::string_view name, group;
  std::string_view keys;  // in words: "ctrl+s", "drag"
  std::string_view does;
  int key = 0, mods = 0;  // GLFW's; 0: none
  int second = 0;         // another key of the same
  Request request = Request::none;
  void (*edit)(Session&, const Whereabouts&) = nullptr;
  std::string_view no_undo{};  // why it cannot be undone; empty: it can
};

std::span<const Command> commands();
// Null where no command has this key with these modifiers.
const Command* command_of(int key, int mods);
// By its name, which must be one of them.
const Command& command(std::string_view name);

// The list for --help, folded at so many letters; and as JSON for programs.
std::string command_help(std::size_t width);
std::string command_json();

}  // namespace brdf::render
