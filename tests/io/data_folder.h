#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace brdf {

// The folder with measured samples, or nothing where BRDF_DATA_DIR is unset: such tests say so and skip.
inline std::optional<std::filesystem::path> measured_data() {
  const char* const folder = std::getenv("BRDF_DATA_DIR");
  if (!folder || !*folder) return std::nullopt;
  return std::filesystem::path(folder) / "measured";
}

}  // namespace brdf
