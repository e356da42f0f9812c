#include "maps/figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/files/numbers.h"
#include "io/files/png.h"
#include "io/page/hatching.h"
#include "io/page/html_markup.h"
#include "io/page/html_report.h"

namespace brdf::maps {
namespace {

constexpr std::size_t kWidestPicture = 256, kHistogramHeight = 40, kHistogramGap = 4;
constexpr std::string_view kErrorPrefix = "standard_error.";

using Rgb = std::array<unsigned char, 3>;

// Pixels that are transparent at first.
class Canvas {
 public:
  Canvas(std::size_t width, std::size_t height)
      : width_(width), height_(height), pixels_(4 * width * height) {}

  void set(std::size_t x, std::size_t y, const Rgb& colour) {
    unsigned char* const pixel = &pixels_[4 * (y * width_ + x)];
    std::ranges::copy(colour, pixel);
    pixel[3] = 255;
  }
  // Sets the pixel to the colour of `share`, a fraction of the range.
  void set_share(std::size_t x, std::size_t y, double share) {
    Rgb colour;
    io::map_colour(share, colour.data());
    set(x, y, colour);
  }
  void hatch(std::size_t x, std::size_t y) {
    const unsigned char grey = io::hatching(x, y);
    set(x, y, {grey, grey, grey});
  }
  std::string png() const { return io::png_of_pixels(width_, height_, pixels_); }

 private:
  std::size_t width_, height_;
  std::vector<unsigned char> pixels_;
};

// The size of a picture in texels and pixels: large maps are thinned, small ones enlarged.
struct Size {
  std::size_t step, zoom, width, height;  // pixels

  explicit Size(const texel::Planes& maps) {
    const std::size_t larger = std::max(maps.width, maps.height);
    step = (larger + kWidestPicture - 1) / kWidestPicture;
    zoom = std::max<std::size_t>(1, kWidestPicture / larger);
    width = (maps.width + step - 1) / step * zoom;
    height = (maps.height + step - 1) / step * zoom;
  }
  std::size_t texel(const texel::Planes& maps, std::size_t x, std::size_t y) const {
    return y / zoom * step * maps.width + x / zoom * step;
  }
};

// The colours of the verdicts: usable ones green and blue, others orange, red and grey. They are told apart
// without colour vision (after Okabe and Ito, 2008).
constexpr std::array<Rgb, kNames<fit::Verdict>.size()> kVerdictColours{
    Rgb{0, 138, 100}, Rgb{55, 147, 196}, Rgb{143, 220, 247}, Rgb{213, 94, 0},
    Rgb{163, 18, 58}, Rgb{238, 196, 80}, Rgb{60, 60, 60},    Rgb{150, 150, 150}};

std::string in_words(std::size_t verdict) {
  std::string name(kNames<fit::Verdict>[verdict]);
  std::ranges::replace(name, '_', ' ');
  return name;
}

double share_of(double value, const Range& range) {
  return range.high > range.low ? (value - range.low) / (range.high - range.low) : 0.5;
}

// Returns the frequency of each part of the range, relative to the most frequent part. Values outside the
// range count in the first or last bin.
std::vector<double> histogram(const std::vector<float>& values, const Range& range, std::size_t bins) {
  std::vector<double> counts(bins, 0);
  for (const float value : values)
    if (std::isfinite(value))
      ++counts[std::size_t(std::clamp(share_of(double(value), range), 0.0, 1.0) * double(bins - 1) + 0.5)];
  const double most = std::max(1.0, *std::ranges::max_element(counts));
  for (double& count : counts) count /= most;
  return counts;
}

// Returns a picture of the map and, below the map, its histogram in the same colours, from dark to
// bright. Fitted texels without an identifiable value are hatched. Texels that were not fitted are
// transparent.
std::string picture_of(const texel::Planes& maps, const std::vector<float>& values, const Range& range) {
  const Size size(maps);
  const std::vector<float>& verdicts = *maps.find("verdict");
  Canvas canvas(size.width, size.height + kHistogramGap + kHistogramHeight);
  for (std::size_t k = 0; k < size.width * size.height; ++k) {
    const std::size_t x = k % size.width, y = k / size.width, texel = size.texel(maps, x, y);
    if (std::isfinite(values[texel]))
      canvas.set_share(x, y, share_of(double(values[texel]), range));
    else if (!std::isnan(verdicts[texel]))
      canvas.hatch(x, y);
  }
  const std::vector<double> counts = histogram(values, range, size.width);
  for (std::size_t x = 0; x < size.width; ++x)
    for (std::size_t y = 0; y < std::size_t(std::ceil(counts[x] * double(kHistogramHeight))); ++y)
      canvas.set_share(x, size.height + kHistogramGap + kHistogramHeight - 1 - y,
                       double(x) / double(std::max<std::size_t>(size.width - 1, 1)));
  return canvas.png();
}

std::string figure(const std::string& title, const std::string& png, const std::string& below) {
  return "<figure><p class=\"title\">" + io::html_escaped(title) + "</p>" + io::image(png, title) + below +
         "</figure>\n";
}

// The map of a plane with its colour bar.
std::string figure_of(const texel::Planes& maps, std::size_t plane, const std::string& title,
                      std::size_t fitted) {
  const std::vector<float> values = told(maps, plane);
  const Range range = range_of(values);
  std::string below = range.count == 0 ? std::string()
                                       : io::colour_bar(io::short_number(range.low), io::Colours::sequential,
                                                        io::short_number(range.high));
  if (range.count < fitted)
    below += "<figcaption>" +
             (range.count == 0 ? std::string("not identifiable in any texel")
                               : "identifiable in " + std::to_string(range.count) + " of " +
                                     std::to_string(fitted) + " texels; hatched elsewhere") +
             "</figcaption>";
  return figure(title, picture_of(maps, values, range), below);
}

// The map of the verdicts, with the name, the colour and the count of each.
std::string verdict_figure(const texel::Planes& maps, const Summary& summary) {
  const Size size(maps);
  const std::vector<float>& verdicts = *maps.find("verdict");
  Canvas canvas(size.width, size.height);
  for (std::size_t k = 0; k < size.width * size.height; ++k) {
    const std::size_t x = k % size.width, y = k / size.width;
    if (const float verdict = verdicts[size.texel(maps, x, y)]; !std::isnan(verdict))
      canvas.set(x, y, kVerdictColours[std::size_t(verdict)]);
  }
  std::string legend = "<ul class=\"swatches\">";
  for (std::size_t k = 0; k < summary.verdicts.size(); ++k) {
    if (summary.verdicts[k] == 0) continue;
    const Rgb& c = kVerdictColours[k];
    legend += "<li><i style=\"background: rgb(" + std::to_string(c[0]) + " " + std::to_string(c[1]) + " " +
              std::to_string(c[2]) + ")\"></i>" + in_words(k) + ": " + std::to_string(summary.verdicts[k]) +
              "</li>";
  }
  return figure("verdict", canvas.png(), legend + "</ul>");
}

bool is_same(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

// A map of the page: a plane, named after all planes with the same values ("alpha_x = alpha_y").
struct Shown {
  std::size_t plane;
  std::string title;
};

std::vector<Shown> shown_planes(const texel::Planes& maps) {
  std::vector<Shown> shown;
  for (const std::size_t plane : parameter_planes(maps)) {
    const std::vector<float> values = told(maps, plane);
    const bool has_values = std::ranges::any_of(values, [](float v) { return std::isfinite(v); });
    const auto twin = std::ranges::find_if(shown, [&](const Shown& s) {
      return has_values && std::ranges::equal(told(maps, s.plane), values, is_same);
    });
    if (twin == shown.end())
      shown.push_back({plane, maps.names[plane]});
    else
      twin->title += " = " + maps.names[plane];
  }
  return shown;
}

}  // namespace

std::vector<std::size_t> parameter_planes(const texel::Planes& maps) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < maps.names.size(); ++k)
    if (maps.find(std::string(kErrorPrefix) + maps.names[k])) out.push_back(k);
  return out;
}

std::vector<float> told(const texel::Planes& maps, std::size_t plane) {
  std::vector<float> values = maps.values[plane];
  if (const std::vector<float>* errors = maps.find(std::string(kErrorPrefix) + maps.names[plane]))
    for (std::size_t k = 0; k < values.size(); ++k)
      if (std::isnan((*errors)[k])) values[k] = (*errors)[k];
  return values;
}

Range range_of(const std::vector<float>& values) {
  std::vector<double> known;
  for (const float v : values)
    if (std::isfinite(v)) known.push_back(double(v));
  return {io::quantile(known, 0.01), io::quantile(known, 0.99), known.size()};
}

std::string figures_of(const texel::Planes& maps, const Summary& summary) {
  std::string figures = "<div class=\"row maps\">\n" + verdict_figure(maps, summary);
  for (const Shown& shown : shown_planes(maps))
    figures += figure_of(maps, shown.plane, shown.title, summary.fitted);
  for (std::size_t k = 0; k < maps.names.size(); ++k)
    if (maps.names[k] == "error") figures += figure_of(maps, k, "residual", summary.fitted);
  return figures + "</div>";
}

}  // namespace brdf::maps
