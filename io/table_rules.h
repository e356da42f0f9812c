// What every table must keep to, whoever made it, so that writing it and reading it back gives the same table.
#pragma once

#include "io/samples.h"

namespace brdf::io {

inline constexpr std::string_view kAngleNames[] = {"theta_i", "phi_i", "theta_o", "phi_o"};
inline constexpr std::string_view kSigmaPrefix = "sigma_";

bool is_plain_angle_name(std::string_view name);
// Whether a header row names the four angles as the plain format does.
bool has_plain_angle_names(const std::vector<std::string_view>& names);

// Refuses names that a table's header cannot hold, repeated ones and too many. `where` opens the message.
void check_channel_names(const std::vector<std::string>& names, const std::string& where);

// Names, polar angles from 0 to 90 degrees, azimuths within a million, finite values (of measured ones), standard deviations above 0.
void check_table(const SampleTable& table, Origin origin = Origin::measured);

}  // namespace brdf::io
