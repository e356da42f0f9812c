// A slider for one number of a parameter's table.
#pragma once

#include <optional>
#include <string>

#include "brdf/parameter.h"

namespace brdf::render {

struct SliderMarks {
  std::optional<double> in_file;                   // the value in the file
  std::optional<std::pair<double, double>> known;  // the confidence interval of the fit
};

// Draws a slider from the table's minimum to the usual maximum, and beyond the value if the value is
// larger. Ctrl-click permits typing a number within the table's range; right-click offers the default and
// the file's value. Returns true if the value was changed.
bool parameter_slider(const std::string& label, const ParameterInfo& parameter, double& value,
                      const SliderMarks& marks);

// Draws a slider for a number of the view, whose format may have a unit.
bool float_slider(const char* label, float& value, float low, float high, const char* format);

// Returns the number of spaces after (negative: before) a centred text with which the text does not lie over
// the knob of a slider. All widths in pixels; `knob`: the middle of the knob, from the slider's left end.
int spaces_beside_knob(float width, float knob, float knob_width, float text, float space);

}  // namespace brdf::render
