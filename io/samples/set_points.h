// Angles of instruments, recovered from numbers with few digits.
#pragma once

namespace brdf::io {

// Converts an angle that a file gives in radians with at least six decimals to degrees. An angle within the
// rounding of six decimals (3e-5 degrees) of a multiple of 0.001 degrees becomes this multiple: 0.523599 is
// 30 degrees and -3.141593 is -180 degrees. Other angles are converted exactly.
double degrees_of_printed_radians(double radians);

}  // namespace brdf::io
