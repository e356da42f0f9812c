// The output of maps: files, a summary and a page.
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "maps/stack_fit.h"

namespace brdf::maps {

inline constexpr const char* kMapsFile = "maps.exr";
inline constexpr const char* kSummaryFile = "maps.json";

// The origin of the maps, as recorded in the files.
struct Making {
  const Settings& settings;
  std::string normals;  // "flat", "fit" or a file name
  std::string command;
  std::vector<std::string> shared{};  // shapes that the texels of a region have in common
  std::string regions{};              // file of the regions; empty: the whole stack
};

// Writes maps.exr and maps.json. The attributes of maps.exr describe the fit and explain the numbers of the
// verdicts.
void write_maps(const std::filesystem::path& folder, const texel::Planes& maps, const Making& making,
                const std::string& summary);

// Returns the content of maps.json (schema: docs/fit.schema.json).
std::string summary_json(const texel::Stack& stack, const Making& making, const Summary& summary,
                         const texel::Planes& maps);

// Prints the summary as text. `seconds` is the duration of the fit, if known.
void print(std::ostream& out, const texel::Stack& stack, const Making& making, const Summary& summary,
           const std::filesystem::path& folder, std::optional<double> seconds);

// Returns a page with every map as a picture above its histogram, and the worst texels.
std::string html_page(const texel::Stack& stack, const Making& making, const Summary& summary,
                      const texel::Planes& maps);

}  // namespace brdf::maps
