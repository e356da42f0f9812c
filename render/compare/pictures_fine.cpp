// The pictures A and B with the samples of `Finish`: for screenshots, `brdf render` and comparisons.
#include <algorithm>
#include <cmath>
#include <utility>

#include "brdf/scalar.h"
#include "render/compare/picture_spread.h"
#include "render/compare/pictures.h"
#include "render/compare/supersample.h"

namespace brdf::render {
namespace {

constexpr int kRound = 64;  // samples of an environment's light per pixel

}  // namespace

// Samples of an environment's light for each place in a pixel.
int Pictures::samples_of_a_place() const {
  const int places = finish_.supersample * finish_.supersample;
  return std::max((wanted_ + places - 1) / places, 1);
}

Picture Pictures::at_places(const PreparedScene& scene, const Draw& draw, int before, int total) {
  int done = before;
  return supersampled(scene, finish_.supersample, [&](const PreparedScene& moved) {
    Picture picture = draw(moved);
    if (finish_.progress)
      finish_.progress(++done, std::max(total, before + finish_.supersample * finish_.supersample));
    return picture;
  });
}

Picture Pictures::fine(Renderer& renderer) {
  PreparedScene scene = renderer.scene();
  scene.scene.camera.offset = {};
  int first = 0;  // all places share one sequence of random directions
  Picture picture = at_places(scene, [&](const PreparedScene& moved) {
    renderer.update(moved);
    renderer.draw_samples(samples_of_a_place(), nullptr, std::exchange(first, first + samples_of_a_place()));
    return read(renderer);
  });
  show_again(renderer, scene);
  return picture;
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

Picture Pictures::fine_of_a() {
  const bool lit = prepared_.environment != nullptr;
  PreparedScene scene = a_->scene();
  scene.scene.camera.offset = {};
  const int places = finish_.supersample * finish_.supersample;
  // The fixed number of samples is divided into rounds, whose spread gives the noise.
  const int planned = lit ? std::max(wanted_ / kRound, 1) : 1;
  const int count = std::max((wanted_ + planned * places - 1) / (planned * places), 1);
  PictureSpread of_places(scene.scene.camera.width, scene.scene.camera.height), of_rounds = of_places;
  Picture sum;
  fine_samples_ = 0;
  double rounds = 0, expected = planned;
  // All places and rounds share one sequence of random directions.
  do {
    const auto draw = [&](const PreparedScene& moved) {
      a_->update(moved);
      a_->draw_samples(count, nullptr, std::exchange(fine_samples_, fine_samples_ + count));
      Picture picture = read(*a_);
      if (lit && rounds == 0) of_places.add(picture);
      return picture;
    };
    const Picture round = at_places(scene, draw, int(rounds) * places, int(std::ceil(expected)) * places);
    sum = rounds > 0 ? weighted(sum, rounds, round) : round;
    ++rounds;
    if (!lit) break;
    of_rounds.add(round);
    const double noise = rounds > 1 ? of_rounds.noise() : of_places.noise();
    if (effort_ == Effort::whole) noise_ = noise;  // otherwise it is the noise of the shown picture
    if (finish_.noise > 0)
      expected = std::clamp(rounds * square(noise / finish_.noise), rounds + 1,
                            std::max(double(finish_.most_samples) / (places * count), rounds + 1));
  } while (int(rounds) < planned || (finish_.noise > 0 && noise_ > finish_.noise &&
                                     fine_samples_ + places * count <= finish_.most_samples));
  if (!lit) fine_samples_ = 0;
  show_again(*a_, scene);
  return sum;
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
  if (!fine_a_) fine_a_ = fine_of_a();
  return *fine_a_;
}

const Picture& Pictures::fine_b() {
  if (finish_.supersample <= 1) return b_picture();
  if (!fine_b_) fine_b_ = draw_fine_b_();
  return *fine_b_;
}

}  // namespace brdf::render
