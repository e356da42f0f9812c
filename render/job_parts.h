// Functions shared by the parts of job.cpp.
#pragma once

#include "render/job.h"

namespace brdf::render {

inline bool compared(const Job& job) {
  return !job.compare.empty() || !job.measured.empty();
}
// Returns whether the job shows only samples.
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
// Throws InputError if the output is one of the files that the picture is made from.
void check_output(const Job& job, const ViewState& state);

}  // namespace brdf::render
