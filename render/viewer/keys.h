// What the viewer's keys do to the view.
#pragma once

#include "render/compare/state.h"

namespace brdf::render {

// What a key asks for that is no change of the state.
enum class KeyRequest { none, quit, save, load, screenshot, ask_for_file };

struct Whereabouts {
  Camera home;       // where the reset key goes
  glm::vec4 bounds;  // of the scene: what the fit key fits
};

// A key of GLFW with its modifiers, pressed or repeated.
KeyRequest press(ViewState& state, int key, int mods, const Whereabouts& where);

}  // namespace brdf::render
