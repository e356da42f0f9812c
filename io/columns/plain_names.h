// The column names of our own tables.
#pragma once

#include <string_view>
#include <vector>

namespace brdf::io {

inline constexpr std::string_view kAngleNames[] = {"theta_i", "phi_i", "theta_o", "phi_o"};
inline constexpr std::string_view kSigmaPrefix = "sigma_";

// Returns whether the name is one of kAngleNames.
bool is_plain_angle_name(std::string_view name);
// Returns whether a header row contains the four angle names of the plain format.
bool has_plain_angle_names(const std::vector<std::string_view>& names);

}  // namespace brdf::io
