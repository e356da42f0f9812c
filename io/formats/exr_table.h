// Reads and writes tables as OpenEXR images.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Tables as OpenEXR images of 32-bit floats. A row is one pixel, with kExrTableWidth pixels per line; the
// rest of the last line is NaN. A column is one channel under its CSV name.
inline constexpr std::size_t kExrTableWidth = 1024;
// String attributes in addition to one attribute per comment key. `columns` lists the columns in the
// table's order, because OpenEXR sorts channels by name. `comments` holds the comments, one per line,
// because attributes are sorted too and free text has no key.
inline constexpr std::string_view kExrColumns = "columns", kExrComments = "comments";
// Prefix of a comment's key if OpenEXR has an attribute of the same name.
inline constexpr std::string_view kExrPrefix = "comment.";

// Writes `table` to `path`. Returns the losses, one phrase each. A positive standard deviation stays above
// 0 even if a float cannot hold it. Throws InputError if the table has no rows or breaks a rule of tables.
// Example:
//     // #include "brdf/io/formats/read.h"
//     const brdf::io::SampleTable table = brdf::io::read_samples("paint.csv");
//     for (const std::string& loss : write_exr_table("paint.exr", table))
//       std::printf("lost: %s\n", loss.c_str());
//     const brdf::io::SampleTable again = brdf::io::read_samples("paint.exr");
std::vector<std::string> write_exr_table(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io

namespace brdf::io::exr {

// Returns whether the content is an OpenEXR image.
bool recognises(const Content& content);

// Reads a table from an OpenEXR image, which any program may have written. The image has the channels
// theta_i, phi_i, theta_o and phi_o in degrees, and channels of values; pixels may have any type. Each
// float becomes the shortest decimal number that rounds to this float, so numbers of six digits are
// restored exactly. Pixels that are not finite are left out and counted. Channels of another quantity are
// converted to f_r, as columns of text files are, unless the attribute `columns` shows that this program
// wrote the file. Throws InputError if the image is not a table or is damaged.
SampleTable read(const Content& content, const Supplied& supplied);

}  // namespace brdf::io::exr
