#include "render/frames.h"

#include "io/files/error.h"
#include "io/files/output.h"
#include "render/picture/animation.h"

namespace brdf::render {
namespace {

bool is_animation(const Job& job) {
  return job.output.extension() == ".webp";
}

// The place of the frame's number in a file's name, from the %, and the least number of digits.
struct NumberPlace {
  std::size_t begin = std::string::npos, end = 0;
  int digits = 0;
};

NumberPlace number_place(const std::string& name) {
  NumberPlace place;
  const std::size_t percent = name.find('%');
  if (percent == name.npos) return place;
  std::size_t k = percent + 1;
  if (k < name.size() && name[k] == '0') ++k;
  while (k < name.size() && name[k] >= '0' && name[k] <= '9' && place.digits < 10)
    place.digits = 10 * place.digits + (name[k++] - '0');
  if (k >= name.size() || name[k] != 'd' || place.digits > 9 || name.find('%', k) != name.npos) return place;
  place.begin = percent;
  place.end = k + 1;
  return place;
}

std::string frame_name(const Job& job, int frame) {
  std::string name = job.output.filename().string(), number = std::to_string(frame);
  const NumberPlace place = number_place(name);
  number.insert(0, std::size_t(std::max(0, place.digits - int(number.size()))), '0');
  return name.replace(place.begin, place.end - place.begin, number);
}

}  // namespace

void check_frames(const Job& job) {
  const std::string name = job.output.filename().string();
  if (job.show && *job.show == "gbuffer") throw InputError("--turntable cannot show the seven targets");
  if (job.gbuffer) throw InputError("--turntable cannot show the seven targets");
  if (is_animation(job)) return;
  if (job.output.extension() != ".png" || number_place(name).begin == name.npos)
    throw InputError("-o " + job.output.string() +
                     ": the name must end in .webp, or in .png with %d or %04d for the number of the frame");
}

void check_frame_targets(const Job& job, const std::vector<std::filesystem::path>& inputs) {
  if (job.output.empty()) return;
  if (is_animation(job)) return io::check_targets({{"-o", job.output}}, inputs);
  std::vector<std::string> names;
  for (int frame = 0; frame < *job.turntable; ++frame) names.push_back(frame_name(job, frame));
  const std::filesystem::path folder = job.output.parent_path();
  io::check_folder_target({"-o", folder.empty() ? "." : folder}, names, inputs);
}

void write_frames(const Job& job, const std::function<BytePicture(int frame)>& draw) {
  const std::filesystem::path folder = job.output.parent_path();
  if (!is_animation(job) && !folder.empty()) io::make_folder(folder);
  std::optional<Animation> animation;
  for (int frame = 0; frame < *job.turntable; ++frame) {
    const BytePicture picture = draw(frame);
    if (is_animation(job)) {
      if (!animation) animation.emplace(picture.width, picture.height, job.frames_per_second, job.quality);
      animation->add(picture);
    } else {
      write_png(folder / frame_name(job, frame), picture);
    }
    if (job.progress) job.progress(frame + 1, *job.turntable);
  }
  if (animation) io::write_file_atomically(job.output, animation->finish());
}

}  // namespace brdf::render
