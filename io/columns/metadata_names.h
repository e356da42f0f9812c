// Columns that hold no values, by their names: times, temperatures, numbers of points, remarks.
#pragma once

#include <string_view>

namespace brdf::io {

enum class NoValues {
  no,       // nothing in the name says so
  perhaps,  // `x`, `run`, `point`: if the table has other columns of values
  yes       // temperature, time, remark
};
NoValues holds_no_values(std::string_view name);

// Whether the column holds the angle by which the sample was turned: `rotation`, `sample rotation`, `psi`.
bool is_rotation_name(std::string_view bare_name);

}  // namespace brdf::io
