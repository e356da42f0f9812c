// Tables of multi-angle instruments, whose geometries are names such as 45as15: in a column, or as the names
// of columns.
#include <algorithm>
#include <cmath>
#include <optional>

#include "io/columns/aspecular_names.h"
#include "io/columns/name_unit.h"
#include "io/columns/stated_quantity.h"
#include "io/columns/wavelengths.h"
#include "io/csv/dialect.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/samples/fill_values.h"
#include "io/samples/foreign_rows.h"
#include "io/samples/table_rules.h"
#include "io/samples/to_f_r.h"

namespace brdf::io::aspecular {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::size_t kMostGeometries = 1000;

bool is_comment(std::string_view line) {
  return line.empty() || line.starts_with('#') || lower_case(line).starts_with("sep=");
}

bool is_geometry_column(std::string_view name) {
  const std::string lower = lower_case(name);
  return lower == "geometry" || lower == "geometries" || lower == "angle" || lower == "measurement geometry";
}

// The layout of a header row: the column of geometries, or the columns that are geometries.
struct Layout {
  std::optional<std::size_t> geometry_column;
  std::vector<std::size_t> geometries;
};

Layout layout_of(const Fields& names) {
  Layout out;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (aspecular_geometry(names[k])) out.geometries.push_back(k);
  if (!out.geometries.empty()) return out;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (is_geometry_column(names[k])) out.geometry_column = k;
  return out;
}

class Reader {
 public:
  Reader(const Content& text, const Supplied& supplied)
      : lines_(text), quantities_(stated_by_option(supplied.quantity)) {
    table_.source = text.name;
    table_.format = "aspecular";
    refuse_mirror_side(text.name, supplied, "the names of geometries state it");
  }

  SampleTable read() {
    read_header();
    if (layout_.geometry_column)
      read_rows();
    else
      read_columns();
    rows_.finish();
    convert();
    table_.assume(
        "geometries such as 45as15 are read as incident angle 45 degrees and viewer 15 degrees from the "
        "mirror direction towards the normal");
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(lines_.where() + ": " + what); }

  bool next_line(std::string_view& line) {
    while (lines_.next(line)) {
      line = trimmed(line);
      if (dialect_.is_separator_line(line)) continue;
      if (line.starts_with('#')) read_comment(line.substr(1));
      if (!is_comment(line)) return true;
    }
    return false;
  }

  void read_comment(std::string_view text) {
    if (const auto words = quantity_in_comment(text))
      quantities_.add_comment(*words, lines_.line(), lines_.where());
    else
      keep_comment(table_, parse_comment(text));
  }

  void read_header() {
    std::string_view line;
    next_line(line);
    if (!dialect_.split_header(line, names_)) fail(std::string(kBadQuotation));
    for (const std::string_view name : names_) {
      name_text_.emplace_back(name);
      if (name.empty()) fail("a column has no name");
    }
    layout_ = layout_of(names_);
    if (layout_.geometries.size() > kMostGeometries) fail("more than 1000 geometries");
  }

  bool next_row() {
    std::string_view line;
    if (!next_line(line)) return false;
    if (!dialect_.split_row(line, fields_)) fail(std::string(kBadQuotation));
    if (fields_.size() != name_text_.size())
      fail(std::to_string(fields_.size()) + " columns, but the header has " +
           std::to_string(name_text_.size()));
    return true;
  }

  double number(std::size_t k) {
    double value;
    if (!dialect_.parse(fields_[k], value) || !std::isfinite(value))
      fail("column " + std::to_string(k + 1) + " (" + printable(name_text_[k]) + "): " + shown(fields_[k]) +
           " is not a finite number");
    return value;
  }

  AspecularGeometry geometry(std::string_view name) const {
    const auto found = aspecular_geometry(name);
    if (!found) fail(shown(name) + " is not a geometry such as 45as15");
    if (!found->fault.empty()) fail("the geometry " + shown(name) + " " + found->fault);
    return *found;
  }

  bool add(const AspecularGeometry& geometry) {
    table_.lines.push_back(static_cast<std::uint32_t>(lines_.line()));
    return rows_.add(geometry.light, 180, geometry.viewer, 0);
  }

  void add_channel(std::string_view name) {
    const NamedQuantity named = quantity_of_column(name);
    const bool is_stated = named.says == NamedQuantity::Says::quantity && named.quantity.kind;
    if (is_stated && named.quantity.kind->use == QuantityKind::Use::refused)
      fail("column " + shown(name) + " " + refusal_of(*named.quantity.kind));
    if (is_stated && named.quantity.kind->use == QuantityKind::Use::converted) named_ = named.quantity;
    table_.channels.push_back(with_band_unit(named.bare.empty() ? name : std::string_view(named.bare)));
    table_.values.emplace_back();
    table_.sigma.emplace_back();
  }

  // One row for each geometry; the other columns are channels.
  void read_rows() {
    const std::size_t of_geometry = *layout_.geometry_column;
    for (std::size_t k = 0; k < name_text_.size(); ++k)
      if (k != of_geometry) add_channel(name_text_[k]);
    if (table_.channels.empty()) fail("no column of values in addition to the geometry");
    while (next_row()) {
      add(geometry(fields_[of_geometry]));
      for (std::size_t k = 0, c = 0; k < fields_.size(); ++k)
        if (k != of_geometry) table_.values[c++].push_back(number(k));
    }
  }

  // One row for each wavelength, or a single row; the columns are geometries.
  void read_columns() {
    std::optional<std::size_t> of_bands;
    std::optional<Unit> unit;
    for (std::size_t k = 0; k < name_text_.size(); ++k) {
      const auto found = wavelength_column(name_text_[k]);
      if (!found) continue;
      if (!found->fault.empty()) fail("column " + shown(name_text_[k]) + " " + found->fault);
      of_bands = k;
      unit = found->unit;
    }
    for (std::size_t k = 0; k < name_text_.size(); ++k)
      if (k != of_bands && std::ranges::find(layout_.geometries, k) == layout_.geometries.end())
        fail("column " + shown(name_text_[k]) + " is neither a geometry nor the wavelength");
    for (const std::size_t k : layout_.geometries) add(geometry(name_text_[k]));
    std::vector<double> nm;
    while (next_row()) {
      if (!of_bands && !table_.values.empty()) fail("several rows need a column of wavelengths");
      if (of_bands) nm.push_back(number(*of_bands));
      if (table_.values.size() == kMostChannels)
        fail("more than " + std::to_string(kMostChannels) + " wavelengths");
      std::vector<double>& values = table_.values.emplace_back();
      table_.sigma.emplace_back();
      for (const std::size_t k : layout_.geometries) values.push_back(number(k));
    }
    if (table_.values.empty()) throw InputError(table_.source + ": has no rows");
    name_bands(nm, unit);
  }

  void name_bands(const std::vector<double>& numbers, const std::optional<Unit>& unit) {
    if (numbers.empty()) {
      table_.channels = {"fr"};
      return;
    }
    const bool is_micrometres = !unit && are_micrometres(*std::max_element(numbers.begin(), numbers.end()));
    for (const double number : numbers) {
      if (!(number > 0)) throw InputError(table_.source + ": wavelengths must be above 0");
      const double nm = unit             ? to_nm(number, *unit)
                        : is_micrometres ? without_noise(number * 1000)
                                         : without_noise(number);
      table_.channels.push_back(to_text(nm) + "nm");
    }
  }

  // Converts the values to f_r. Multi-angle instruments report reflectance factors.
  void convert() {
    const auto& stated = quantities_.result();
    if (stated || named_) {
      const Quantity quantity = stated ? stated->quantity : *named_;
      make_f_r(table_, std::vector<Quantity>(table_.channels.size(), quantity));
      if (!quantity.is_f_r())
        table_.assume("the values are " + quantity.meaning() + ": " + quantity.operation());
      return;
    }
    refuse_fill_values(table_);
    constexpr double kMostFactor = 5;  // above, the values may be percent
    double largest = 0;
    for (const auto& column : table_.values)
      for (const double value : column) largest = std::max(largest, value);
    if (largest > kMostFactor)
      throw InputError(
          table_.source + ": the values reach " + short_number(largest) +
          ": for reflectance factors give --quantity BRF, or --quantity 'BRF %' if they are in percent");
    make_f_r(table_, std::vector<Quantity>(table_.channels.size(), *quantity_named("BRF")));
    table_.assume(
        "the values are taken as reflectance factors, as multi-angle instruments report them: divided "
        "by pi (if not: --quantity)");
  }

  LineReader lines_;
  StatedQuantities quantities_;
  SampleTable table_;
  ForeignRows rows_{table_};
  Dialect dialect_;
  Fields names_, fields_;
  std::vector<std::string> name_text_;
  Layout layout_;
  std::optional<Quantity> named_;  // the quantity in the name of a column
};

}  // namespace

// Recognises a header row with geometries, or with a column `geometry` above a row with a geometry.
bool recognises(const Content& text) {
  LineReader reader(text);
  Dialect dialect;
  Fields names, fields;
  std::optional<Layout> layout;
  for (std::string_view line; reader.next(line);) {
    line = trimmed(line);
    if (dialect.is_separator_line(line) || is_comment(line)) continue;
    if (layout) {
      return dialect.split_row(line, fields) && *layout->geometry_column < fields.size() &&
             aspecular_geometry(fields[*layout->geometry_column]);
    }
    if (!dialect.split_header(line, names)) return false;
    layout = layout_of(names);
    if (!layout->geometries.empty()) return 2 * layout->geometries.size() >= names.size();
    if (!layout->geometry_column) return false;
  }
  return false;
}

SampleTable read(const Content& text, const Supplied& supplied) {
  return Reader(text, supplied).read();
}

}  // namespace brdf::io::aspecular
