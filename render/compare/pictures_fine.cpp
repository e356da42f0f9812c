// The pictures A and B with the samples of `Finish`: for screenshots, `brdf render` and comparisons.
#include <algorithm>
#include <cmath>
#include <utility>

#include "brdf/scalar.h"
#include "render/compare/pictures.h"
#include "render/compare/supersample.h"

namespace brdf::render {
namespace {

// Returns the number of samples after which the noise is probably reached. The noise of these points falls
// faster than with the root of their number (between the powers -0.68 and -0.72 in the studio).
int samples_for(double noise, double wanted_noise, int samples) {
  return int(std::min(samples * std::pow(noise / wanted_noise, 1.5), 1e8));
}

// Returns the picture with alpha 1 where at least half of the places show a surface, otherwise 0.
Picture by_majority(Picture picture) {
  for (glm::vec4& pixel : picture.pixels) pixel.a = pixel.a >= 0.5f;
  return picture;
}

}  // namespace

// Samples of an environment's light for each place in a pixel.
int Pictures::samples_of_a_place() const {
  const int places = finish_.supersample * finish_.supersample;
  return std::max((wanted_ + places - 1) / places, 1);
}

Picture Pictures::at_places(const PreparedScene& scene, const Draw& draw) {
  int done = 0;
  return supersampled(scene, finish_.supersample, [&](const PreparedScene& moved) {
    Picture picture = draw(moved);
    if (finish_.progress) finish_.progress(++done, finish_.supersample * finish_.supersample);
    return picture;
  });
}

// Restores the picture that the window shows.
void Pictures::show_again(Renderer& renderer, const PreparedScene& scene) {
  renderer.update(scene);
  if (standing_) standing_->interrupt();
  if (standing_b_) standing_b_->interrupt();
  if (effort_ == Effort::whole)
    renderer.draw_samples(samples_of_a_place());
  else
    renderer.draw_smooth();
}

Pictures::Fine Pictures::fine(Renderer& renderer, double wanted_noise) {
  PreparedScene scene = renderer.scene();
  scene.scene.camera.offset = {};
  const bool lit = scene.environment != nullptr;
  const std::vector<glm::vec2> places = sample_places(finish_.supersample);
  const int of_a_sweep = int(places.size());
  PlaceSums sums = renderer.place_sums();
  Fine fine;
  const auto measure = [&] {
    fine.picture = picture_from(scene.scene.camera.width, scene.scene.camera.height, sums.mean());
    if (lit) fine.noise = noise_of(sums.difference(), fine.picture);
  };
  const auto further = [&](int samples, int least) {
    const int left = std::max(finish_.most_samples - fine.samples, 0) / of_a_sweep * of_a_sweep;
    const int needed = samples_for(fine.noise, wanted_noise, samples) - fine.samples;
    return std::min(std::clamp(needed, least, std::max(of_a_sweep * kRun, least)), left);
  };
  int more = lit ? wanted_ : 1, done = 0;
  if (lit && wanted_noise > 0) {  // one run shows how many samples each place needs
    renderer.update(scene);
    renderer.draw_place(sums, {kRun, 0, 1, 1});
    measure();
    sums.reset();
    more = std::max(further(kRun, wanted_), of_a_sweep);
  }
  while (more > 0) {
    const StandingPlan plan = standing_plan(finish_.supersample, more);
    for (int k = 0; k < plan.pictures; ++k) {
      scene.scene.camera.offset = places[std::size_t(k % of_a_sweep)];
      renderer.update(scene);
      renderer.draw_place(sums, run_of(plan, k, fine.samples));
      ++done;
      if (finish_.progress) finish_.progress(done, done + plan.pictures - k - 1);
    }
    fine.samples += plan.pictures * plan.run;
    measure();
    more = wanted_noise > 0 && fine.noise > wanted_noise ? further(fine.samples, of_a_sweep) : 0;
  }
  fine.picture = by_majority(std::move(fine.picture));
  if (!lit) fine.samples = 0;
  scene.scene.camera.offset = {};
  show_again(renderer, scene);
  return fine;
}

void Pictures::measure_noise() {
  if (a_->samples() >= 2 * kRun) noise_ = noise_of(a_->read_standard_error(), a_picture());
}

// Draws further runs through the centres of the pixels until the noise of `finish` is reached.
void Pictures::reduce_noise() {
  while ((noise_ < 0 || noise_ > finish_.noise) && a_->samples() < finish_.most_samples) {
    const int wanted = std::min(std::max(2 * a_->samples(), 2 * kRun), finish_.most_samples);
    while (a_->samples() < wanted) a_->draw();
    a_picture_.reset();
    measure_noise();
  }
}

const Picture& Pictures::fine_a() {
  if (finish_.supersample <= 1) return a_picture();
  if (!fine_a_) {
    fine_a_ = fine(*a_, finish_.noise);
    if (effort_ == Effort::whole) noise_ = fine_a_->noise;  // otherwise it is the noise of the shown picture
  }
  return fine_a_->picture;
}

const Picture& Pictures::fine_b() {
  if (finish_.supersample <= 1) return b_picture();
  if (!fine_b_) fine_b_ = draw_fine_b_();
  return *fine_b_;
}

}  // namespace brdf::render
