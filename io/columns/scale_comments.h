// Recognises comments that give the values of a table a scale or a unit: "values in percent", "scale: 0.001",
// "units: degrees, percent". Such a comment is not a statement that is applied, but must not pass unnoticed.
#pragma once

#include "io/columns/comments.h"

namespace brdf::io {

// Returns whether a comment seems to say that the values are not the quantity itself: a percentage, a
// logarithm, a factor other than 1, a normalisation, or a unit other than 1/sr. A number with a unit, such as
// "humidity: 45 %", says nothing about the values.
bool is_about_scale(const Comment& comment);

}  // namespace brdf::io
