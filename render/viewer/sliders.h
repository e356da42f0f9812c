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

}  // namespace brdf::render
