// What every table must keep to, whoever made it, so that writing it and reading it back gives the same
// table.
#pragma once

#include "io/samples/samples.h"

namespace brdf::io {

// Refuses names that a table's header cannot hold, repeated ones and too many. `where` opens the message.
void check_channel_names(const std::vector<std::string>& names, const std::string& where);

// Names, polar angles from 0 to 90 degrees, azimuths within a million, finite values (of measured ones),
// standard deviations above 0.
void check_table(const SampleTable& table, Origin origin = Origin::measured);

}  // namespace brdf::io
