#include "io/columns/plain_names.h"

#include <algorithm>

namespace brdf::io {

bool is_plain_angle_name(std::string_view name) {
  return std::find(std::begin(kAngleNames), std::end(kAngleNames), name) != std::end(kAngleNames);
}

bool has_plain_angle_names(const std::vector<std::string_view>& names) {
  return std::all_of(std::begin(kAngleNames), std::end(kAngleNames),
                     [&](std::string_view angle) { return std::ranges::find(names, angle) != names.end(); });
}

}  // namespace brdf::io
