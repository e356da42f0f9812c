#include "cli/options/parameter_row.h"

#include <cmath>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/material/settings.h"

namespace brdf::cli {
namespace {

struct Range {
  std::string name;
  double first, last;
};

Range parse_range(const std::string& text) {
  const auto refuse = [&](const std::string& rule) -> InputError {
    return InputError("--over '" + text + "': " + rule);
  };
  const std::size_t equals = text.find('='), colon = text.find(':');
  if (equals == text.npos || equals == 0 || colon == text.npos || colon < equals)
    throw refuse("must be NAME=FIRST:LAST");
  Range range{std::string(io::trimmed(std::string_view(text).substr(0, equals))), 0, 0};
  const auto read = [&](std::string_view number, double& value) {
    if (!io::parse_number(io::trimmed(number), value) || !std::isfinite(value))
      throw refuse("'" + std::string(number) + "' is not a finite number");
  };
  read(std::string_view(text).substr(equals + 1, colon - equals - 1), range.first);
  read(std::string_view(text).substr(colon + 1), range.last);
  return range;
}

}  // namespace

std::vector<std::pair<std::string, Material>> parameter_row(const Material& material, const std::string& text,
                                                            int count) {
  const Range range = parse_range(text);
  const ParameterInfo parameter = io::parameter_named(material, range.name, "--over");
  for (const double value : {range.first, range.last})
    if (!(value >= parameter.min && value <= parameter.max))
      throw InputError("--over " + range.name + ": " + io::to_text(value) + " must be between " +
                       io::to_text(parameter.min) + " and " + io::to_text(parameter.max));
  const bool log = parameter.log_scale && range.first > 0 && range.last > 0;
  std::vector<std::pair<std::string, Material>> row;
  std::vector<double> row_values;
  for (int k = 0; k < count; ++k) {
    const double t = double(k) / double(count - 1);
    double value = log ? range.first * std::pow(range.last / range.first, t)
                       : range.first + (range.last - range.first) * t;
    if (k == count - 1) value = range.last;
    value = nearest_value(parameter, value);
    if (parameter.whole && k > 0 && row_values.back() == value) continue;
    row_values.push_back(value);
    Material at = material;
    io::apply_settings(at, {{range.name, {value}}});
    row.emplace_back(range.name + " " + io::short_number(value, 3), std::move(at));
  }
  return row;
}

}  // namespace brdf::cli
