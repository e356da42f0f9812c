// Everything the viewer shows, as a value: what a saved state holds.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "render/compare/arrange.h"
#include "render/scene/prepared.h"

namespace brdf {
namespace render {

// What A is compared with.
enum class Other { material, samples, embree };

inline constexpr int kMostCurves = 1000;  // of the lobe plot

struct ViewState {
  Scene scene;               // A
  std::size_t selected = 0;  // object
  Other other = Other::embree;
  std::optional<Material> material;  // B, on the selected object, or
  bool everywhere = false;           // on every object
  std::string material_name;
  std::filesystem::path samples;  // B, a sample table
  Display display = Display::picture;
  float split = 0.5f;  // share of the width that shows A
  bool turntable = false;
  bool show_ui = true, show_plot = false;
  float plot_theta = 45;                               // degrees
  int plot_solo = -1;                                  // curve shown alone; -1: all
  std::vector<std::pair<std::string, Material>> kept;  // further materials in the lobe plot, with their names
  bool light_follows = false;                          // the lights turn with the camera
  friend bool operator==(const ViewState&, const ViewState&) = default;
};

// As JSON text, file names absolute; and back. Throws InputError.
std::string state_text(const ViewState& state);
ViewState load_state(const std::filesystem::path& file);

// Opens any file by its content: scene or saved state, material, sample table, model. Throws InputError and
// leaves the state as it was.
void open_file(ViewState& state, const std::filesystem::path& file);

// The share of the width at which the split cuts through the selected object's highlight: where the half
// vector of the first light and the viewer is the normal of a unit sphere in its place. Half without a light;
// within 0.15 to 0.85.
float split_at_highlight(const Scene& scene, std::size_t object);

// What is not shown as it is because of what it is compared with, a sentence; empty: nothing.
std::string left_out_note(const ViewState& state);

// The term gets another form; parameters of the same name or role keep their values.
void switch_form(Term& term, const Reflectance& form);

// Camera movements. Angles in radians; `factor` scales the distance.
void orbit(Camera& camera, float right, float up);
void zoom(Camera& camera, float factor);
void pan(Camera& camera, glm::vec2 share_of_picture);
void fit(Camera& camera, const glm::vec4& bounds);

// The sphere round an object, or (`all`) round all that are not flat, as a ground is; round everything where
// nothing else is there.
glm::vec4 bounds_of(const PreparedScene& scene, std::optional<std::size_t> object);
// Turns what lights the scene about the camera's axes: directional lights and, about the vertical axis only,
// the environment. Point lights stay where they are. Radians.
void turn_light(Scene& scene, float right, float up);
// Turns it as the camera has turned since it was `before`.
void follow_camera(Scene& scene, const Camera& before);

}  // namespace render

template <>
inline constexpr std::array<std::string_view, 3> kNames<render::Other>{"material", "samples", "embree"};

}  // namespace brdf
