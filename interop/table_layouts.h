// Layouts of lookup tables of the directional albedo, by the program that reads them.
#pragma once

#include <span>
#include <string_view>

namespace brdf::interop {

// The quantity along an axis, as a function of the coordinate t in 0..1.
enum class TableQuantity {
  cosine,          // of the viewing angle, t
  cosine_of_root,  // of the viewing angle, t^2: the axis is the root of the cosine
  roughness,       // t; alpha is t^2
  alpha            // t
};

// centres: texel i of n lies at (i + 1/2)/n. ends: at i/(n - 1), and the program shifts its coordinate by
// half a texel.
enum class TexelRule { centres, ends };

struct TableAxis {
  TableQuantity quantity;
  TexelRule rule;
  std::size_t size;
  bool descending = false;  // t falls with the texel's number
  double shift = 0;         // texels by which the values are computed beyond the place at which they are read

  // Returns the coordinate for which texel i is computed, at most 1, and the one at which it is read.
  double computed_at(std::size_t i) const;
  double read_at(std::size_t i) const;
};

// The numbers that the program's own tables hold.
enum class TableFormat { float32, half, bits16, bits10, bits8 };

struct TableLayout {
  std::string_view name;   // value of --table-layout
  std::string_view title;  // of the program
  TableAxis x, y;
  // False: scale and bias, albedo = f0 scale + bias. True: bias and white albedo, albedo = (1 - f0) bias +
  // f0 white.
  bool bias_first = false;
  TableFormat format = TableFormat::float32;
  std::string_view source;    // where the layout was read
  std::string_view supposed;  // what was not checked; "" for a layout that was read completely
};

// Returns all layouts; the first is this program's own.
std::span<const TableLayout> table_layouts();
// Returns the layout with this name, or null if there is no such layout.
const TableLayout* find_table_layout(std::string_view name);

// Returns the nearest number of the format, in the range 0 to 1 for whole numbers of bits.
double stored(double value, TableFormat format);
std::string_view name_of_format(TableFormat format);

}  // namespace brdf::interop
