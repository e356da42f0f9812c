// The pictures A and B of a view state, drawn again only where the state has changed. The window and
// `brdf render` both show these.
#pragma once

#include <functional>
#include <optional>

#include "io/samples/samples.h"
#include "render/compare/arrange.h"
#include "render/compare/measured.h"
#include "render/compare/pace.h"
#include "render/compare/standing.h"
#include "render/compare/state.h"
#include "render/gpu/renderer.h"
#include "render/picture/picture.h"

namespace brdf::render {

// How what is shown becomes bytes.
struct Finish {
  int supersample = 4;  // samples across a pixel
  bool probed = false;  // the picture of one sample is asked for, too
  Rounding rounding = Rounding::dithered;
};

class Pictures {
 public:
  // `samples`: of an environment's light, per pixel. Drawn at once, or (`refining`) a few with each update of
  // a state that has not changed; A alone is then drawn through the finish's places of each pixel, too.
  Pictures(Device& device, const RendererOptions& options, int samples, const Finish& finish = {},
           bool refining = false)
      : device_(&device),
        options_(options),
        wanted_(samples),
        refining_(refining),
        finish_(finish),
        pace_(refining),
        times_(device) {}

  // Draws what the state needs at this size. Throws InputError where a file of the state cannot be used.
  void update(const ViewState& state, VkExtent2D size);
  // After each update: true once, when other images than before are to be shown.
  bool images_changed() { return std::exchange(images_changed_, false); }

  // Whether an update of the same state would make the picture better.
  bool unfinished() const;
  // Samples of an environment's light that A has, 0 without one, and what they leave open: the root mean
  // square of the surface's standard errors over its mean, told now and then while A is refined; negative:
  // not yet.
  int samples_drawn() const;
  double noise() const { return noise_; }

  // Records the barriers after which everything shown can be sampled.
  void prepare_to_sample(VkCommandBuffer commands);
  Renderer& a() { return *a_; }
  const Image& a_image() const { return stands() ? standing_->shown() : a_->color(); }
  const Image& b_image() const { return b_ ? b_->color() : upload_ ? upload_ : a_image(); }
  bool has_targets() const { return uses_gbuffer(prepared_.scene, options_); }
  const PreparedScene& prepared() const { return prepared_; }
  int bits() const { return options_.gbuffer_bits; }
  float extent() const;  // of the largest object
  // Of A's passes in the last frame that drew them.
  const std::vector<std::pair<std::string, double>>& times() const { return pass_times_; }
  const std::optional<Difference>& difference() const { return difference_; }
  std::string other_name(const ViewState& state) const;
  // The linear pictures, one sample a pixel; of B when the state's display shows it.
  const Picture& a_picture();
  const Picture& b_picture() const { return b_picture_; }
  // The same with the finish's samples: what is looked at.
  const Picture& fine_a();
  const Picture& fine_b();
  // The samples that were last shown, or null.
  const io::SampleTable* samples() const { return table_ ? &*table_ : nullptr; }
  // How the samples' channels became colours, where their names do not say it.
  const std::string& samples_note() const { return samples_note_; }
  // What the window shows without the user interface, with names and numbers on it where `labels`.
  BytePicture capture(const ViewState& state, bool labels = false);
  // A, B and their difference side by side.
  BytePicture row(const ViewState& state, bool labels);

 private:
  void update_a(const ViewState& state, VkExtent2D size);
  void update_b(const ViewState& state);
  bool antialiased(const ViewState& state) const;
  bool stands() const { return standing_ && standing_->pictures() > 0; }
  void read_times();
  void refine(const ViewState& state);
  void refine_standing();
  void measure_noise();
  void draw_other_material(const ViewState& state);
  Picture read(Renderer& renderer);
  int samples_of_a_place() const;
  Picture fine(Renderer& renderer);
  Comparison comparison(const ViewState& state, bool labels);

  Device* device_;
  RendererOptions options_;
  int wanted_;  // samples
  bool refining_;
  double noise_ = -1;
  Finish finish_;
  Pace pace_;
  Timestamps times_;
  PreparedScene prepared_;
  std::optional<Renderer> a_, b_;
  std::optional<Standing> standing_;  // A, where it is antialiased
  Image upload_;                      // B where it comes from the processor
  std::optional<Picture> a_picture_;
  Picture b_picture_;
  std::optional<Picture> fine_a_, fine_b_;
  std::function<Picture()> draw_fine_b_;
  std::filesystem::path samples_file_;
  Measured samples_;
  std::optional<io::SampleTable> table_;
  std::string samples_note_;
  std::optional<Scene> drawn_a_;  // what the pictures show
  std::optional<ViewState> drawn_b_;
  bool images_changed_ = true;
  std::vector<std::pair<std::string, double>> pass_times_;
  std::optional<Difference> difference_;
};

}  // namespace brdf::render
