// The names that our own tables give to their columns.
#pragma once

#include <string_view>
#include <vector>

namespace brdf::io {

inline constexpr std::string_view kAngleNames[] = {"theta_i", "phi_i", "theta_o", "phi_o"};
inline constexpr std::string_view kSigmaPrefix = "sigma_";

bool is_plain_angle_name(std::string_view name);
// Whether a header row names the four angles as the plain format does.
bool has_plain_angle_names(const std::vector<std::string_view>& names);

}  // namespace brdf::io
