// Checks the rules of tables, which guarantee that a table that is written and read back is the same table.
#pragma once

#include "io/samples/samples.h"

namespace brdf::io {

// Throws InputError for names that a header row cannot hold, for repeated names and for too many names.
// `where` opens the message.
void check_channel_names(const std::vector<std::string>& names, const std::string& where);

// Adds a comment to the metadata. Throws InputError if the table has 100,000 comments, because a file of
// comments alone would fill the memory.
void keep_comment(SampleTable& table, Comment comment);

// Throws InputError unless the channel names are valid, the comments are short enough for a line, polar
// angles are from 0 to 90 degrees, azimuths from -1e6 to 1e6 degrees, measured values finite and no fill
// values (io/samples/fill_values.h), and standard deviations finite and above 0.
void check_table(const SampleTable& table, Origin origin = Origin::measured);

}  // namespace brdf::io
