// One number of a parameter's table, by hand.
#pragma once

#include <optional>
#include <string>

#include "brdf/parameter.h"

namespace brdf::render {

struct SliderMarks {
  std::optional<double> in_file;                   // the value that the file has
  std::optional<std::pair<double, double>> known;  // the interval of the fit
};

// From the table's minimum to what is usual, and past the value where that is larger. Ctrl-click types a
// number, within the table's range; right-click offers the default and the file's value. True when the value
// was changed.
bool parameter_slider(const std::string& label, const ParameterInfo& parameter, double& value,
                      const SliderMarks& marks);

}  // namespace brdf::render
