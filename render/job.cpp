#include "render/job.h"

#include "io/files/error.h"
#include "render/compare/pictures.h"
#include "render/frames.h"
#include "render/job_parts.h"

namespace brdf::render {
namespace {

void write_exr_layers(const Job& job, const ViewState& state, Pictures& pictures, bool with_other) {
  const bool fine = job.supersample || !(with_other || job.gbuffer);
  const Picture& a = fine ? pictures.fine_a() : pictures.a_picture();
  std::vector<Layer> layers{{"", &a, true}};
  std::vector<Picture> targets;
  for (int k = 0; job.gbuffer && k < kTargetCount; ++k)
    targets.push_back(picture_from(a.width, a.height, pictures.a().read_target(Target(k))));
  for (std::size_t k = 0; k < targets.size(); ++k)
    layers.push_back({std::string(kNames<Target>[k]), &targets[k], true});
  Picture difference = a;
  if (with_other) {
    const Picture& b = fine ? pictures.fine_b() : pictures.b_picture();
    for (std::size_t k = 0; k < difference.pixels.size(); ++k) difference.pixels[k] -= b.pixels[k];
    constexpr std::array kLayerNames{"other", "measured", "reference"};  // in the order of Other
    layers.push_back({kLayerNames[std::size_t(state.other)], &b, true});
    layers.push_back({"difference", &difference});
  }
  write_exr(job.output, layers);
}

}  // namespace

JobReport run(const Job& given) {
  const Job job = with_samples_told(given);
  ViewState state = state_of(job);
  check_output(job, state);
  if (job.noise && !state.scene.environment)
    throw InputError("--noise: has no effect without an environment, whose light is sampled: leave it out");
  // A comparison for which no display is chosen shows A, B and the difference in a row.
  const bool row = compared(job) && state.display == Display::picture && !job.show;
  if (row) state.display = Display::difference;
  const bool with_other = needs_other(state.display);
  if (with_other && state.other != Other::material && state.scene.shading != Shading::brdf)
    throw InputError("a comparison with Embree or samples needs the shading brdf");
  const RendererOptions options{.gbuffer_bits = job.gbuffer_bits,
                                .path = job.forward ? Path::forward : Path::deferred};
  if ((job.gbuffer || state.display == Display::gbuffer) && !uses_gbuffer(state.scene, options))
    throw InputError("this scene is drawn without the seven targets, so --gbuffer has no effect");
  const Camera& camera = state.scene.camera;
  if (job.probe && (job.probe->x < 0 || job.probe->y < 0 || job.probe->x >= camera.width ||
                    job.probe->y >= camera.height)) {
    throw InputError("--probe " + std::to_string(job.probe->x) + "," + std::to_string(job.probe->y) +
                     ": is outside the picture of " + std::to_string(camera.width) + " x " +
                     std::to_string(camera.height));
  }
  Device device({.memory_limit = job.memory_limit, .validation = job.validation});
  Finish finish{.rounding = job.rounding};
  if (job.supersample) finish.supersample = *job.supersample;
  finish.probed = job.probe.has_value();
  if (job.noise) finish.noise = *job.noise;
  if (job.noise) finish.most_samples = job.most_samples;
  if (!job.turntable) finish.progress = job.progress;
  Pictures pictures(device, options, job.samples, finish);
  pictures.update(state, {std::uint32_t(camera.width), std::uint32_t(camera.height)});
  if (job.exposure_from_picture) state.scene.exposure = exposure_from(pictures.a_picture());
  JobReport report;
  report.exposure = state.scene.exposure;
  report.notes = colour_notes(state);
  if (std::string note = left_out_note(state); !note.empty()) report.notes.push_back(std::move(note));
  if (!pictures.samples_note().empty()) report.notes.push_back(pictures.samples_note());
  if (with_other) {
    report.other = pictures.other_name(state);
    if (!samples_alone(job)) report.difference = pictures.difference();
    if (pictures.samples()) report.scatter = pictures.scatter();
    if (pictures.samples() && report.difference && job.deviation) {
      const double median = job.deviation(state.scene.objects[state.selected].material, *pictures.samples());
      if (std::isfinite(median)) report.deviation = median;
    }
  }
  if (job.probe) {
    report.probe = pixel_probe(pictures.prepared(), job.probe->x, job.probe->y);
    report.probed_a = pictures.a_picture().at(job.probe->x, job.probe->y);
    if (with_other) report.probed_b = pictures.b_picture().at(job.probe->x, job.probe->y);
  }
  if (job.turntable && !job.output.empty()) {
    write_frames(job, [&](int frame) {
      ViewState turned = state;
      if (frame > 0) orbit(turned.scene.camera, float(2 * kPi * frame / *job.turntable), 0);
      pictures.update(turned, {std::uint32_t(camera.width), std::uint32_t(camera.height)});
      return row ? pictures.row(turned, job.labels) : pictures.capture(turned, job.labels);
    });
  } else if (is_png(job.output)) {
    write_png(job.output, row ? pictures.row(state, job.labels) : pictures.capture(state, job.labels));
  } else if (!job.output.empty()) {
    write_exr_layers(job, state, pictures, with_other);
  }
  report.device = device.name();
  report.width = camera.width;
  report.height = camera.height;
  report.passes = pictures.times();
  report.samples = pictures.samples_drawn();
  report.noise = pictures.noise();
  report.clipped = clipped_share(pictures.a_picture(), state.scene.tone_map, state.scene.exposure);
  report.not_finite = not_finite_share(pictures.a_picture());
  report.validation_messages = device.validation_messages();
  return report;
}

}  // namespace brdf::render
