// The folder with measured samples for tests.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace brdf {

// Returns the folder with measured samples, or std::nullopt if BRDF_DATA_DIR is unset or empty. Tests that
// need the folder then skip with a message.
inline std::optional<std::filesystem::path> measured_data() {
  const char* const folder = std::getenv("BRDF_DATA_DIR");
  if (!folder || !*folder) return std::nullopt;
  return std::filesystem::path(folder) / "measured";
}

}  // namespace brdf
