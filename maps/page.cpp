#include "maps/page.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/model/constraints.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/png.h"
#include "io/files/text.h"
#include "io/page/hatching.h"
#include "io/page/html_markup.h"
#include "io/page/html_report.h"

namespace brdf::maps {
namespace {

using io::Json;

constexpr std::size_t kWorst = 10, kWidestPicture = 256, kHistogramHeight = 40, kHistogramGap = 4;
constexpr std::string_view kErrorPrefix = "standard_error.";

struct Texel {
  std::size_t x, y;
  double error;
  fit::Verdict verdict;
};

// Returns the texels with the largest residuals, unusable texels first.
std::vector<Texel> worst_texels(const texel::Planes& maps) {
  std::vector<Texel> all;
  for (std::size_t k = 0; k < maps.width * maps.height; ++k)
    if (const float verdict = (*maps.find("verdict"))[k]; !std::isnan(verdict))
      all.push_back(
          {k % maps.width, k / maps.width, double((*maps.find("error"))[k]), fit::Verdict(int(verdict))});
  const std::size_t kept = std::min(kWorst, all.size());
  std::ranges::partial_sort(all, all.begin() + std::ptrdiff_t(kept), [](const Texel& a, const Texel& b) {
    if (fit::usable(a.verdict) != fit::usable(b.verdict)) return fit::usable(b.verdict);
    return std::pair(-a.error, std::pair(a.y, a.x)) < std::pair(-b.error, std::pair(b.y, b.x));
  });
  all.resize(kept);
  return all;
}

// Returns the planes that hold parameters, without planes about their uncertainty.
std::vector<std::size_t> parameter_planes(const texel::Planes& maps) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < maps.names.size(); ++k)
    if (maps.find(std::string(kErrorPrefix) + maps.names[k])) out.push_back(k);
  return out;
}

// Returns a plane in which unidentified values are replaced by NaN.
std::vector<float> told(const texel::Planes& maps, std::size_t plane) {
  std::vector<float> values = maps.values[plane];
  if (const std::vector<float>* errors = maps.find(std::string(kErrorPrefix) + maps.names[plane]))
    for (std::size_t k = 0; k < values.size(); ++k)
      if (std::isnan((*errors)[k])) values[k] = (*errors)[k];
  return values;
}

struct Range {
  double low = 0, high = 0;  // the first and the last percentile; NaN if there are no values
  std::size_t count = 0;
};

Range range_of(const std::vector<float>& values) {
  std::vector<double> known;
  for (const float v : values)
    if (std::isfinite(v)) known.push_back(double(v));
  return {io::quantile(known, 0.01), io::quantile(known, 0.99), known.size()};
}

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

// Returns a picture of the map and, below the map, its histogram in the same colours, from dark to bright. A
// fitted texel whose value is not identifiable is hatched; a texel that was not fitted is transparent.
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

std::string counted(const Summary& summary) {
  std::string out;
  for (std::size_t k = 0; k < summary.verdicts.size(); ++k)
    if (summary.verdicts[k] > 0)
      out += (out.empty() ? "" : ", ") + std::to_string(summary.verdicts[k]) + " " +
             std::string(kNames<fit::Verdict>[k]);
  return out;
}

// Returns version and command, as in every output.
std::vector<std::pair<std::string, std::string>> fields_of(const Making& making) {
  io::Provenance made = io::provenance();
  made.command = making.command;
  return io::provenance_fields(made);
}

// Returns the region in which a shared shape has one value, as text.
std::string in_words_of_regions(const Making& making) {
  return making.regions.empty() ? ", with one value for the stack"
                                : ", with one value in each region of " + making.regions;
}

}  // namespace

void write_maps(const std::filesystem::path& folder, const texel::Planes& maps, const Making& making,
                const std::string& summary) {
  texel::Planes file = maps;
  std::string verdicts;
  for (const std::string_view name : kNames<fit::Verdict>)
    verdicts += (verdicts.empty() ? "" : " ") + std::string(name);
  file.attributes = {{"form", fit::name_of_sum(making.settings.forms)},
                     {"metric", std::string(name_of(making.settings.options.metric))},
                     {"normals", making.normals},
                     {"verdicts", verdicts}};
  if (!making.shared.empty())
    file.attributes.emplace_back("shared", io::joined(making.shared, " ") + in_words_of_regions(making));
  for (const auto& field : fields_of(making)) file.attributes.push_back(field);
  texel::write_planes(folder / kMapsFile, file);
  io::write_file_atomically(folder / kSummaryFile, summary);
}

std::string summary_json(const texel::Stack& stack, const Making& making, const Summary& summary,
                         const texel::Planes& maps) {
  Json verdicts = Json::object();
  for (std::size_t k = 0; k < summary.verdicts.size(); ++k)
    verdicts[std::string(kNames<fit::Verdict>[k])] = summary.verdicts[k];
  Json planes = Json::array();
  for (const std::size_t k : parameter_planes(maps)) {
    const Range range = range_of(told(maps, k));
    planes.push_back({{"name", maps.names[k]},
                      {"low", range.count > 0 ? Json(range.low) : Json()},
                      {"high", range.count > 0 ? Json(range.high) : Json()},
                      {"identified", range.count}});
  }
  Json worst = Json::array();
  for (const Texel& t : worst_texels(maps))
    worst.push_back(
        {{"x", t.x}, {"y", t.y}, {"error", t.error}, {"verdict", std::string(name_of(t.verdict))}});
  Json out = {{"stack", stack.folder.string()},
              {"width", stack.width},
              {"height", stack.height},
              {"images", stack.images.size()},
              {"channels", stack.channels},
              {"form", fit::name_of_sum(making.settings.forms)},
              {"metric", std::string(name_of(making.settings.options.metric))},
              {"normals", making.normals},
              {"shared", making.shared},
              {"regions", making.regions.empty() ? Json() : Json(making.regions)},
              {"fitted", summary.fitted},
              {"usable", summary.usable()},
              {"from_grid", summary.from_grid},
              {"verdicts", verdicts},
              {"approximate", true},
              {"median_error", summary.median_error},
              {"parameters", planes},
              {"worst", worst}};
  for (const auto& [key, value] : fields_of(making)) out[key] = value;
  return io::to_text(out);
}

void print(std::ostream& out, const texel::Stack& stack, const Making& making, const Summary& summary,
           const std::filesystem::path& folder, std::optional<double> seconds) {
  const Settings& settings = making.settings;
  out << stack.width << " x " << stack.height << " texels, " << io::plural(stack.images.size(), "image")
      << ", " << io::plural(stack.channels.size(), "channel") << "; " << fit::name_of_sum(settings.forms)
      << ", metric " << name_of(settings.options.metric) << '\n';
  if (!making.shared.empty())
    out << "shared: " << io::joined(making.shared, ", ") << in_words_of_regions(making) << '\n';
  out << summary.fitted << " fitted: " << counted(summary) << "; " << summary.from_grid
      << " from the grid of starts\n"
      << "median residual: " << io::short_number(summary.median_error)
      << "; standard errors are approximate: they follow from the curvature at each minimum\n";
  if (seconds)
    out << io::short_number(*seconds) << " s, "
        << io::short_number(1e6 * *seconds / double(std::max<std::size_t>(summary.fitted, 1)))
        << " us for each texel\n";
  out << io::printable((folder / kMapsFile).string()) << ", "
      << io::printable((folder / kSummaryFile).string()) << '\n';
}

std::string html_page(const texel::Stack& stack, const Making& making, const Summary& summary,
                      const texel::Planes& maps) {
  const Settings& settings = making.settings;
  const std::string name = io::file_name(std::filesystem::path(stack.folder / "").parent_path().string());
  io::HtmlReport html("Maps of " + name);
  const std::size_t converged = summary.verdicts[std::size_t(fit::Verdict::converged)];
  const auto share = [&](std::size_t count) {
    return double(count) / double(std::max<std::size_t>(summary.fitted, 1));
  };
  html.verdict(share(converged) > 0.99         ? io::Mark::good
               : share(summary.usable()) > 0.5 ? io::Mark::warn
                                               : io::Mark::bad,
               std::to_string(converged) + " of " + io::plural(summary.fitted, "texel") + " converged; " +
                   std::to_string(summary.usable()) + (summary.usable() == 1 ? " has" : " have") +
                   " a usable fit.");
  html.paragraph(
      std::to_string(stack.width) + " x " + std::to_string(stack.height) + " texels under " +
      std::to_string(stack.images.size()) + " pairs of directions, each texel fitted with " +
      fit::name_of_sum(settings.forms) + " (metric " + std::string(name_of(settings.options.metric)) +
      "): " + counted(summary) + "." +
      (making.shared.empty()
           ? ""
           : " Shared: " + io::joined(making.shared, ", ") + in_words_of_regions(making) + ".") +
      " Standard errors and verdicts are approximate: they follow from the curvature at each minimum, "
      "without the check of "
      "energy.");
  html.heading("Maps");
  std::string figures = "<div class=\"row maps\">\n" + verdict_figure(maps, summary);
  for (const Shown& shown : shown_planes(maps))
    figures += figure_of(maps, shown.plane, shown.title, summary.fitted);
  for (std::size_t k = 0; k < maps.names.size(); ++k)
    if (maps.names[k] == "error") figures += figure_of(maps, k, "residual", summary.fitted);
  html.raw(figures + "</div>");
  html.paragraph(
      "Below each map is the histogram of its values, from dark to bright. The colours extend from the first "
      "to the last percentile. Hatched: the value is not identifiable.");
  html.heading("Worst texels");
  std::vector<io::Row> rows;
  for (const Texel& t : worst_texels(maps))
    rows.push_back(
        {{std::to_string(t.x)},
         {std::to_string(t.y)},
         {std::string(name_of(t.verdict)), fit::usable(t.verdict) ? io::Mark::good : io::Mark::bad},
         {io::short_number(t.error)}});
  html.table({"x", "y", "verdict", "residual"}, rows, true);
  html.footnote("stack", stack.folder.string());
  return html.document(io::provenance());
}

}  // namespace brdf::maps
