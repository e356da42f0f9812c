#include "maps/page.h"

#include <algorithm>
#include <cmath>

#include "fit/model/constraints.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/text.h"
#include "io/page/html_report.h"
#include "maps/figures.h"

namespace brdf::maps {
namespace {

using io::Json;

constexpr std::size_t kWorst = 10;

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
  std::partial_sort(
      all.begin(), all.begin() + std::ptrdiff_t(kept), all.end(), [](const Texel& a, const Texel& b) {
        if (fit::usable(a.verdict) != fit::usable(b.verdict)) return fit::usable(b.verdict);
        return std::pair(-a.error, std::pair(a.y, a.x)) < std::pair(-b.error, std::pair(b.y, b.x));
      });
  all.resize(kept);
  return all;
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
              {"median_error", summary.median_error ? io::Json(*summary.median_error) : io::Json()},
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
  if (summary.median_error)
    out << summary.fitted << " fitted: " << counted(summary) << "; " << summary.from_grid
        << " from the grid of starts\n"
        << "median residual: " << io::short_number(*summary.median_error)
        << "; standard errors are approximate: they follow from the curvature at each minimum\n";
  else
    out << "no texel was fitted: look at the mask, the dark level and the saturation of the stack\n";
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
  html.raw(figures_of(maps, summary));
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
