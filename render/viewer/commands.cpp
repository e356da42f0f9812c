#include "render/viewer/commands.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <stdexcept>

#include "io/files/json.h"
#include "render/gpu/reflectance_glsl.h"
#include "render/light/formula.h"

namespace brdf::render {
namespace {

constexpr float kTurn = 0.1f;        // radians per arrow key
constexpr float kStops = 0.25f;      // of exposure
constexpr float kMostStops = 20.0f;  // as in a scene file
constexpr int kControl = GLFW_MOD_CONTROL, kShift = GLFW_MOD_SHIFT;
constexpr std::string_view kWrites = "writes a file", kWindow = "belongs to the window, not to the state";

void next_form(Session& session, const Whereabouts&) {
  const std::vector<Reflectance> forms = drawable_forms();
  const Term& term = session.state().scene.objects[session.state().selected].material.terms.front();
  const auto own = std::ranges::find(forms, term.form);
  session.switch_form(0, own == forms.end() || own + 1 == forms.end() ? forms.front() : own[1]);
}

void next_family(Session& session, const Whereabouts&) {
  const Term& term = session.state().scene.objects[session.state().selected].material.terms.front();
  const std::vector<std::vector<Reflectance>> groups = families(drawable_forms());
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
    Command{"orbit", "look", "drag", "rotate the camera; on the line of a split, move the line"},
    Command{"pan", "look", "right drag", "move the picture"},
    Command{"zoom", "look", "wheel", "zoom in or out"},
    Command{"turn left", "look", "left", "rotate the camera", GLFW_KEY_LEFT, 0, 0, Request::none,
            turn<-1, 0>},
    Command{"turn right", "look", "right", "rotate the camera", GLFW_KEY_RIGHT, 0, 0, Request::none,
            turn<1, 0>},
    Command{"turn up", "look", "up", "rotate the camera", GLFW_KEY_UP, 0, 0, Request::none, turn<0, 1>},
    Command{"turn down", "look", "down", "rotate the camera", GLFW_KEY_DOWN, 0, 0, Request::none,
            turn<0, -1>},
    Command{"home", "look", "r", "reset the camera", GLFW_KEY_R, 0, 0, Request::none,
            [](Session& s, const Whereabouts& w) { s.state().scene.camera = w.home; }},
    Command{"frame", "look", "f", "fit all objects except the ground into the picture", GLFW_KEY_F, 0, 0,
            Request::none, frame_all},
    Command{"frame selected", "look", "shift+f", "fit the selected object into the picture", GLFW_KEY_F,
            kShift, 0, Request::none, frame_selected},
    Command{"brighter", "look", "equal", "by a quarter of a stop", GLFW_KEY_EQUAL, 0, GLFW_KEY_KP_ADD,
            Request::none, expose<1>},
    Command{"darker", "look", "minus", "by a quarter of a stop", GLFW_KEY_MINUS, 0, GLFW_KEY_KP_SUBTRACT,
            Request::none, expose<-1>},
    Command{"tone map", "look", "c", "the next tone map", GLFW_KEY_C, 0, 0, Request::none,
            [](Session& s, const Whereabouts&) { advance(s.state().scene.tone_map); }},
    Command{"shading", "look", "m", "the next mode", GLFW_KEY_M, 0, 0, Request::none,
            [](Session& s, const Whereabouts&) { advance(s.state().scene.shading); }},
    Command{"targets", "look", "g", "the seven targets of the renderer", GLFW_KEY_G, 0, 0, Request::none,
            toggle<Display::gbuffer>},
    Command{"turntable", "look", "t", "rotate the object continuously", GLFW_KEY_T, 0, 0, Request::none,
            [](Session& s, const Whereabouts&) { s.state().turntable = !s.state().turntable; }},
    Command{"lobes", "look", "l", "show the lobe plot", GLFW_KEY_L, 0, 0, Request::none,
            [](Session& s, const Whereabouts&) { s.state().show_plot = !s.state().show_plot; }},
    Command{"select", "look", "click", "the object under the pointer"},
    Command{"probe", "look", "shift+click", "show angles and f_r under the pointer; a click ends the probe",
            0, 0, 0, Request::none, nullptr, kWindow},

    Command{"split", "compare", "s", "A left, B right", GLFW_KEY_S, 0, 0, Request::none,
            toggle<Display::split>},
    Command{"flip", "compare", "b", "show B instead of A", GLFW_KEY_B, 0, 0, Request::none,
            toggle<Display::flip>},
    Command{"difference", "compare", "d", "false colours, with a legend", GLFW_KEY_D, 0, 0, Request::none,
            toggle<Display::difference>},
    Command{"choose B", "compare", "k", "choose a material, samples or Embree", GLFW_KEY_K, 0, 0,
            Request::none, [](Session& s, const Whereabouts&) { advance(s.state().other); }},
    Command{"keep as B", "compare", "shift+b", "use this material as B", GLFW_KEY_B, kShift, 0, Request::none,
            keep_as_b},
    Command{"keep in plot", "compare", "shift+k", "keep the lobe of this material in the plot", GLFW_KEY_K,
            kShift, 0, Request::none, keep_in_plot},

    Command{"next form", "edit", "n", "of all forms; each form keeps its values", GLFW_KEY_N, 0, 0,
            Request::none, next_form},
    Command{"next family", "edit", "shift+n", "the first form of the next family", GLFW_KEY_N, kShift, 0,
            Request::none, next_family},
    Command{"undo", "edit", "ctrl+z", "undo one step", GLFW_KEY_Z, kControl, 0, Request::undo},
    Command{"redo", "edit", "ctrl+y", "redo one step; or ctrl+shift+z", GLFW_KEY_Y, kControl, 0,
            Request::redo},
    Command{"redo again", "edit", "ctrl+shift+z", "the same as ctrl+y", GLFW_KEY_Z, kControl | kShift, 0,
            Request::redo},
    Command{"revert", "edit", "ctrl+r", "restore the state of the opened file", GLFW_KEY_R, kControl, 0,
            Request::revert},
    Command{"fit from here", "edit", "ctrl+f", "fit the samples, starting from these values", GLFW_KEY_F,
            kControl, 0, Request::fit_here},
    Command{"stop fitting", "edit", "ctrl+x", "keep the best values so far", GLFW_KEY_X, kControl, 0,
            Request::stop_fit},

    Command{"turn light", "light", "ctrl+drag", "the directional lights, or the environment"},
    Command{"light follows", "light", "shift+l", "rotate the light with the camera", GLFW_KEY_L, kShift, 0,
            Request::none,
            [](Session& s, const Whereabouts&) { s.state().light_follows = !s.state().light_follows; }},
    Command{"light from the left", "light", "1", "one hard light from the upper left", GLFW_KEY_1, 0, 0,
            Request::none, light_from<-1, 1, 1>},
    Command{"light from the front", "light", "2", "one hard light near the camera", GLFW_KEY_2, 0, 0,
            Request::none, light_from<0, 0, 1>},
    Command{"light from behind", "light", "3", "one hard light from behind, at grazing angles", GLFW_KEY_3, 0,
            0, Request::none, light_from<1, 1, -1>},
    Command{"studio", "light", "4", "soft boxes", GLFW_KEY_4, 0, 0, Request::none, stand_in<Formula::studio>},
    Command{"sky", "light", "5", "a clear sky", GLFW_KEY_5, 0, 0, Request::none, stand_in<Formula::sky>},
    Command{"uniform", "light", "6", "the same radiance from all directions", GLFW_KEY_6, 0, 0, Request::none,
            stand_in<Formula::uniform>},

    Command{"open", "file", "o", "open a file of any kind from a list; or ctrl+o", GLFW_KEY_O, 0, 0,
            Request::open},
    Command{"open a file", "file", "ctrl+o", "the same", GLFW_KEY_O, kControl, 0, Request::open},
    Command{"drop", "file", "drop", "open the files"},
    Command{"save material", "file", "ctrl+shift+s", "save the material of the selected object by name",
            GLFW_KEY_S, kControl | kShift, 0, Request::save_material, nullptr, kWrites},
    Command{"save state", "file", "ctrl+s", "save the whole state of the window", GLFW_KEY_S, kControl, 0,
            Request::save_state, nullptr, kWrites},
    Command{"load state", "file", "ctrl+l", "load the state saved last", GLFW_KEY_L, kControl, 0,
            Request::load_state},
    Command{"picture", "file", "p", "write the picture without the panels", GLFW_KEY_P, 0, 0,
            Request::screenshot, nullptr, kWrites},

    Command{"panels", "window", "h", "hide or show the panels", GLFW_KEY_H, 0, 0, Request::none,
            [](Session& s, const Whereabouts&) { s.state().show_ui = !s.state().show_ui; }},
    Command{"help", "window", "question", "show this list; or F1", GLFW_KEY_SLASH, kShift, GLFW_KEY_F1,
            Request::help, nullptr, kWindow},
    Command{"close", "window", "Escape", "close the topmost popup", GLFW_KEY_ESCAPE, 0, 0, Request::dismiss,
            nullptr, kWindow},
    Command{"leave", "window", "q", "leave the window; asks if there are unsaved changes", GLFW_KEY_Q, 0, 0,
            Request::leave, nullptr, kWindow},
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

std::string readable_keys(const Command& command) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kNamesOfKeys{
      {{"equal", "="},
       {"minus", "-"},
       {"question", "?"},
       {"Escape", "Esc"},
       {"left", "left arrow"},
       {"right", "right arrow"},
       {"up", "up arrow"},
       {"down", "down arrow"}}};
  for (const auto& [name, readable] : kNamesOfKeys)
    if (command.keys == name) return std::string(readable);
  return std::string(command.keys);
}

std::string command_help(std::size_t width) {
  constexpr std::size_t kKeys = 14, kEntry = 37;  // letters of the keys, and of the keys with a name
  const std::size_t columns = std::max<std::size_t>(1, width / kEntry);
  std::string out, line;
  std::string_view group;
  std::size_t entries = 0;  // in the line
  const auto end_line = [&] {
    if (entries > 0) out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    line.clear();
    entries = 0;
  };
  for (const Command& c : kEdits) {
    if (group != c.group || entries == columns) end_line();
    if (group != c.group) out += std::string(c.group) + ":\n";
    group = c.group;
    const std::string keys = readable_keys(c);
    line +=
        "  " + keys + std::string(kKeys > keys.size() ? kKeys - keys.size() : 1, ' ') + std::string(c.name);
    line.resize(std::max(line.size() + 1, ++entries * kEntry), ' ');
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
