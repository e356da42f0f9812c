// Recognises columns without values by their names: times, temperatures, numbers of points, remarks.
#pragma once

#include <string_view>

namespace brdf::io {

enum class NoValues {
  no,       // the name gives no such indication
  perhaps,  // `x`, `run`, `point`: only if the table has other columns of values
  yes       // temperature, time, remark
};
// Returns whether a column of this name holds no values.
NoValues holds_no_values(std::string_view name);

// Returns whether the column holds the angle by which the sample was rotated: `rotation`, `sample
// rotation`, `psi`.
bool is_rotation_name(std::string_view bare_name);

}  // namespace brdf::io
