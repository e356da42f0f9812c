#include "texel/stack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/formats/read.h"
#include "texel/photograph.h"

namespace brdf::texel {
namespace {

namespace fs = std::filesystem;

constexpr double kLargestFloat = std::numeric_limits<float>::max();
constexpr double kWhitest = 1e30;  // 1/sr

std::vector<fs::path> images_in(const fs::path& folder) {
  std::vector<fs::path> images;
  for (const auto& entry : fs::directory_iterator(folder))
    if (is_image(entry.path())) images.push_back(entry.path());
  std::ranges::sort(images);
  return images;
}

// Names the channels. OpenEXR stores R, G and B in alphabetical order and in capitals.
void name_channels(const std::vector<std::string>& found, Stack& stack) {
  const std::array<std::string, 3> colours{"R", "G", "B"};
  const bool coloured =
      std::ranges::all_of(colours, [&](const auto& c) { return std::ranges::count(found, c) > 0; });
  if (coloured) {
    stack.layers.assign(colours.begin(), colours.end());
    stack.channels = {"r", "g", "b"};
    return;
  }
  stack.layers = stack.channels = found;
}

double number_in(const io::SampleTable& table, std::string_view key, double otherwise) {
  const std::optional<std::string> text = table.find_metadata(key);
  if (!text || *text == "none") return otherwise;
  double number = 0;
  if (!io::parse_number(*text, number) || !std::isfinite(number))
    throw InputError(table.name() + ": " + std::string(key) + " " + io::shown(*text) +
                     ": must be a finite number");
  return number;
}

std::optional<Transfer> transfer_in(const io::SampleTable& table) {
  const std::optional<std::string> word = table.find_metadata("transfer");
  if (!word) return std::nullopt;
  std::optional<Transfer> transfer = transfer_named(*word);
  if (!transfer)
    throw InputError(table.name() + ": transfer " + io::shown(*word) +
                     ": must be linear, srgb or a power from 0.1 to 10");
  transfer->white = number_in(table, "white", 1);
  if (!(transfer->white > 0 && transfer->white <= kWhitest))
    throw InputError(table.name() + ": white: must be above 0, at most " + io::short_number(kWhitest));
  return transfer;
}

Rig rig_in(const io::SampleTable& table) {
  Rig rig;
  rig.light_distance = number_in(table, "light_distance", rig.light_distance);
  rig.viewer_distance = number_in(table, "viewer_distance", rig.viewer_distance);
  rig.texel_size = number_in(table, "texel_size", 0);
  if (!is_in_range(rig))
    throw InputError(table.name() + ": light_distance, viewer_distance and texel_size must be from " +
                     io::short_number(kShortest) + " to " + io::short_number(kLongest));
  if (rig.is_near() && rig.texel_size == 0)
    throw InputError(table.name() + ": a distance of lights or viewers needs texel_size, in the same unit");
  return rig;
}

void read_mask(Stack& stack) {
  const fs::path path = stack.folder / kMaskFile;
  if (!fs::exists(path)) return;
  Planes mask = read_planes(path);
  if (mask.width != stack.width || mask.height != stack.height || mask.values.size() != 1)
    throw InputError(path.string() + ": must have one channel and " + std::to_string(stack.width) + " x " +
                     std::to_string(stack.height) + " pixels, like the images");
  stack.mask = std::move(mask.values[0]);
}

}  // namespace

bool is_image(const fs::path& path) {
  return (path.extension() == ".exr" || path.extension() == ".png") && path.filename() != kMaskFile;
}

bool is_stack(const fs::path& path) {
  return fs::is_directory(path) && fs::exists(path / kLightsFile);
}

Stack open_stack(const fs::path& folder) {
  Stack stack;
  stack.folder = folder;
  if (!is_stack(folder))
    throw InputError(folder.string() + ": is not a stack, which is a folder with " + kLightsFile);
  stack.lights = io::read_directions(folder / kLightsFile);
  stack.images = images_in(folder);
  const std::size_t rows = stack.lights.rows();
  if (stack.images.size() != rows)
    throw InputError(stack.lights.name() + ": " + io::plural(rows, "row") + " for " +
                     io::plural(stack.images.size(), "image") + " in " + folder.string());
  for (std::size_t k = 0; k < rows; ++k)
    if (stack.lights.theta_i[k] >= 90 || stack.lights.theta_o[k] >= 90)
      throw InputError(stack.lights.where(k) +
                       ": light and viewer must be above the plane of the sample, with both polar angles "
                       "below 90 degrees");
  stack.transfer = transfer_in(stack.lights);
  const Photograph first(stack.images.at(0), stack.transfer);
  stack.width = first.width();
  stack.height = first.height();
  name_channels(first.channels(), stack);
  stack.dark_level = number_in(stack.lights, "dark_level", 0);
  stack.saturation = number_in(stack.lights, "saturation", stack.saturation);
  stack.rig = rig_in(stack.lights);
  read_mask(stack);
  return stack;
}

DirectionArrays<double> directions_at(const Stack& stack, std::size_t x, std::size_t y) {
  DirectionArrays<double> out = io::unit_directions(stack.lights);
  if (!stack.rig.is_near()) return out;
  const Vec3<double> place = place_of(stack.rig, stack.width, stack.height, double(x), double(y));
  for (std::size_t k = 0; k < out.size(); ++k)
    out.set(k, direction_from(place, out.view().wi(k), stack.rig.light_distance),
            direction_from(place, out.view().wo(k), stack.rig.viewer_distance));
  return out;
}

std::size_t bytes_per_texel(const Stack& stack) {
  return stack.images.size() * stack.channels.size() * sizeof(float);
}

namespace {

// Reads the given columns of the rows `row` to `row + height - 1`.
std::vector<float> read_columns(const Stack& stack, std::span<const std::size_t> columns, std::size_t row,
                                std::size_t height) {
  const std::size_t images = stack.images.size(), channels = stack.channels.size();
  std::vector<float> out(columns.size() * height * channels * images);
  std::vector<std::vector<float>> band;
  const float none = std::numeric_limits<float>::quiet_NaN();
  const DirectionArrays<double> far = io::unit_directions(stack.lights);
  // Rounded to float, as the pixels of the images are.
  const float saturation = float(std::clamp(stack.saturation, -kLargestFloat, kLargestFloat));
  const auto irradiance = [&](std::size_t column, std::size_t line, std::size_t image) {
    if (!stack.rig.is_near()) return 1.0;
    const Vec3<double> place = place_of(stack.rig, stack.width, stack.height, double(column), double(line));
    return irradiance_at(place, far.view().wi(image), stack.rig.light_distance);
  };
  for (std::size_t k = 0; k < images; ++k) {
    Photograph image(stack.images[k], stack.transfer);
    const auto has = [&](const std::string& layer) {
      return std::ranges::count(image.channels(), layer) > 0;
    };
    if (image.width() != stack.width || image.height() != stack.height ||
        !std::ranges::all_of(stack.layers, has))
      throw InputError(stack.images[k].string() + ": size or channels differ from " +
                       stack.images[0].filename().string());
    image.read_rows(stack.layers, row, height, band);
    for (std::size_t c = 0; c < channels; ++c)
      for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < columns.size(); ++x) {
          const float pixel = band[c][y * stack.width + columns[x]];
          const double value = (double(pixel) - stack.dark_level) / irradiance(columns[x], row + y, k);
          const bool known = std::isfinite(pixel) && pixel < saturation && std::abs(value) <= kLargestFloat;
          out[((y * columns.size() + x) * channels + c) * images + k] = known ? float(value) : none;
        }
  }
  return out;
}

}  // namespace

std::vector<float> read_region(const Stack& stack, const Region& region) {
  std::vector<std::size_t> columns(region.width);
  std::iota(columns.begin(), columns.end(), region.x);
  return read_columns(stack, columns, region.y, region.height);
}

std::vector<float> read_texels(const Stack& stack, std::span<const std::size_t> columns, std::size_t row) {
  return read_columns(stack, columns, row, 1);
}

}  // namespace brdf::texel
