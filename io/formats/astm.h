// Reads and writes ASTM E1392 text of scatterometers: keyword lines, then a VARS line with the names of the
// columns (theta_i, phi_i, theta_s, phi_s and the channels), then comma-separated rows.
#pragma once

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io::astm {

// Returns whether the first lines of the text contain a VARS line.
bool recognises(const Content& text);

// Reads a table. Angles are assumed to be in radians if no polar angle exceeds pi/2 and no azimuth exceeds
// a full turn, otherwise in degrees. Some files omit the name of an angle in VARS. If the rows have one
// column more than there are names, the missing angle is assumed to be in its usual place. If they have
// equally many, the file lacks the angle, and phi_i = 180 or phi_s = 0 degrees is assumed (the plane of
// incidence, with the mirror direction at phi_s = 0). The warnings report either assumption. A keyword
// ANGLE_UNIT with `degrees` or `radians` decides the unit, and a keyword QUANTITY with a name of
// io/columns/quantities.h decides the quantity; neither is kept as a comment. A column sigma_CHANNEL is the
// standard deviation of that channel. Throws InputError with the line if the text breaks the format.
SampleTable read(const Content& text, const Supplied& supplied);

// Writes a file that reads back to the same table. Angles are in degrees, recorded by ANGLE_UNIT; comments
// become keywords. QUANTITY f_r is added if the name of a channel indicates another quantity. Returns the
// losses, one phrase each: comments that are not keywords (free text, keys with blanks). Throws InputError
// if the table breaks a rule of tables, has no rows, or has a channel name that VARS cannot hold.
// Example:
//     // #include "brdf/io/formats/read.h"
//     const brdf::io::SampleTable table = brdf::io::read_samples("in_plane.csv");
//     for (const std::string& loss : brdf::io::astm::write("in_plane.astm", table))
//       std::printf("lost: %s\n", loss.c_str());
//     const auto again = brdf::io::astm::read(brdf::io::read_content("in_plane.astm"), {});
std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io::astm
