// Pictures without a scene: lobes, texture maps and the tables of the lookup article.
#include <cmath>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/formats/read.h"
#include "io/samples/samples.h"
#include "render/compare/lobe_body.h"
#include "render/compare/lobe_plot.h"
#include "render/compare/lobe_points.h"
#include "render/gpu/lookup.h"
#include "render/job_parts.h"
#include "render/scene/texture.h"

namespace brdf::render {
namespace {

// Returns the table of measured points, and sets the angle of its light: the requested angle, or the
// measured angle nearest to the default.
std::optional<io::SampleTable> measured_lobe(const Job& job, ViewState& state) {
  if (state.other != Other::samples || state.samples.empty()) return std::nullopt;
  io::SampleTable table = io::read_samples(state.samples);
  const double wanted = double(state.plot_theta), nearest = nearest_light(table, wanted);
  if (!job.plot_theta && job.state.empty() && std::isfinite(nearest)) state.plot_theta = float(nearest);
  if (!(std::abs(nearest - double(state.plot_theta)) <= kNearLight))
    throw InputError(table.name() + ": has no row with incidence within " + io::short_number(kNearLight) +
                     " degree of --theta " + io::short_number(wanted) + "; the nearest is " +
                     io::short_number(nearest));
  return table;
}

BytePicture bytes_of(const Texture& texture) {
  BytePicture picture(texture.width, texture.height);
  for (std::size_t k = 0; k < picture.pixels.size(); ++k)
    picture.pixels[k] = {texture.texels[k][0], texture.texels[k][1], texture.texels[k][2]};
  return picture;
}

// Writes pictures into a folder and reports the number of written pictures.
class PictureFolder {
 public:
  PictureFolder(std::filesystem::path folder, int total, const std::function<void(int, int)>& progress)
      : folder_(std::move(folder)), total_(total), progress_(progress) {
    report();
  }
  void write(const std::string& name, const BytePicture& picture) {
    write_png(folder_ / (name + ".png"), picture);
    ++written_;
    report();
  }

 private:
  void report() const {
    if (progress_) progress_(written_, total_);
  }
  std::filesystem::path folder_;
  int written_ = 0, total_;
  const std::function<void(int, int)>& progress_;
};

}  // namespace

void write_lobes(const Job& given, LobeView view) {
  const Job job = with_samples_told(given);
  if (samples_alone(job)) throw InputError("a lobe plot needs a MATERIAL in addition to the samples");
  ViewState state = state_of(job);
  if (!is_png(job.output))
    throw InputError("-o " + job.output.string() + ": the name of a plot must end in .png");
  check_output(job, state);
  const std::optional<io::SampleTable> table = measured_lobe(job, state);
  if (view == LobeView::body) {
    const Object& object = state.scene.objects.at(state.selected);
    write_png(job.output, lobe_body_picture(object.material, object.material_name, double(state.plot_theta),
                                            table ? &*table : nullptr, job.width.value_or(640)));
    return;
  }
  const std::vector<LobeCurve> curves = lobe_curves(state);
  const std::vector<LobeDot> dots =
      table ? lobe_dots(*table, double(state.plot_theta)) : std::vector<LobeDot>{};
  int solo = state.plot_solo;
  if (job.solo) {
    std::string known;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      if (curves[k].name == *job.solo) solo = int(k);
      known += (k ? ", " : "") + curves[k].name;
    }
    if (solo < 0) throw InputError("--solo " + *job.solo + ": must be one of " + known);
  }
  write_png(job.output, lobe_picture(curves, double(state.plot_theta), solo, job.width.value_or(640), dots));
}

void write_maps(const std::string& kind, int size, std::uint64_t seed, const std::filesystem::path& folder,
                const std::function<void(int, int)>& progress) {
  io::make_folder(folder);
  const bool tiles = kind == "tiles";
  PictureFolder pictures(folder, tiles ? 1 : int(kNames<TextureSlot>.size()), progress);
  if (tiles) return pictures.write("tiles", bytes_of(floor_tile(size, seed)));
  const auto maps = rusty_metal(size, seed);
  for (std::size_t k = 0; k < maps.size(); ++k)
    pictures.write(std::string(kNames<TextureSlot>[k]), bytes_of(maps[k]));
}

void write_lookup_pictures(const std::filesystem::path& folder,
                           const std::function<void(int, int)>& progress) {
  io::make_folder(folder);
  PictureFolder pictures(folder, int(kNames<LookupFactor>.size()) + 1, progress);
  for (std::size_t k = 0; k < kNames<LookupFactor>.size(); ++k)
    pictures.write(std::string(name_of(LookupFactor(k))), lookup_picture(LookupFactor(k), false));
  pictures.write("product_as_coded", lookup_picture(LookupFactor::product, true));
}

}  // namespace brdf::render
