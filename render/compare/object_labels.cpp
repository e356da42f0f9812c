#include "render/compare/object_labels.h"

#include <algorithm>
#include <cmath>

#include "render/picture/canvas.h"
#include "render/scene/camera_view.h"

namespace brdf::render {
namespace {

struct Place {
  std::string text;
  float middle, bottom;  // pixels
  float room;            // across
};

// The extent of an object in the picture: its left and right ends, and its lower end.
struct Extent {
  float left = INFINITY, right = -INFINITY, bottom = -INFINITY;
  bool before_camera = true;
};

Extent extent_of(const BytePicture& picture, const PreparedScene& scene, const Item& item) {
  const glm::mat4 projection = view_projection(scene.scene.camera, 0.01f);
  Extent extent;
  for (const Vertex& vertex : scene.meshes[item.object]->vertices) {
    const glm::vec4 clip = projection * glm::vec4(item.origin + item.linear * vertex.position, 1);
    if (!(clip.w > 0.01f)) {
      extent.before_camera = false;
      break;
    }
    const float x = (clip.x / clip.w + 1) / 2 * float(picture.width);
    extent.left = std::min(extent.left, x);
    extent.right = std::max(extent.right, x);
    extent.bottom = std::max(extent.bottom, (1 - clip.y / clip.w) / 2 * float(picture.height));
  }
  return extent;
}

// Returns the place below the object and below the other objects at the same place, which are parts of the
// same thing. Returns std::nullopt if the object reaches behind the camera.
std::optional<Place> place_of(const BytePicture& picture, const PreparedScene& scene, const Item& labelled) {
  const Extent own = extent_of(picture, scene, labelled);
  if (!own.before_camera) return std::nullopt;
  Place place{scene.scene.objects[labelled.object].label, (own.left + own.right) / 2, own.bottom,
              float(picture.width)};
  for (const Item& item : scene.layers[0]) {
    if (item.origin != labelled.origin || item.linear != labelled.linear) continue;
    if (item.object == labelled.object) continue;
    const Extent other = extent_of(picture, scene, item);
    if (other.before_camera) place.bottom = std::max(place.bottom, other.bottom);
  }
  return place;
}

void draw(BytePicture& picture, const Place& place, int pixels) {
  const float pad = float(pixels) / 2, height = 1.7f * float(pixels);
  const std::string text = elided(place.text, pixels, place.room - 2 * pad);
  const float width = text_width(text, pixels) + 2 * pad;
  const float left = std::clamp(place.middle - width / 2, 0.0f, std::max(0.0f, float(picture.width) - width));
  const float top = std::clamp(place.bottom + pad, 0.0f, float(picture.height) - height);
  fill(picture, {int(left), int(top)}, {int(std::ceil(width)), int(height)}, {0, 0, 0}, 0.55f);
  draw_text(picture, {left + pad, top + 1.2f * float(pixels)}, text, pixels);
}

}  // namespace

void draw_object_labels(BytePicture& picture, const PreparedScene& scene) {
  std::vector<Place> places;
  for (const Item& item : scene.layers[0]) {
    if (scene.scene.objects[item.object].label.empty()) continue;
    if (const auto place = place_of(picture, scene, item)) places.push_back(*place);
  }
  const int pixels = std::max(smallest_label(picture), 10);
  for (Place& place : places) {
    for (const Place& other : places) {
      const bool beside = std::abs(other.bottom - place.bottom) < 2 * float(pixels) && &other != &place;
      if (beside) place.room = std::min(place.room, std::abs(other.middle - place.middle) - 2);
    }
  }
  for (const Place& place : places) draw(picture, place, pixels);
}

}  // namespace brdf::render
