// The frames of a turntable: as one animation or as numbered pictures.
#pragma once

#include <functional>

#include "render/job.h"

namespace brdf::render {

// Throws InputError where the job's output names neither, or asks for what an animation does not hold.
void check_frames(const Job& job);
// For before the work: as io::check_targets for every file that will be written.
void check_frame_targets(const Job& job, const std::vector<std::filesystem::path>& inputs);
// Writes every frame that `draw` makes: an animation as a whole or not at all, a picture as soon as it is
// drawn.
void write_frames(const Job& job, const std::function<BytePicture(int frame)>& draw);

}  // namespace brdf::render
