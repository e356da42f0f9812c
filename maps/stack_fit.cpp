#include "maps/stack_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "fit/assess/metric_choice.h"
#include "fit/assess/reported.h"
#include "fit/assess/student.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/samples/noise.h"

namespace brdf::maps {
namespace {

constexpr std::size_t kMetricTexels = 9;  // number of texels that choose_metric() evaluates
constexpr const char* kNormalNames[] = {"normal.x", "normal.y", "normal.z"};

// Returns the names of a fit's planes in order. The estimates come first, each followed by its standard
// error.
std::vector<std::string> plane_names(const fit::Model& model) {
  std::vector<std::string> names;
  for (const fit::Reported& r : fit::reported_parameters(model, model.initial())) {
    const std::string name = texel::plane_name(r.estimate.name, r.estimate.channel);
    names.push_back(name);
    names.push_back("standard_error." + name);
  }
  if (!model.fits_normal()) names.insert(names.end(), {kNormalNames[0], kNormalNames[1]});
  names.insert(names.end(), {kNormalNames[2], "error", "images", "verdict", "grid"});
  return names;
}

// The pixels of a unit, read on demand in bands of rows.
class Bands {
 public:
  Bands(const texel::Stack& stack, const texel::Region& region, std::size_t memory)
      : stack_(stack),
        region_(region),
        rows_(std::clamp(memory / (texel::bytes_per_texel(stack) * region.width), std::size_t{1},
                         region.height)) {}

  // Returns the pixels of a texel, [channel][image]. The span is valid until the next call.
  std::span<const float> at(std::size_t x, std::size_t y) {
    const std::size_t first = y / rows_ * rows_, values = stack_.channels.size() * stack_.images.size();
    if (pixels_.empty() || first != first_) {
      first_ = first;
      pixels_ = texel::read_region(
          stack_, {region_.x, region_.y + first, region_.width, std::min(rows_, region_.height - first)});
    }
    return {&pixels_[((y - first) * region_.width + x) * values], values};
  }

 private:
  const texel::Stack& stack_;
  texel::Region region_;
  std::size_t rows_, first_ = 0;
  std::vector<float> pixels_;
};

}  // namespace

Vec3<double> normal_at(const Normals* normals, std::size_t texel) {
  if (!normals) return {0, 0, 1};
  const auto at = [&](std::size_t k) { return double((*normals->find(kNormalNames[k]))[texel]); };
  const Vec3<double> n{at(0), at(1), at(2)};
  return n * (1 / std::sqrt(dot(n, n)));
}

std::vector<double> plane_values(const TexelFit& fit, bool fits_normal, std::size_t channels) {
  std::vector<double> values;
  for (const fit::Estimate& e : fit.estimates) {
    values.push_back(e.value);
    values.push_back(e.status == fit::Status::unidentified ? fit::kUnknown
                     : e.status == fit::Status::free       ? e.standard_error * fit::widening(e.freedom)
                                                           : 0);
  }
  if (!fits_normal) values.insert(values.end(), {fit.normal.x, fit.normal.y});
  values.insert(values.end(), {fit.normal.z, fit.error(channels), double(fit.rows), double(fit.verdict),
                               fit.from_grid ? 1.0 : 0.0});
  return values;
}

texel::Planes unknown_maps(const fit::Model& model, std::size_t width, std::size_t height) {
  texel::Planes out{width, height, plane_names(model), {}};
  out.values.assign(out.names.size(),
                    std::vector<float>(width * height, std::numeric_limits<float>::quiet_NaN()));
  return out;
}

void put_texel(const std::vector<double>& values, std::size_t texel, texel::Planes& maps) {
  for (std::size_t plane = 0; plane < values.size(); ++plane)
    maps.values[plane][texel] = float(values[plane]);
}

Normals read_normals(const std::filesystem::path& path, const texel::Stack& stack) {
  Normals normals = texel::read_planes(path);
  if (normals.width != stack.width || normals.height != stack.height)
    throw InputError(path.string() + ": " + std::to_string(normals.width) + " x " +
                     std::to_string(normals.height) + " normals for a stack of " +
                     std::to_string(stack.width) + " x " + std::to_string(stack.height) + " texels");
  for (const char* name : kNormalNames)
    if (!normals.find(name)) throw InputError(path.string() + ": has no channel " + name);
  for (std::size_t k = 0; k < stack.width * stack.height; ++k) {
    const Vec3<double> n = normal_at(&normals, k);
    if (stack.holds(k % stack.width, k / stack.width) && !(n.z > 0))
      throw InputError(path.string() + ": the normal at " + std::to_string(k % stack.width) + ", " +
                       std::to_string(k / stack.width) + " must have a z above 0");
  }
  return normals;
}

void fit_texels(TexelFitter& fitter, const texel::Stack& stack, const Settings& settings,
                const Normals* normals, const texel::Region& region, std::size_t memory,
                const BeforeTexel& before, const VisitTexel& visit) {
  Bands bands(stack, region, memory);
  std::vector<TexelFit> above(region.width);  // the last fit in each column of a row of tiles
  for (std::size_t k = 0; k < region.size() && !settings.options.stop(); ++k) {
    const std::size_t x = k % region.width, y = k / region.width, column = region.x + x, row = region.y + y;
    if (row % kTile == 0) above[x] = {};
    if (!stack.holds(column, row)) continue;
    const bool has_left = column % kTile != 0 && !above[x - 1].empty();
    const TexelFit* neighbour = has_left ? &above[x - 1] : &above[x];
    if (neighbour->empty()) neighbour = nullptr;
    if (before) before(k);
    const TexelPixels pixels{bands.at(x, y), column, row};
    TexelFit fit = fitter.fit(pixels, normal_at(normals, row * stack.width + column), neighbour);
    if (fit.empty()) continue;
    visit(k, pixels, fit);
    above[x] = std::move(fit);
  }
}

texel::Planes fit_unit(const texel::Stack& stack, const Settings& settings, const Normals* normals,
                       const texel::Region& region, std::size_t memory) {
  TexelFitter fitter(stack, settings);
  texel::Planes out = unknown_maps(fitter.model(), region.width, region.height);
  fit_texels(fitter, stack, settings, normals, region, memory, {},
             [&](std::size_t k, const TexelPixels&, const TexelFit& fit) {
               put_texel(plane_values(fit, settings.fits_normal, stack.channels.size()), k, out);
             });
  return out;
}

texel::Planes empty_maps(const texel::Stack& stack, const Settings& settings) {
  return unknown_maps(TexelFitter(stack, settings).model(), stack.width, stack.height);
}

void put(const texel::Planes& unit, const texel::Region& region, texel::Planes& maps) {
  for (std::size_t k = 0; k < unit.values.size(); ++k)
    for (std::size_t y = 0; y < region.height; ++y)
      std::copy_n(&unit.values[k][y * region.width], region.width,
                  &maps.values[k][(region.y + y) * maps.width + region.x]);
}

texel::Planes fit_stack(const texel::Stack& stack, const Settings& settings, const Normals* normals,
                        const Resources& resources, const io::Progress& progress) {
  texel::Planes maps = empty_maps(stack, settings);
  // Units are as wide as the images, because rows of images are read as a whole. Units are narrower if
  // there are fewer wide units than threads.
  const bool wide = (stack.height + kUnit - 1) / kUnit >= resources.threads;
  const std::vector<texel::Region> units =
      texel::divided({0, 0, stack.width, stack.height}, wide ? stack.width : kUnit, kUnit);
  std::mutex mutex;
  int done = 0;
  io::parallel_for(
      units.size(),
      [&](std::size_t k) {
        if (settings.options.stop()) return;
        const texel::Planes unit =
            fit_unit(stack, settings, normals, units[k], resources.memory / std::max(resources.threads, 1u));
        const std::lock_guard lock(mutex);
        put(unit, units[k], maps);
        if (progress) progress(++done, int(units.size()));
      },
      resources.threads);
  return maps;
}

fit::Metric choose_metric(const texel::Stack& stack, const Settings& settings, const Normals* normals) {
  if (settings.options.metric != fit::Metric::automatic) return settings.options.metric;
  const std::size_t row = stack.height / 2, values = stack.channels.size() * stack.images.size();
  std::vector<std::size_t> votes(fit::kResiduals.size(), 0);
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < std::min(kMetricTexels, stack.width); ++k)
    if (const std::size_t column = (2 * k + 1) * stack.width / (2 * std::min(kMetricTexels, stack.width));
        stack.holds(column, row))
      columns.push_back(column);
  const std::vector<float> pixels = texel::read_texels(stack, columns, row);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const io::SampleTable table =
        texel_table(stack, {std::span(pixels).subspan(k * values, values), columns[k], row},
                    normal_at(normals, row * stack.width + columns[k]));
    try {
      const fit::FitData data = fit::prepare(table, settings.options);
      const auto noise = io::relative_noise(table, data.row).value;
      if (noise) ++votes[std::size_t(fit::choose_metric(table, data, noise, settings.options).metric)];
    } catch (const InputError&) {
      continue;  // a texel without light
    }
  }
  const auto most = std::ranges::max_element(votes);
  return fit::Metric(most - votes.begin());  // the first of equals: log
}

std::size_t Summary::usable() const {
  std::size_t count = 0;
  for (std::size_t k = 0; k < verdicts.size(); ++k)
    if (fit::usable(fit::Verdict(k))) count += verdicts[k];
  return count;
}

Summary summary_of(const texel::Planes& maps) {
  Summary out;
  out.texels = maps.width * maps.height;
  out.verdicts.assign(kNames<fit::Verdict>.size(), 0);
  std::vector<double> errors;
  for (std::size_t k = 0; k < out.texels; ++k) {
    const float verdict = (*maps.find("verdict"))[k];
    if (std::isnan(verdict)) continue;
    ++out.fitted;
    ++out.verdicts[std::size_t(verdict)];
    out.from_grid += (*maps.find("grid"))[k] == 1;
    errors.push_back(double((*maps.find("error"))[k]));
  }
  if (!errors.empty()) out.median_error = io::median(std::move(errors));
  return out;
}

}  // namespace brdf::maps
