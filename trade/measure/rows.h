// The input of a kernel for one point: a row, which is a struct of numbers. Points are stored column by
// column, with a column per number in the order of the struct.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <vector>

#include "brdf/vec3.h"

namespace brdf::trade {

// A pair of directions, and the quantities that a question varies with them.
template <class T>
struct DirectionRow {
  Vec3<T> wi, wo;
  T width{}, f0{};  // width: alpha, an exponent or sigma
};
// A cosine to the normal, or of a lobe, with alpha or the exponent.
template <class T>
struct CosineRow {
  T cosine, width{}, f0{};
};
template <class T>
struct FresnelRow {
  T cosine, n, k{}, f0{}, dip{};  // n + ik, or eta; dip: Hoffman's factor at 82 degrees
};
template <class T>
struct AngleRow {
  T theta, alpha;  // theta in degrees
};
// The arguments of an elementary function.
template <class T>
struct ArgumentRow {
  T x, y{};
};

template <template <class> class R>
inline constexpr std::size_t kFields = sizeof(R<double>) / sizeof(double);

// Returns the row with at(k) as its k-th number.
template <template <class> class R, class T, class At>
constexpr R<T> row_from(At at) {
  return [&]<std::size_t... k>(std::index_sequence<k...>) {
    return R<T>{at(k)...};
  }(std::make_index_sequence<kFields<R>>{});
}

// Returns the numbers of a row, in order.
template <template <class> class R, class T>
constexpr std::array<T, kFields<R>> fields_of(const R<T>& row) {
  return std::bit_cast<std::array<T, kFields<R>>>(row);
}

// Points as structure of arrays: columns[field][point].
template <class T>
using Columns = std::vector<std::vector<T>>;

template <template <class> class R, class T>
R<T> row_at(const Columns<T>& columns, std::size_t point) {
  return row_from<R, T>([&](std::size_t k) { return columns[k][point]; });
}

template <class Numbers>
void append(Columns<double>& columns, const Numbers& row) {
  columns.resize(row.size());
  for (std::size_t k = 0; k < row.size(); ++k) columns[k].push_back(row[k]);
}

inline std::size_t count_of(const Columns<double>& columns) {
  return columns.empty() ? 0 : columns[0].size();
}

}  // namespace brdf::trade
