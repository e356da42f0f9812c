#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io {

// A table as an OpenEXR image of 32-bit floats: one pixel per row, kExrTableWidth to a line (the rest of the
// last line is NaN), one channel per column under its CSV name.
inline constexpr std::size_t kExrTableWidth = 1024;
// String attributes beside those of the comments' keys: the columns in the table's order (OpenEXR sorts its
// channels by name), the comments a line each (attributes are sorted too, and free text has no key).
inline constexpr std::string_view kExrColumns = "columns", kExrComments = "comments";
// Before a comment's key where OpenEXR has an attribute of that name.
inline constexpr std::string_view kExrPrefix = "comment.";

// Returns what is lost. A standard deviation that a float cannot hold is kept above 0.
std::vector<std::string> write_exr_table(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io

namespace brdf::io::exr {

// Whether the content is an OpenEXR image.
bool recognises(const Content& content);

// Reads such an image, anybody's: the channels theta_i, phi_i, theta_o, phi_o in degrees and those of values,
// of any type of pixel. A float becomes the shortest decimal that it stands for, so that numbers of six
// digits come back as they were. Pixels that are not finite are left out and counted. Channels of another
// quantity become f_r, as columns of text do, unless the attribute `columns` says that the file is ours.
// Throws InputError where it is none or is damaged.
SampleTable read(const Content& content, const Supplied& supplied);

}  // namespace brdf::io::exr
