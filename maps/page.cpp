#include "maps/page.h"

#include <algorithm>
#include <cmath>

#include "fit/model/constraints.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/png.h"
#include "io/files/text.h"
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

// Pixels that are transparent at first.
class Canvas {
 public:
  Canvas(std::size_t width, std::size_t height)
      : width_(width), height_(height), pixels_(4 * width * height) {}

  // Sets the pixel to the colour of `share`, a fraction of the range.
  void set(std::size_t x, std::size_t y, double share) {
    unsigned char* pixel = &pixels_[4 * (y * width_ + x)];
    io::map_colour(share, pixel);
    pixel[3] = 255;
  }
  std::string png() const { return io::png_of_pixels(width_, height_, pixels_); }

 private:
  std::size_t width_, height_;
  std::vector<unsigned char> pixels_;
};

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

// Returns a picture of the map and, below the map, its histogram in the same colours, from dark to bright.
// Pixels without a value are transparent.
std::string picture_of(const texel::Planes& maps, const std::vector<float>& values, const Range& range) {
  const std::size_t larger = std::max(maps.width, maps.height),
                    step = (larger + kWidestPicture - 1) / kWidestPicture,
                    zoom = std::max<std::size_t>(1, kWidestPicture / 2 / larger);
  const std::size_t width = (maps.width + step - 1) / step * zoom,
                    height = (maps.height + step - 1) / step * zoom;
  Canvas canvas(width, height + kHistogramGap + kHistogramHeight);
  for (std::size_t k = 0; k < width * height; ++k) {
    const std::size_t x = k % width, y = k / width;
    const float value = values[y / zoom * step * maps.width + x / zoom * step];
    if (std::isfinite(value)) canvas.set(x, y, share_of(double(value), range));
  }
  const std::vector<double> counts = histogram(values, range, width);
  for (std::size_t x = 0; x < width; ++x)
    for (std::size_t y = 0; y < std::size_t(std::ceil(counts[x] * double(kHistogramHeight))); ++y)
      canvas.set(x, height + kHistogramGap + kHistogramHeight - 1 - y,
                 double(x) / double(std::max<std::size_t>(width - 1, 1)));
  return canvas.png();
}

io::Figure figure_of(const texel::Planes& maps, std::size_t plane, std::size_t fitted) {
  const std::vector<float> values = told(maps, plane);
  const Range range = range_of(values);
  std::string text = "not identifiable in any texel";
  if (maps.names[plane] == "verdict") {
    text.clear();
    for (std::size_t k = 0; k < kNames<fit::Verdict>.size(); ++k)
      if (std::ranges::find(values, float(k)) != values.end())
        text += (text.empty() ? "" : ", ") + std::to_string(k) + " " + std::string(kNames<fit::Verdict>[k]);
    text += "; dark to bright";
  } else if (range.count > 0)
    text = "dark " + io::short_number(range.low) + ", bright " + io::short_number(range.high) +
           (range.count < fitted ? "; identifiable in " + io::percent(double(range.count) / double(fitted))
                                 : "");
  return {picture_of(maps, values, range), maps.names[plane], text};
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
  const double share = double(summary.usable()) / double(std::max<std::size_t>(summary.fitted, 1));
  html.verdict(share > 0.99  ? io::Mark::good
               : share > 0.5 ? io::Mark::warn
                             : io::Mark::bad,
               std::to_string(summary.usable()) + " of " + std::to_string(summary.fitted) +
                   " texels have a usable fit, " +
                   std::to_string(summary.verdicts[std::size_t(fit::Verdict::converged)]) +
                   " of them converged.");
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
  std::vector<io::Figure> pictures;
  std::vector<std::size_t> planes = parameter_planes(maps);
  for (std::size_t k = 0; k < maps.names.size(); ++k)
    if (maps.names[k] == "error" || maps.names[k] == "verdict") planes.push_back(k);
  for (const std::size_t k : planes) pictures.push_back(figure_of(maps, k, summary.fitted));
  html.pictures(pictures);
  html.paragraph(
      "Below each map is the histogram of its values, from dark to bright. The colours extend from the first "
      "to the last percentile.");
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
