#include "render/viewer/commands.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <stdexcept>

#include "io/files/json.h"
#include "render/light/formula.h"

namespace brdf::render {
namespace {

constexpr float kTurn = 0.1f;        // radians per arrow key
constexpr float kStops = 0.25f;      // of exposure
constexpr float kMostStops = 20.0f;  // as in a scene file
constexpr int kControl = GLFW_MOD_CONTROL, kShift = GLFW_MOD_SHIFT;
constexpr std::string_view kWrites = "writes a file", kWindow = "of the window, not of the state";

void next_form(Session& session, const Whereabouts&) {
  const std::span<const Reflectance> forms = catalogue();
  const Term& term = session.state().scene.objects[session.state().selected].material.terms.front();
  session.switch_form(0, forms[std::size_t(catalogue_index(term.form) + 1) % forms.size()]);
}

void next_family(Session& session, const Whereabouts&) {
  const Term& term = session.state().scene.objects[session.state().selected].material.terms.front();
  const std::vector<std::vector<Reflectance>> groups = families();
  const auto own = std::ranges::find_if(groups, [&](const std::vector<Reflectance>& group) {
    return std::ranges::find(group, term.form) != group.end();
  });
  const bool last = own == groups.end() || own + 1 == groups.end();
  session.switch_form(0, (last ? groups.front() : own[1]).front());
}

template <class Enum>
void advance(Enum& value) {
  value = Enum((std::size_t(value) + 1) % kNames<Enum>.size());
}

template <Display display>
void toggle(Session& session, const Whereabouts&) {
  Display& shown = session.state().display;
  shown = shown == display ? Display::picture : display;
}

template <int steps>
void expose(Session& session, const Whereabouts&) {
  float& stops = session.state().scene.exposure;
  stops = std::clamp(stops + float(steps) * kStops, -kMostStops, kMostStops);
}

template <int right, int up>
void turn(Session& session, const Whereabouts&) {
  orbit(session.state().scene.camera, float(right) * kTurn, float(up) * kTurn);
}

void frame_all(Session& session, const Whereabouts& where) {
  if (where.drawn) fit(session.state().scene.camera, bounds_of(*where.drawn, std::nullopt));
}

void frame_selected(Session& session, const Whereabouts& where) {
  if (where.drawn) fit(session.state().scene.camera, bounds_of(*where.drawn, session.state().selected));
}

void keep_as_b(Session& session, const Whereabouts&) {
  ViewState& state = session.state();
  state.material = state.scene.objects[state.selected].material;
  state.material_name = state.scene.objects[state.selected].material_name;
  state.other = Other::material;
  state.everywhere = false;
}

void keep_in_plot(Session& session, const Whereabouts&) {
  ViewState& state = session.state();
  const Object& object = state.scene.objects[state.selected];
  const std::string name = std::to_string(state.kept.size() + 1);
  state.kept.emplace_back(name, object.material);
  state.show_plot = true;
}

// Sets one directional light from a side of the camera and a little ambient light, and removes all other
// light.
template <int right, int up, int front>
void light_from(Session& session, const Whereabouts&) {
  Scene& scene = session.state().scene;
  const glm::vec3 back = glm::normalize(scene.camera.position - scene.camera.target);
  const glm::vec3 side = glm::normalize(glm::cross(scene.camera.up, back)), above = glm::cross(back, side);
  scene.environment.reset();
  scene.lights = {{false, -glm::normalize(float(right) * side + float(up) * above + float(front) * back),
                   glm::vec3(1), float(kPi)}};
  scene.ambient = glm::vec3(0.03f);
}

template <Formula formula>
void stand_in(Session& session, const Whereabouts&) {
  Scene& scene = session.state().scene;
  scene.environment = Environment{std::string(name_of(formula))};
  scene.lights.clear();
  scene.ambient = glm::vec3(0);
}

constexpr auto kEdits = std::array{
    Command{"orbit", "look", "drag", "turn the camera; on the line of a split: move it"},
    Command{"pan", "look", "right drag", "move the picture"},
    Command{"zoom", "look", "wheel", "closer, farther"},
    Command{"turn left", "look", "left", "turn the camera", GLFW_KEY_LEFT, 0, 0, Request::none, turn<-1, 0>},
    Command{"turn right", "look", "right", "turn the camera", GLFW_KEY_RIGHT, 0, 0, Request::none,
            turn<1, 0>},
    Command{"turn up", "look", "up", "turn the camera", GLFW_KEY_UP, 0, 0, Request::none, turn<0, 1>},
    Command{"turn down", "look", "down", "turn the camera", GLFW_KEY_DOWN, 0, 0, Request::none, turn<0, -1>},
    Command{"home", "look", "r", "the camera as it was in the beginning", GLFW_KEY_R, 0, 0, Request::none,
            [](Session& s, const Whereabouts& w) { s.state().scene.camera = w.home; }},
    Command{"frame", "look", "f", "all that is no ground fills the picture", GLFW_KEY_F, 0, 0, Request::none,
            frame_all},
    Command{"frame selected", "look", "shift+f", "the selected object fills the picture", GLFW_KEY_F, kShift,
            0, Request::none, frame_selected},
    Command{"brighter", "look", "equal", "a quarter of a stop", GLFW_KEY_EQUAL, 0, GLFW_KEY_KP_ADD,
            Request::none, expose<1>},
    Command{"darker", "look", "minus", "a quarter of a stop", GLFW_KEY_MINUS, 0, GLFW_KEY_KP_SUBTRACT,
            Request::none, expose<-1>},
    Command{"tone map", "look", "c", "the next one", GLFW_KEY_C, 0, 0, Request::none,
            [](Session& s, const Whereabouts&) { advance(s.state().scene.tone_map); }},
    Command{"shading", "look", "m", "the next mode", GLFW_KEY_M, 0, 0, Request::none,
            [](Session& s, const Whereabouts&) { advance(s.state().scene.shading); }},
    Command{"targets", "look", "g", "the seven targets of the renderer", GLFW_KEY_G, 0, 0, Request::none,
            toggle<Display::gbuffer>},
    Command{"turntable", "look", "t", "the object turns", GLFW_KEY_T, 0, 0, Request::none,
            [](Session& s, const Whereabouts&) { s.state().turntable = !s.state().turntable; }},
    Command{"lobes", "look", "l", "the plot of the lobe", GLFW_KEY_L, 0, 0, Request::none,
            [](Session& s, const Whereabouts&) { s.state().show_plot = !s.state().show_plot; }},
    Command{"select", "look", "click", "the object under the pointer"},
    Command{"probe", "look", "shift+click", "angles and f_r under the pointer; a click ends it", 0, 0, 0,
            Request::none, nullptr, kWindow},

    Command{"split", "compare", "s", "A left, B right", GLFW_KEY_S, 0, 0, Request::none,
            toggle<Display::split>},
    Command{"flip", "compare", "b", "B in place of A", GLFW_KEY_B, 0, 0, Request::none,
            toggle<Display::flip>},
    Command{"difference", "compare", "d", "false colours, with their numbers", GLFW_KEY_D, 0, 0,
            Request::none, toggle<Display::difference>},
    Command{"what B is", "compare", "k", "another material, samples, Embree", GLFW_KEY_K, 0, 0, Request::none,
            [](Session& s, const Whereabouts&) { advance(s.state().other); }},
    Command{"keep as B", "compare", "shift+b", "this material is B from now on", GLFW_KEY_B, kShift, 0,
            Request::none, keep_as_b},
    Command{"keep in plot", "compare", "shift+k", "this material's lobe stays in the plot", GLFW_KEY_K,
            kShift, 0, Request::none, keep_in_plot},

    Command{"next form", "edit", "n", "of all; each keeps its values", GLFW_KEY_N, 0, 0, Request::none,
            next_form},
    Command{"next family", "edit", "shift+n", "its first form", GLFW_KEY_N, kShift, 0, Request::none,
            next_family},
    Command{"undo", "edit", "ctrl+z", "one step back", GLFW_KEY_Z, kControl, 0, Request::undo},
    Command{"redo", "edit", "ctrl+y", "one step forth again; or ctrl+shift+z", GLFW_KEY_Y, kControl, 0,
            Request::redo},
    Command{"redo again", "edit", "ctrl+shift+z", "the same as ctrl+y", GLFW_KEY_Z, kControl | kShift, 0,
            Request::redo},
    Command{"revert", "edit", "ctrl+r", "all as it was when the file was opened", GLFW_KEY_R, kControl, 0,
            Request::revert},
    Command{"fit from here", "edit", "ctrl+f", "the solver goes on from these values, to the samples",
            GLFW_KEY_F, kControl, 0, Request::fit_here},
    Command{"stop fitting", "edit", "ctrl+x", "the best so far stays", GLFW_KEY_X, kControl, 0,
            Request::stop_fit},

    Command{"turn light", "light", "ctrl+drag", "the directional lights, or the environment"},
    Command{"light follows", "light", "shift+l", "the light turns with the camera", GLFW_KEY_L, kShift, 0,
            Request::none,
            [](Session& s, const Whereabouts&) { s.state().light_follows = !s.state().light_follows; }},
    Command{"light from the left", "light", "1", "one hard light from the upper left", GLFW_KEY_1, 0, 0,
            Request::none, light_from<-1, 1, 1>},
    Command{"light from the front", "light", "2", "one hard light beside the camera", GLFW_KEY_2, 0, 0,
            Request::none, light_from<0, 0, 1>},
    Command{"light from behind", "light", "3", "one hard light that grazes the rim", GLFW_KEY_3, 0, 0,
            Request::none, light_from<1, 1, -1>},
    Command{"studio", "light", "4", "soft boxes", GLFW_KEY_4, 0, 0, Request::none, stand_in<Formula::studio>},
    Command{"sky", "light", "5", "a clear sky", GLFW_KEY_5, 0, 0, Request::none, stand_in<Formula::sky>},
    Command{"uniform", "light", "6", "the same from everywhere", GLFW_KEY_6, 0, 0, Request::none,
            stand_in<Formula::uniform>},

    Command{"open", "file", "o", "a file of any kind, from a list; or ctrl+o", GLFW_KEY_O, 0, 0,
            Request::open},
    Command{"open a file", "file", "ctrl+o", "the same", GLFW_KEY_O, kControl, 0, Request::open},
    Command{"drop", "file", "drop", "opens the files"},
    Command{"save material", "file", "ctrl+shift+s", "the selected object's, by its name", GLFW_KEY_S,
            kControl | kShift, 0, Request::save_material, nullptr, kWrites},
    Command{"save state", "file", "ctrl+s", "all that the window shows", GLFW_KEY_S, kControl, 0,
            Request::save_state, nullptr, kWrites},
    Command{"load state", "file", "ctrl+l", "what was saved last", GLFW_KEY_L, kControl, 0,
            Request::load_state},
    Command{"picture", "file", "p", "writes the picture without the panels", GLFW_KEY_P, 0, 0,
            Request::screenshot, nullptr, kWrites},

    Command{"panels", "window", "h", "hide and show them", GLFW_KEY_H, 0, 0, Request::none,
            [](Session& s, const Whereabouts&) { s.state().show_ui = !s.state().show_ui; }},
    Command{"help", "window", "question", "this list; or F1", GLFW_KEY_SLASH, kShift, GLFW_KEY_F1,
            Request::help, nullptr, kWindow},
    Command{"close", "window", "Escape", "the topmost popup, nothing else", GLFW_KEY_ESCAPE, 0, 0,
            Request::dismiss, nullptr, kWindow},
    Command{"leave", "window", "q", "asks where something was changed", GLFW_KEY_Q, 0, 0, Request::leave,
            nullptr, kWindow},
};

}  // namespace

std::span<const Command> commands() {
  return kEdits;
}

const Command* command_of(int key, int mods) {
  const int wanted = mods & (kControl | kShift);
  for (const Command& c : kEdits) {
    if (c.key != 0 && key == c.key && wanted == c.mods) return &c;
    if (c.second != 0 && key == c.second) return &c;
  }
  // "+" is shift and "=" on most keyboards.
  return wanted == kShift && key == GLFW_KEY_EQUAL ? command_of(key, 0) : nullptr;
}

const Command& command(std::string_view name) {
  const auto found = std::ranges::find_if(kEdits, [&](const Command& c) { return c.name == name; });
  if (found == kEdits.end()) throw std::logic_error("no command " + std::string(name));
  return *found;
}

std::string command_help(std::size_t width) {
  std::string out, group, line;
  const auto end_line = [&] {
    if (!line.empty()) out += line + "\n";
    line.clear();
  };
  for (const Command& c : kEdits) {
    const std::string entry = std::string(c.keys) + ": " + std::string(c.name);
    if (group != c.group) {
      end_line();
      group = c.group;
      line = group + " - " + entry;
    } else if (line.size() + 2 + entry.size() > width) {
      line += ",";
      end_line();
      line = "  " + entry;
    } else {
      line += ", " + entry;
    }
  }
  end_line();
  return out;
}

std::string command_json() {
  io::Json list = io::Json::array();
  for (const Command& c : kEdits) {
    io::Json entry = {{"name", c.name},
                      {"group", c.group},
                      {"keys", c.keys},
                      {"does", c.does},
                      {"undo", c.no_undo.empty()}};
    if (!c.no_undo.empty()) entry["why_not"] = c.no_undo;
    list.push_back(std::move(entry));
  }
  return io::to_text(list);
}

}  // namespace brdf::render
