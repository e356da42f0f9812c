// Interprets the columns of a table by a layout instead of by their names.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/columns/column_names.h"
#include "io/columns/layout.h"
#include "io/columns/stated_quantity.h"
#include "io/files/content.h"

namespace brdf::io {

// The columns of a header row by their names.
class ColumnPlaces {
 public:
  // The names must outlive this object.
  explicit ColumnPlaces(const std::vector<std::string_view>& names);
  // Returns the index of the column that an entry denotes, or std::nullopt if the table lacks the column, or
  // if several columns have the name. The entry must have a name or a position.
  std::optional<std::size_t> find(const LayoutColumn& entry) const;
  // Returns the number of columns with this name.
  std::size_t count(std::string_view name) const;
  // Returns the number of entries with a name or a position that are columns of the table.
  std::size_t count(const Layout& layout) const;

 private:
  struct Place {
    std::size_t first, count;
  };
  std::size_t width_;
  std::unordered_map<std::string_view, Place> by_name_;
};

// Returns the columns of a table. `names`: the header row; `where` opens messages about the header row.
// `stated`: the quantity that the file or the caller states, used if the layout states no quantity. Columns
// that the layout does not name are left aside with a note. Throws InputError if the table lacks a column
// of the layout, and if no quantity is stated.
Columns columns_by_layout(const Layout& layout, const std::vector<std::string_view>& names,
                          const std::optional<StatedQuantity>& stated, const std::string& where);

// Returns the layout that the caller supplies, or std::nullopt. Throws the errors of read_layout(), and
// InputError if the caller states a fact that the layout states, too. `name`: the table's file.
std::optional<Layout> layout_for(const std::string& name, const Supplied& supplied);

}  // namespace brdf::io
