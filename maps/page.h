// What becomes of maps: files, a summary, a page.
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

// What maps were made of, as the files say it.
struct Making {
  const Settings& settings;
  std::string normals;  // flat, fit or a file
  std::string command;
  std::vector<std::string> shared{};  // shapes that the texels of a region have in common
  std::string regions{};              // the file of these; empty: the whole stack
};

// maps.exr, which says in its attributes what was fitted and what the verdicts' numbers mean, and maps.json.
void write_maps(const std::filesystem::path& folder, const texel::Planes& maps, const Making& making,
                const std::string& summary);

// docs/fit.schema.json has its schema.
std::string summary_json(const texel::Stack& stack, const Making& making, const Summary& summary,
                         const texel::Planes& maps);

void print(std::ostream& out, const texel::Stack& stack, const Making& making, const Summary& summary,
           const std::filesystem::path& folder, std::optional<double> seconds);

// A page with every map as a picture above its histogram, and the worst texels.
std::string html_page(const texel::Stack& stack, const Making& making, const Summary& summary,
                      const texel::Planes& maps);

}  // namespace brdf::maps
