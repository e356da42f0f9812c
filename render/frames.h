// Writes the frames of a turntable as one animation or as numbered pictures.
#pragma once

#include <functional>

#include "render/job.h"

namespace brdf::render {

// Throws InputError if the job's output names neither an animation nor numbered pictures, or if the job
// requests the seven targets, which a turntable does not show.
void check_frames(const Job& job);
// Call before the work starts. Checks each file that will be written, as io::check_targets does.
void check_frame_targets(const Job& job, const std::vector<std::filesystem::path>& inputs);
// Writes all frames that `draw` returns. An animation is written completely or not at all; a picture is
// written as soon as it is drawn.
void write_frames(const Job& job, const std::function<BytePicture(int frame)>& draw);

}  // namespace brdf::render
