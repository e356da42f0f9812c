// All commands of the window with their keys. The keyboard, the buttons, the help and the tests use this
// list.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "render/viewer/session.h"

namespace brdf::render {

// Requests that go beyond a change of the state.
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
  Camera home;                           // the camera that "home" restores
  const PreparedScene* drawn = nullptr;  // the scene to frame; null: nothing
};

struct Command {
  std::string_view name, group;
  std::string_view keys;  // "ctrl+s", "drag"; X11's names of keys, which programs send to the window
  std::string_view does;
  int key = 0, mods = 0;  // values of GLFW; 0: no key
  int second = 0;         // another key for the same command
  Request request = Request::none;
  void (*edit)(Session&, const Whereabouts&) = nullptr;
  std::string_view no_undo{};  // why the command cannot be undone; empty: it can
};

std::span<const Command> commands();
// Returns the command of a key with these modifiers, or null.
const Command* command_of(int key, int mods);
// Returns the command with this name, which must exist.
const Command& command(std::string_view name);

// Returns the keys of a command as they are printed on a keyboard: "=" for "equal".
std::string readable_keys(const Command& command);

// command_help() returns the list for --help, in as many columns as fit into `width` letters;
// command_json() returns the list as JSON for programs.
std::string command_help(std::size_t width);
std::string command_json();

}  // namespace brdf::render
