#include "render/viewer/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace brdf::render {
namespace {

constexpr float kTurn = 0.1f;        // radians per arrow key
constexpr float kStops = 0.25f;      // of exposure
constexpr float kMostStops = 20.0f;  // as in a scene file

void next_form(ViewState& state, bool by_family) {
  Term& term = state.scene.objects[state.selected].material.terms[0];
  if (!by_family) {
    const std::span<const Reflectance> forms = catalogue();
    return switch_form(term, forms[std::size_t(catalogue_index(term.form) + 1) % forms.size()]);
  }
  const std::vector<std::vector<Reflectance>> groups = families();
  const auto own = std::find_if(groups.begin(), groups.end(), [&](const std::vector<Reflectance>& group) {
    return std::find(group.begin(), group.end(), term.form) != group.end();
  });
  const bool last = own == groups.end() || own + 1 == groups.end();
  switch_form(term, (last ? groups.front() : own[1]).front());
}

template <class Enum>
void advance(Enum& value) {
  value = Enum((std::size_t(value) + 1) % kNames<Enum>.size());
}

void toggle(ViewState& state, Display display) {
  state.display = state.display == display ? Display::picture : display;
}

void expose(ViewState& state, float stops) {
  state.scene.exposure = std::clamp(state.scene.exposure + stops, -kMostStops, kMostStops);
}

// The keys of the camera; false for any other.
bool move_camera(Camera& camera, int key, const Whereabouts& where) {
  switch (key) {
    case GLFW_KEY_R:
      camera = where.home;
      return true;
    case GLFW_KEY_F:
      fit(camera, where.bounds);
      return true;
    case GLFW_KEY_LEFT:
      orbit(camera, -kTurn, 0);
      return true;
    case GLFW_KEY_RIGHT:
      orbit(camera, kTurn, 0);
      return true;
    case GLFW_KEY_UP:
      orbit(camera, 0, kTurn);
      return true;
    case GLFW_KEY_DOWN:
      orbit(camera, 0, -kTurn);
      return true;
    default:
      return false;
  }
}

}  // namespace

KeyRequest press(ViewState& state, int key, int mods, const Whereabouts& where) {
  const bool control = mods & GLFW_MOD_CONTROL;
  if (move_camera(state.scene.camera, key, where)) return KeyRequest::none;
  switch (key) {
    case GLFW_KEY_ESCAPE:
    case GLFW_KEY_Q:
      return KeyRequest::quit;
    case GLFW_KEY_O:
      return KeyRequest::ask_for_file;
    case GLFW_KEY_P:
      return KeyRequest::screenshot;
    case GLFW_KEY_S:
      if (control) return KeyRequest::save;
      toggle(state, Display::split);
      break;
    case GLFW_KEY_L:
      if (control) return KeyRequest::load;
      state.show_plot = !state.show_plot;
      break;
    case GLFW_KEY_N:
      next_form(state, mods & GLFW_MOD_SHIFT);
      break;
    case GLFW_KEY_M:
      advance(state.scene.shading);
      break;
    case GLFW_KEY_C:
      advance(state.scene.tone_map);
      break;
    case GLFW_KEY_K:
      advance(state.other);
      break;
    case GLFW_KEY_G:
      toggle(state, Display::gbuffer);
      break;
    case GLFW_KEY_D:
      toggle(state, Display::difference);
      break;
    case GLFW_KEY_B:
      toggle(state, Display::flip);
      break;
    case GLFW_KEY_T:
      state.turntable = !state.turntable;
      break;
    case GLFW_KEY_H:
      state.show_ui = !state.show_ui;
      break;
    case GLFW_KEY_KP_ADD:
    case GLFW_KEY_EQUAL:
      expose(state, kStops);
      break;
    case GLFW_KEY_KP_SUBTRACT:
    case GLFW_KEY_MINUS:
      expose(state, -kStops);
      break;
    default:
      break;
  }
  return KeyRequest::none;
}

}  // namespace brdf::render
