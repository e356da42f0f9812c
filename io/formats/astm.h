// ASTM E1392 text as scatterometers write it: keyword lines, a line
// `VARS theta_i,phi_i,theta_s,phi_s,<channel>...`, then comma-separated rows.
#pragma once

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io::astm {

bool recognises(const Content& text);

// Angles are taken for radians where no polar angle exceeds pi/2 and no azimuth a whole turn, otherwise for
// degrees. Files exist whose VARS line omits the name of an angle: where the rows have one column more than
// names, the missing angle stands in its usual place; where they have as many, it is not in the file, and
// phi_i = 180 or phi_s = 0 degrees is assumed (the plane of incidence with the mirror direction at phi_s =
// 0). Either is said in the warnings. A keyword ANGLE_UNIT with `degrees` or `radians` decides where it
// stands, and is no comment; so does QUANTITY with a name of io/columns/quantities.h. A column sigma_CHANNEL
// is that channel's standard deviation.
SampleTable read(const Content& text, const Supplied& supplied);

// Writes what reads back to the same table: angles in degrees, which ANGLE_UNIT says, comments as keywords;
// QUANTITY f_r if a channel's name says another quantity. Returns what is lost, one phrase each: comments
// that are no keyword (free text, keys with blanks). Throws InputError where the table breaks a rule of
// tables, has no rows, or a channel's name that VARS cannot hold.
std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io::astm
