// The pictures A and B of a view state, drawn again only where the state has changed.
#pragma once

#include <optional>

#include "render/measured.h"
#include "render/picture.h"
#include "render/renderer.h"
#include "render/viewer/state.h"

namespace brdf::render {

class Pictures {
 public:
  explicit Pictures(Device& device, int gbuffer_bits)
      : device_(&device), bits_(gbuffer_bits), times_(device) {}

  // Draws what the state needs at this size. Throws InputError where a file of the state cannot be used.
  void update(const ViewState& state, VkExtent2D size);
  // After each update: true once, when other images than before are to be shown.
  bool images_changed() { return std::exchange(images_changed_, false); }

  // Records the barriers after which everything shown can be sampled.
  void prepare_to_sample(VkCommandBuffer commands);
  Renderer& a() { return *a_; }
  const Image& b_image() const { return b_ ? b_->color() : upload_ ? upload_ : a_->color(); }
  bool has_targets() const { return uses_gbuffer(prepared_.scene, {}); }
  const PreparedScene& prepared() const { return prepared_; }
  int bits() const { return bits_; }
  float extent() const;  // of the largest object
  // Of A's passes in the last frame that drew them.
  const std::vector<std::pair<std::string, double>>& times() const { return pass_times_; }
  const std::optional<Difference>& difference() const { return difference_; }
  std::string other_name(const ViewState& state) const;
  // What the window shows without the user interface.
  BytePicture capture(const ViewState& state);

 private:
  void update_a(const ViewState& state, VkExtent2D size);
  void update_b(const ViewState& state);
  void draw_other_material(const ViewState& state);
  Picture read(Renderer& renderer);

  Device* device_;
  int bits_;
  Timestamps times_;
  PreparedScene prepared_;
  std::optional<Renderer> a_, b_;
  Image upload_;       // B where it comes from the processor
  Picture b_picture_;  // its pixels
  std::filesystem::path samples_file_;
  Measured samples_;
  std::string drawn_a_, drawn_b_;  // the state that the pictures show
  bool images_changed_ = true;
  std::vector<std::pair<std::string, double>> pass_times_;
  std::optional<Difference> difference_;
};

}  // namespace brdf::render
