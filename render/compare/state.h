// The complete state of the viewer as a value, which is also the content of a saved state.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "io/samples/samples.h"
#include "render/compare/arrange.h"
#include "render/scene/prepared.h"

namespace brdf {
namespace render {

// The kind of picture that A is compared with.
enum class Other { material, samples, embree };

inline constexpr int kMostCurves = 1000;  // in the lobe plot

struct ViewState {
  Scene scene;               // A
  std::size_t selected = 0;  // index of an object
  Other other = Other::embree;
  // B on the selected object, or on all objects if `everywhere` is set.
  std::optional<Material> material;
  bool everywhere = false;
  std::string material_name;
  std::filesystem::path samples;  // B as a sample table
  Display display = Display::picture;
  float split = 0.5f;  // share of the width that shows A
  bool turntable = false;
  bool show_ui = true, show_plot = false;
  float plot_theta = 45;  // degrees
  int plot_solo = -1;     // curve shown alone; -1: all
  // Further materials in the lobe plot, with their names.
  std::vector<std::pair<std::string, Material>> kept;
  bool light_follows = false;  // the lights turn with the camera
  friend bool operator==(const ViewState&, const ViewState&) = default;
};

// state_text() returns the state as JSON text with absolute file names; load_state() reads such a file.
// Throws InputError.
std::string state_text(const ViewState& state);
ViewState load_state(const std::filesystem::path& file);

// Returns the polar angle of the table's light nearest to `theta`, in degrees; `theta` if the table is empty.
float measured_theta(const io::SampleTable& table, float theta);

// Opens any file according to its content: scene or saved state, material, sample table, model. The lobe plot
// takes the light of samples that is nearest to its own. Throws InputError and leaves the state unchanged if
// the file cannot be opened.
void open_file(ViewState& state, const std::filesystem::path& file);

// Returns the share of the width at which a split passes through the highlight of the selected object. The
// highlight is the point on a unit sphere at the object's place at which the normal is the half vector of
// the first light and the viewer. Returns 0.5 without a light; the result lies within 0.15 to 0.85.
float split_at_highlight(const Scene& scene, std::size_t object);

// Returns a sentence on the parts of the scene that are left out because of the comparison; empty if
// nothing is left out.
std::string left_out_note(const ViewState& state);

// Gives the term another form; parameters with the same name or role keep their values.
void switch_form(Term& term, const Reflectance& form);

// Camera movements. Angles in radians; `factor` scales the distance.
void orbit(Camera& camera, float right, float up);
void zoom(Camera& camera, float factor);
void pan(Camera& camera, glm::vec2 share_of_picture);
void fit(Camera& camera, const glm::vec4& bounds);

// Returns the sphere round an object or, without an object, round all objects that are not flat. Flat
// objects, such as a ground, count only if there are no others.
glm::vec4 bounds_of(const PreparedScene& scene, std::optional<std::size_t> object);
// Turns the lighting of the scene about the camera's axes: directional lights and, about the vertical axis
// only, the environment. Point lights stay in place. Angles in radians.
void turn_light(Scene& scene, float right, float up);
// Turns the lighting by the rotation of the camera since `before`.
void follow_camera(Scene& scene, const Camera& before);

}  // namespace render

template <>
inline constexpr std::array<std::string_view, 3> kNames<render::Other>{"material", "samples", "embree"};

}  // namespace brdf
