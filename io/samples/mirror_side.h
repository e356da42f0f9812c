// Places tables of two signed angles in the plane of incidence.
#pragma once

#include "io/columns/supplied.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Adds azimuths to a table with signed polar angles. On entry the azimuths hold only the rotation of the
// sample. Adds the decision to the warnings and assumptions. If angles of the light are below 0, light and
// viewer share one scale: positive angles are at azimuth 0, negative angles at 180 degrees, and the mirror
// direction is at -theta_i. Otherwise the light is placed at 180 degrees and the mirror side at azimuth 0.
// The mirror side is `asked`; if that is automatic, the side of the largest values, judged for angles of
// incidence from 20 degrees on, or from 10 degrees on if the larger angles do not decide. If the values do
// not decide, positive angles are on the mirror side.
void place_in_plane(SampleTable& table, MirrorSide asked);

}  // namespace brdf::io
