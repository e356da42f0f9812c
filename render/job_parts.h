// What the parts of job.cpp share.
#pragma once

#include "render/job.h"

namespace brdf::render {

inline bool compared(const Job& job) {
  return !job.compare.empty() || !job.measured.empty();
}
// Nothing but samples.
inline bool samples_alone(const Job& job) {
  return job.materials.empty() && job.row.empty() && job.scene.empty() && job.state.empty() &&
         !job.measured.empty();
}
inline bool is_png(const std::filesystem::path& file) {
  return file.extension() == ".png";
}
inline bool needs_other(Display display) {
  return display != Display::picture && display != Display::gbuffer;
}
// Refuses an output that is one of the files that the picture is made of.
void check_output(const Job& job, const ViewState& state);

}  // namespace brdf::render
