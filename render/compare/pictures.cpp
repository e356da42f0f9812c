#include "render/compare/pictures.h"

#include <algorithm>
#include <tuple>

#include "io/colour/in_colour.h"
#include "io/formats/read.h"
#include "io/samples/noise.h"
#include "measured/on_sphere.h"
#include "render/compare/object_labels.h"
#include "render/compare/supersample.h"
#include "render/reference/reference.h"
#include "render/reference/surface_hit.h"

namespace brdf::render {
namespace {

bool needs_b(const ViewState& state) {
  return state.display == Display::split || state.display == Display::flip ||
         state.display == Display::difference;
}

std::string picture_of(const Scene& scene) {
  return scene.environment ? scene.environment->picture : "";
}

// Returns whether meshes, textures, the environment's picture and the picture's size are the same. Other
// changes need no new renderer.
bool same_resources(const Scene& a, const Scene& b) {
  if (a.objects.size() != b.objects.size() || a.folder != b.folder || a.camera.width != b.camera.width ||
      a.camera.height != b.camera.height || picture_of(a) != picture_of(b)) {
    return false;
  }
  for (std::size_t k = 0; k < a.objects.size(); ++k) {
    if (a.objects[k].mesh != b.objects[k].mesh || a.objects[k].textures != b.objects[k].textures)
      return false;
  }
  return true;
}

// Returns whether B is the same for both states if A is the same.
bool same_other(const ViewState& a, const ViewState& b) {
  const auto parts = [](const ViewState& s) {
    return std::tie(s.other, s.selected, s.everywhere, s.material, s.samples);
  };
  return parts(a) == parts(b);
}

}  // namespace

float Pictures::extent() const {
  float largest = 1e-6f;
  for (const Item& item : prepared_.layers[0]) largest = std::max(largest, item.extent);
  return largest;
}

Picture Pictures::read(Renderer& renderer) {
  const Camera& camera = renderer.scene().scene.camera;
  return picture_from(camera.width, camera.height, renderer.read_color());
}

int Pictures::samples_drawn() const {
  if (!a_ || !prepared_.environment) return 0;
  if (standing_) return standing_->plan().run * standing_->pictures();
  return fine_a_ ? fine_a_->samples : a_->samples();
}

void Pictures::prepare_to_sample(VkCommandBuffer commands) {
  a_->color().transition(commands, Use::sampled);
  if (b_) b_->color().transition(commands, Use::sampled);
  for (std::optional<Standing>* standing : {&standing_, &standing_b_})
    if (*standing) (*standing)->shown().transition(commands, Use::sampled);
  for (int k = 0; has_targets() && k < kTargetCount; ++k)
    a_->target(Target(k)).transition(commands, Use::sampled);
}

// Returns the plan by which A is refined, if A is refined. A alone is antialiased; comparisons use the
// pixels' centres. The targets are shown while they are drawn, and are therefore drawn at once.
std::optional<StandingPlan> Pictures::plan(const ViewState& state) const {
  if (effort_ != Effort::refining || state.display == Display::gbuffer) return std::nullopt;
  const int across = needs_b(state) ? 1 : finish_.supersample;
  if (across <= 1 && !prepared_.environment) return std::nullopt;
  const Camera& camera = prepared_.scene.camera;
  const auto pixels = std::uint64_t(camera.width) * std::uint64_t(camera.height);
  constexpr std::uint64_t kRounding = 1 << 20;  // memory that allocations take in addition to their images
  if (!standing_ && !device_->has_memory(standing_bytes(pixels) + kRounding)) return std::nullopt;
  return standing_plan(across, prepared_.environment ? wanted_ : 0);
}

bool Pictures::ready() const {
  return drawn_a_ && (!standing_ || standing_->ready()) &&
         (!shows_b_ || !standing_b_ || standing_b_->ready());
}

bool Pictures::unfinished() const {
  return drawn_a_ &&
         ((standing_ && !standing_->finished()) || (shows_b_ && standing_b_ && !standing_b_->finished()));
}

void Pictures::update(const ViewState& state, VkExtent2D size) {
  pace_.begin_frame();
  shows_b_ = needs_b(state);
  update_a(state, size);
  if (needs_b(state)) update_b(state);
}

void Pictures::update_a(const ViewState& state, VkExtent2D size) {
  Scene scene = state.scene;
  scene.camera.width = int(size.width);
  scene.camera.height = int(size.height);
  // Samples contain no ambient light and no environment, which are therefore left out of both pictures.
  if (needs_b(state) && state.other == Other::samples) {
    scene.ambient = glm::vec3(0);
    scene.environment.reset();
  }
  const bool same = drawn_a_ == scene;
  if (same) {
    const std::optional<StandingPlan> wanted = plan(state);
    if (wanted ? standing_ && standing_->plan() == *wanted : !standing_) return refine(state);
  }
  drawn_a_.reset();
  if (a_ && same_resources(scene, prepared_.scene)) {
    prepared_.scene = scene;
    update_items(prepared_);
    a_->update(prepared_);
  } else {
    PreparedScene fresh = prepare(scene);
    standing_.reset();
    standing_b_.reset();
    a_.reset();
    b_.reset();
    upload_ = {};
    prepared_ = std::move(fresh);
    a_.emplace(*device_, prepared_, options_);
  }
  images_changed_ = true;
  draw_a(state, plan(state));
  a_picture_.reset();
  fine_a_.reset();
  noise_ = -1;
  if (effort_ == Effort::whole) measure_noise();
  if (finish_.noise > 0 && finish_.supersample <= 1 && prepared_.environment && !needs_b(state))
    reduce_noise();
  drawn_a_ = std::move(scene);
  if (!same) {
    drawn_b_.reset();
    standing_b_.reset();
  }
  if (standing_) refine(state);
}

void Pictures::draw_a(const ViewState& state, const std::optional<StandingPlan>& plan) {
  if (plan) {
    if (standing_ && standing_->plan() == *plan) return standing_->reset();
    standing_.reset();
    standing_.emplace(*device_, *a_, *plan);
    return;
  }
  standing_.reset();
  if (effort_ != Effort::whole) {
    a_->draw_smooth(&times_);
  } else {
    // If only a picture with several places per pixel is needed, the places share the samples.
    const bool is_looked_at = finish_.supersample <= 1 || finish_.probed || needs_b(state);
    a_->draw_samples(is_looked_at ? wanted_ : samples_of_a_place(), &times_);
  }
  pass_times_ = times_.read();
}

// Draws the next parts of the pictures that are refined; of two pictures, of the one that lags behind.
void Pictures::refine(const ViewState& state) {
  bool completed = false;
  const auto done = [](const Standing& one) { return one.ready() ? 1 + one.pictures() : 0; };
  const bool second = shows_b_ && standing_b_ && !standing_b_->finished() &&
                      (!standing_ || standing_->finished() || done(*standing_b_) < done(*standing_));
  if (second) {
    completed = standing_b_->go_on(other_, pace_, nullptr);
  } else if (standing_ && !standing_->finished()) {
    completed = standing_->go_on(prepared_, pace_, &times_);
    pass_times_ = times_.read();
  }
  if (!completed) return;
  images_changed_ = true;
  a_picture_.reset();
  fine_a_.reset();
  measure(state);
}

// Measures what needs reading back, at powers of two only.
void Pictures::measure(const ViewState& state) {
  const int count = standing_ ? standing_->pictures() : 0;
  if (count < 1 || (shows_b_ && standing_b_ && standing_b_->pictures() != count)) return;
  if ((count & (count - 1)) != 0 && unfinished()) return;
  if (prepared_.environment && count > 1) noise_ = standing_->noise();
  if (!needs_b(state) || !drawn_b_) return;
  if (standing_b_) b_picture_ = standing_b_->picture();
  difference_ = compare(a_picture(), b_picture_);
}

void Pictures::draw_other_material(const ViewState& state) {
  other_ = prepared_;
  PreparedScene& other = other_;
  for (std::size_t k = 0; state.material && k < other.scene.objects.size(); ++k)
    if (state.everywhere || k == state.selected) other.scene.objects[k].material = *state.material;
  update_items(other);
  if (b_) {
    b_->update(other);
  } else {
    b_.emplace(*device_, other, options_);
  }
  draw_fine_b_ = [this] { return fine(*b_).picture; };
  standing_b_.reset();
  if (standing_) {
    standing_b_.emplace(*device_, *b_, standing_->plan());
    return;
  }
  if (effort_ == Effort::whole)
    b_->draw_samples(wanted_);
  else
    b_->draw_smooth();
  b_picture_ = read(*b_);
}

void Pictures::update_b(const ViewState& state) {
  if (drawn_b_ && same_other(*drawn_b_, state)) return;
  drawn_b_.reset();
  fine_b_.reset();
  if (state.other == Other::material) {
    draw_other_material(state);
  } else {
    standing_b_.reset();
    b_.reset();
    // The random numbers differ from A's. In a window, the number of samples is small because the user
    // waits for the picture.
    ReferenceOptions options{.samples = effort_ == Effort::whole ? wanted_ : std::min(wanted_, kRun),
                             .seed = options_.seed + 1};
    PreparedScene scene = prepared_;
    if (state.other == Other::samples && !state.samples.empty()) {
      if (samples_file_ != state.samples) {
        io::SampleTable table = io::read_samples(state.samples);
        samples_ = interpolate(table, &state.scene.objects[state.selected].material);
        const std::string note = require_colours(table.channels, table.source).note;
        scatter_ = io::relative_noise(io::in_colour(table)).value;
        samples_note_ = note.empty() ? "" : table.name() + ": " + note;
        table_ = std::move(table);
        samples_file_ = state.samples;
      }
      options.measured = &samples_;
    }
    b_picture_ = render_reference(scene, options);
    options.samples = std::max(samples_of_a_place(), kRun);
    draw_fine_b_ = [this, options, scene]() mutable {
      return at_places(scene, [&](const PreparedScene& moved) {
        options.seed += kMostSupersample * kMostSupersample;
        return render_reference(moved, options);
      });
    };
    const VkExtent2D extent{std::uint32_t(b_picture_.width), std::uint32_t(b_picture_.height)};
    upload_ =
        Image(*device_, kColorFormat, extent, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    upload(*device_, upload_, std::as_bytes(std::span(b_picture_.pixels)));
  }
  difference_.reset();  // of pictures that are refined: see measure()
  if (!standing_) difference_ = compare(a_picture(), b_picture_);
  images_changed_ = true;
  drawn_b_ = state;
}

std::string Pictures::other_name(const ViewState& state) const {
  if (state.other == Other::embree) return "Embree";
  if (state.other == Other::samples) return measured::smoothed_words(scatter_);
  return state.material ? state.material_name : "the same";
}

std::optional<Pictures::ProbedValue> Pictures::value_of_b(const ViewState& state, const PixelProbe& a, int x,
                                                          int y) const {
  if (!needs_b(state) || !drawn_b_ || !a.hit) return std::nullopt;
  if (state.other == Other::embree) return ProbedValue{a.value};
  if (state.other == Other::samples) {
    if (!samples_ || !(a.wi.z > 0)) return std::nullopt;
    const Item& item = prepared_.layers[0][a.object];
    const MeasuredValue value = samples_(in_surface(a.wi, item), in_surface(a.wo, item));
    return ProbedValue{value.f_cos / a.wi.z, value.known};
  }
  const PixelProbe b = pixel_probe(other_, x, y);
  return b.hit ? std::optional(ProbedValue{b.value}) : std::nullopt;
}

const Picture& Pictures::a_picture() {
  if (!a_picture_) a_picture_ = standing_ && standing_->ready() ? standing_->picture() : read(*a_);
  return *a_picture_;
}

Comparison Pictures::comparison(const ViewState& state, bool labels) {
  return {
      .a = &a_picture(),
      .b = &b_picture_,
      .fine_a = &fine_a(),
      .fine_b = &fine_b(),
      .rounding = finish_.rounding,
      .name_a = "A: " + state.scene.objects[state.selected].material_name,
      // Samples shown alone are not compared, and their name has no prefix.
      .name_b = (state.scene.objects[state.selected].material_name.empty() ? "" : "B: ") + other_name(state),
      .difference = difference_.value_or(Difference{}),
      .tone_map = state.scene.tone_map,
      .exposure = state.scene.exposure,
      .split = state.split,
      .measured = state.other == Other::samples,
      .labels = labels};
}

BytePicture Pictures::capture(const ViewState& state, bool labels) {
  if (state.display == Display::gbuffer && has_targets()) {
    if (effort_ != Effort::whole) a_->draw_samples(wanted_);
    return target_sheet(*a_, labels);
  }
  if (needs_b(state)) return arranged(comparison(state, labels), state.display);
  BytePicture out = displayed(fine_a(), state.scene.tone_map, state.scene.exposure, finish_.rounding);
  if (labels) draw_object_labels(out, prepared_);
  return out;
}

BytePicture Pictures::row(const ViewState& state, bool labels) {
  return beside(comparison(state, labels));
}

}  // namespace brdf::render
