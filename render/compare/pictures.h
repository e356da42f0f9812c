// The pictures A and B of a view state, drawn again only if the state has changed. The window and `brdf
// render` both show these pictures.
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

// Settings for the conversion of a picture to bytes.
struct Finish {
  int supersample = 4;  // samples across a pixel
  // The picture with one sample per pixel is needed, too.
  bool probed = false;
  Rounding rounding = Rounding::dithered;
  // A picture of A alone in an environment: draws further samples until noise() is at most this, or until a
  // pixel has `most_samples`. 0: the samples of Pictures alone.
  double noise = 0;
  int most_samples = 0;
  // Called after each sample place of a picture, with the finished places and their total number.
  std::function<void(int done, int total)> progress = {};
};

// whole: an update draws all samples. refining: an update draws as much as fits into a frame of a window; the
// following updates of the same state go on. A, if it is shown alone, is then also drawn through the sample
// places of `Finish`. quick: an update draws the smooth picture alone (Renderer::draw_smooth).
enum class Effort { whole, refining, quick };

class Pictures {
 public:
  // `samples`: samples of an environment's light per pixel. `clock`: for Effort::refining.
  Pictures(Device& device, const RendererOptions& options, int samples, const Finish& finish = {},
           Effort effort = Effort::whole, Pace::Clock clock = Pace::steady_clock)
      : device_(&device),
        options_(options),
        wanted_(samples),
        effort_(effort),
        finish_(finish),
        pace_(std::move(clock)),
        times_(device) {
    options_.has_places = effort == Effort::whole && finish.supersample > 1;
  }

  // Draws the pictures that the state needs at this size, in pixels. Throws InputError if a file of the
  // state cannot be used.
  void update(const ViewState& state, VkExtent2D size);
  // Call after each update. Returns true once if images other than the previous ones have to be shown.
  bool images_changed() { return std::exchange(images_changed_, false); }

  // Returns whether the pictures show the state of the last update; otherwise further updates are needed
  // before there is anything to show.
  bool ready() const;
  // Returns whether another update of the same state would improve the picture.
  bool unfinished() const;
  // samples_drawn(): samples of an environment's light in A, 0 without an environment. noise(): the noise of
  // the shown picture, as the root mean square of the surface's standard errors over the surface's mean. The
  // noise is measured now and then while A is refined, and when fine_a() is drawn without refining. A
  // negative value means that no measurement exists yet.
  int samples_drawn() const;
  double noise() const { return noise_; }

  // Records the barriers after which all shown images can be sampled.
  void prepare_to_sample(VkCommandBuffer commands);
  Renderer& a() { return *a_; }
  const Image& a_image() const { return standing_ ? standing_->shown() : a_->color(); }
  const Image& b_image() const {
    return standing_b_ ? standing_b_->shown() : b_ ? b_->color() : upload_ ? upload_ : a_image();
  }
  bool has_targets() const { return uses_gbuffer(prepared_.scene, options_); }
  const PreparedScene& prepared() const { return prepared_; }
  int bits() const { return options_.gbuffer_bits; }
  float extent() const;  // of the largest object
  // Times of A's passes, in milliseconds, in the last frame that drew them.
  const std::vector<std::pair<std::string, double>>& times() const { return pass_times_; }
  const std::optional<Difference>& difference() const { return difference_; }
  std::string other_name(const ViewState& state) const;
  // Returns f_r of B for the directions of a probe of A (reference/reference.h) at this pixel, in 1/sr.
  // Returns std::nullopt if B is not shown or shows no surface there. `known` is false if nothing was
  // measured near these directions.
  struct ProbedValue {
    glm::vec3 value{0};
    bool known = true;
  };
  std::optional<ProbedValue> value_of_b(const ViewState& state, const PixelProbe& a, int x, int y) const;
  // Linear pictures with one sample per pixel. B is available if the display of the state shows B.
  const Picture& a_picture();
  const Picture& b_picture() const { return b_picture_; }
  // Returns the same pictures with the samples of `finish`, for viewing.
  const Picture& fine_a();
  const Picture& fine_b();
  // The samples that were last shown, or null.
  const io::SampleTable* samples() const { return table_ ? &*table_ : nullptr; }
  // The noise that the picture of the samples does not show; std::nullopt if it is not known.
  const std::optional<double>& scatter() const { return scatter_; }
  // Explains how the channels of the samples were mapped to colours; empty if their names determine the
  // colours.
  const std::string& samples_note() const { return samples_note_; }
  // Returns the picture of the window without the user interface, with names and numbers if `labels` is
  // set.
  BytePicture capture(const ViewState& state, bool labels = false);
  // Returns A, B and their difference side by side.
  BytePicture row(const ViewState& state, bool labels);

 private:
  void update_a(const ViewState& state, VkExtent2D size);
  void update_b(const ViewState& state);
  std::optional<StandingPlan> plan(const ViewState& state) const;
  void draw_a(const ViewState& state, const std::optional<StandingPlan>& plan);
  void refine(const ViewState& state);
  void measure(const ViewState& state);
  void draw_other_material(const ViewState& state);
  Picture read(Renderer& renderer);
  int samples_of_a_place() const;
  // A picture with the samples of `Finish`. samples: of an environment's light per pixel; noise: as of
  // noise().
  struct Fine {
    Picture picture;
    int samples = 0;
    double noise = -1;
  };
  // Draws through all places of a pixel, with an environment again and again until the noise is at most
  // `wanted_noise`, if that is above 0, or until a pixel has the most samples of `Finish`.
  Fine fine(Renderer& renderer, double wanted_noise = 0);
  void reduce_noise();
  void measure_noise();
  void show_again(Renderer& renderer, const PreparedScene& scene);
  // Calls draw() at each place, and reports the progress.
  Picture at_places(const PreparedScene& scene, const std::function<Picture(const PreparedScene&)>& draw);
  Comparison comparison(const ViewState& state, bool labels);

  Device* device_;
  RendererOptions options_;
  int wanted_;  // samples per pixel
  Effort effort_;
  double noise_ = -1;
  Finish finish_;
  Pace pace_;
  Timestamps times_;
  PreparedScene prepared_, other_;  // of A, and of B if B is a material
  std::optional<Renderer> a_, b_;
  bool shows_b_ = false;                           // in the state of the last update
  std::optional<Standing> standing_, standing_b_;  // A and B if they are refined
  Image upload_;                                   // B, if B is computed on the CPU
  std::optional<Picture> a_picture_;
  Picture b_picture_;
  std::optional<Fine> fine_a_;
  std::optional<Picture> fine_b_;
  std::function<Picture()> draw_fine_b_;
  std::filesystem::path samples_file_;
  Measured samples_;
  std::optional<io::SampleTable> table_;
  std::string samples_note_;
  std::optional<double> scatter_;  // of the samples
  std::optional<Scene> drawn_a_;   // the scene and the state that the pictures show
  std::optional<ViewState> drawn_b_;
  bool images_changed_ = true;
  std::vector<std::pair<std::string, double>> pass_times_;
  std::optional<Difference> difference_;
};

}  // namespace brdf::render
