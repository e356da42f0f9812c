#include "render/viewer/history.h"

#include <tuple>

namespace brdf::render {
namespace {

template <class Part>
bool differ(const ViewState& a, const ViewState& b, Part part) {
  return part(a) != part(b);
}

std::vector<Material> materials_of(const ViewState& state) {
  std::vector<Material> out;
  for (const Object& object : state.scene.objects) out.push_back(object.material);
  return out;
}

auto lights_of(const ViewState& s) {
  return std::tie(s.scene.lights, s.scene.environment, s.scene.ambient, s.scene.shadow, s.light_follows);
}

auto comparison_of(const ViewState& s) {
  return std::tie(s.other, s.material, s.everywhere, s.samples, s.display, s.split, s.kept);
}

std::vector<Object> shapes_of(const ViewState& state) {
  std::vector<Object> out = state.scene.objects;
  for (Object& object : out) object.material = {};
  return out;
}

}  // namespace

bool same_edit(const ViewState& a, const ViewState& b) {
  if (a == b) return true;
  ViewState other = b;
  other.scene.camera.width = a.scene.camera.width;
  other.scene.camera.height = a.scene.camera.height;
  if (a.turntable && b.turntable && a.selected == b.selected && a.selected < b.scene.objects.size())
    other.scene.objects[a.selected].rotation.y = a.scene.objects[a.selected].rotation.y;
  return a == other;
}

std::string what_differs(const ViewState& a, const ViewState& b) {
  std::vector<std::string> parts;
  if (materials_of(a) != materials_of(b)) parts.emplace_back("the material");
  if (shapes_of(a) != shapes_of(b)) parts.emplace_back("the objects");
  if (lights_of(a) != lights_of(b)) parts.emplace_back("the lights");
  if (comparison_of(a) != comparison_of(b)) parts.emplace_back("the comparison");
  if (differ(a, b,
             [](const ViewState& s) { return std::pair(s.scene.camera.position, s.scene.camera.target); }))
    parts.emplace_back("the camera");
  if (differ(a, b, [](const ViewState& s) { return s.selected; })) parts.emplace_back("the selection");
  if (parts.empty()) return "the view";
  std::string out;
  for (std::size_t k = 0; k < parts.size(); ++k)
    out += (k == 0 ? "" : k + 1 < parts.size() ? ", " : " and ") + parts[k];
  return out;
}

void History::record(const ViewState& state) {
  if (same_edit(state, now())) return;
  states_.resize(place_ + 1);
  states_.push_back(state);
  ++place_;
}

const ViewState* History::back() {
  return place_ == 0 ? nullptr : &states_[--place_];
}

const ViewState* History::forth() {
  return place_ + 1 == states_.size() ? nullptr : &states_[++place_];
}

}  // namespace brdf::render
