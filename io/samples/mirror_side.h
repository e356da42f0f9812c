// Tables of two signed angles in the plane of incidence.
#pragma once

#include "io/columns/supplied.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Gives the directions of a table their azimuths, whose polar angles are signed and whose azimuths hold the
// turn of the sample alone: the light stands at 180 degrees, the mirror side at 0. Angles of the light below
// 0 are on one scale with the viewer's, so that the mirror direction is at -theta_i. Otherwise the mirror
// side is the one that is asked for, or the side of the largest values of lights from 20 degrees on, or, if
// these do not tell, that of positive angles. The decision is added to the warnings.
void place_in_plane(SampleTable& table, MirrorSide asked);

}  // namespace brdf::io
