// Refines the picture of a view that does not move. The first picture is smooth: without noise, through the
// pixels' centres. Further pictures are drawn through other places of the pixels and added up on the device,
// which smooths edges and reduces the noise of the light of an environment. Pictures are drawn in parts, as
// many in a frame as its time permits.
#pragma once

#include "render/compare/pace.h"
#include "render/gpu/renderer.h"
#include "render/gpu/running_mean.h"
#include "render/picture/picture.h"

namespace brdf::render {

// The pictures after the smooth one: their number, the places across a pixel, and the samples of an
// environment in each picture.
struct StandingPlan {
  int pictures = 16, across = 4, run = kRun;
  bool operator==(const StandingPlan&) const = default;
};
// Returns the plan with whole rounds through `across` x `across` places and at least `samples` samples of an
// environment, at most kRun in each picture. If kRun samples in each place suffice, a place is visited once.
StandingPlan standing_plan(int across, int samples);
// Returns the samples of the k-th picture of a plan, where `first` samples of the sequence are drawn. Between
// two samples of a picture, the other places have one each: the first halves of all pictures of a round are
// points that follow each other, and so are the second halves.
PlaceRun run_of(const StandingPlan& plan, int k, int first = 0);

class Standing {
 public:
  // Draws with this renderer, which must outlive this object.
  Standing(Device& device, Renderer& renderer, const StandingPlan& plan);
  const StandingPlan& plan() const { return plan_; }
  // Starts anew because the view has moved.
  void reset();
  // Starts the present picture anew because the renderer was used for other pictures.
  void interrupt() { part_ = 0; }

  // Draws the next parts of the scene that fit into the frame, up to the end of a picture. Returns true if a
  // picture was completed.
  bool go_on(const PreparedScene& scene, Pace& pace, Timestamps* times);
  // Returns whether shown() holds a picture of the present view.
  bool ready() const { return smooth_done_; }
  // Pictures after the smooth one.
  int pictures() const { return mean_.count(); }
  bool finished() const { return ready() && pictures() >= plan_.pictures; }

  // The smooth picture, which fades into the mean of the others as they are completed: the share of the mean
  // is the share of the pictures that exist. The noise therefore grows up to the noise of the mean of all
  // pictures, and the last picture is this mean alone.
  Image& shown() { return shown_; }
  const Image& shown() const { return shown_; }
  // Reads shown() back, with the surfaces that the last picture has.
  Picture picture();
  // Returns the root mean square of the standard errors of shown() on surfaces over the surface's mean.
  // Requires at least two pictures.
  double noise();

 private:
  void begin_picture(const PreparedScene& scene);
  void end_picture();
  double share() const { return double(mean_.count()) / plan_.pictures; }

  Device* device_;
  Renderer* renderer_;
  StandingPlan plan_;
  RunningMean mean_;
  Image smooth_, shown_;
  bool smooth_done_ = false;
  int part_ = 0;
  PartTimes smooth_times_, run_times_;
};

// Returns the bytes of device memory that refining a picture with this number of pixels takes.
std::uint64_t standing_bytes(std::uint64_t pixels);

// Returns the root mean square of the surface's standard errors (RGBA, as from
// Renderer::read_standard_error) over the mean of the surface.
double noise_of(const std::vector<float>& errors, const Picture& picture);

}  // namespace brdf::render
