// Reads the header of a table of two angles in matrix form: one angle down the first column, the other
// along the header row.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "io/columns/column_names.h"
#include "io/csv/dialect.h"

namespace brdf::io {

struct MatrixHeader {
  Column rows, columns;        // the polar angles down and along; `index` identifies the angle
  std::vector<double> angles;  // angles of the columns, as written
  // An r-table of road lighting: the tangent of the angle of incidence down, the azimuth beta along (or the
  // reverse), for a viewer 1 degree above the road.
  bool is_road = false;
};

// Reads a header row in which the first cell names one angle or two ("theta_s \ theta_i": down and along)
// and the other cells are numbers up to a right angle. Returns std::nullopt for other rows.
std::optional<MatrixHeader> matrix_header(const std::vector<std::string_view>& names, Dialect& dialect);

}  // namespace brdf::io
