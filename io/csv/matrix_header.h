// Tables of two angles as a matrix: one angle down the first column, the other along the header row.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "io/columns/column_names.h"
#include "io/csv/dialect.h"

namespace brdf::io {

struct MatrixHeader {
  Column rows, columns;        // the polar angles that go down and along; `index` says whose
  std::vector<double> angles;  // of the columns, as written
};

// Reads a header row whose first cell names one angle or two ("theta_s \ theta_i": down and along) and whose
// others are numbers up to a right angle. std::nullopt for other rows.
std::optional<MatrixHeader> matrix_header(const std::vector<std::string_view>& names, Dialect& dialect);

}  // namespace brdf::io
