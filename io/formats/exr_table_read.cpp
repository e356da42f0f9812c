#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "io/columns/plain_names.h"
#include "io/columns/stated_quantity.h"
#include "io/columns/supplied.h"
#include "io/columns/value_columns.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/formats/exr_stream.h"
#include "io/formats/exr_table.h"
#include "io/samples/to_f_r.h"

namespace brdf::io {
namespace {

// Returns the shortest decimal number that rounds to this float, as a double: 30.1 is restored as 30.1, not
// as 30.100000381.
double as_written(float value) {
  if (!std::isfinite(value)) return value;
  char text[64];
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
  double out = value;
  std::from_chars(text, end, out);
  return out;
}

struct Shape {
  std::size_t width, height;
  Imath::Box2i window;
};

// Upper bound of the compression factor. A header may claim any size; a size that no compression could
// reach with the bytes present is refused before memory is allocated.
constexpr std::size_t kMostDeflated = 4096;

Shape shape_of(const Imf::Header& header, std::size_t columns, const Content& content) {
  const std::string& name = content.name;
  const Imath::Box2i& window = header.dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1,
                     height = std::int64_t{window.max.y} - window.min.y + 1;
  constexpr auto kMost = static_cast<std::int64_t>(kMostRows + kExrTableWidth);
  if (width > kMost || height > kMost || width * height > kMost)
    throw InputError(name + ": has " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels; a table has at most " + std::to_string(kMostRows) + " rows, one per pixel");
  const Shape shape{static_cast<std::size_t>(width), static_cast<std::size_t>(height), window};
  if (shape.width * shape.height > kLargestFile / sizeof(float) / columns)
    throw InputError(name + ": its " + std::to_string(columns) + " columns of " +
                     std::to_string(shape.width * shape.height) + " numbers take more than " +
                     std::to_string(kLargestFile >> 30) + " GiB");
  if (shape.width * shape.height * columns * sizeof(float) > kMostDeflated * content.bytes.size())
    throw InputError(name + ": the file is too short for " + std::to_string(shape.width) + " x " +
                     std::to_string(shape.height) + " pixels of " + plural(columns, "channel"));
  return shape;
}

std::vector<std::string_view> fields_of(const std::string& text, char separator) {
  std::vector<std::string_view> fields;
  split(text, separator, fields);
  return fields;
}

// Returns the names in the table's order if the file records the order, otherwise in OpenEXR's alphabetical
// order.
std::vector<std::string> column_names(const Imf::Header& header, const std::string& file) {
  std::vector<std::string> names;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
    if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
      throw InputError(file + ": channel " + shown(c.name()) + " is subsampled");
    names.emplace_back(c.name());
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  if (!has_plain_angle_names(known))
    throw InputError(file + ": is an OpenEXR picture (channels " + joined(names) +
                     "), not a table of samples, which has channels theta_i, phi_i, theta_o, phi_o and "
                     "channels of values");
  if (const auto* order = header.findTypedAttribute<Imf::StringAttribute>(std::string(kExrColumns))) {
    const std::vector<std::string_view> listed = fields_of(order->value(), ',');
    std::ranges::stable_sort(
        names, {}, [&](const std::string& name) { return std::ranges::find(listed, name) - listed.begin(); });
  }
  return names;
}

bool is_ours(const Imf::Header& header) {
  return header.findTypedAttribute<Imf::StringAttribute>(std::string(kExrColumns)) != nullptr;
}

void add_comments(const Imf::Header& header, SampleTable& table, StatedQuantities& stated) {
  if (const auto* text = header.findTypedAttribute<Imf::StringAttribute>(std::string(kExrComments))) {
    for (const std::string_view line : fields_of(text->value(), '\n'))
      table.metadata.push_back(parse_comment(line));
    return;
  }
  for (auto a = header.begin(); a != header.end(); ++a) {
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute());
    std::string_view key = a.name();
    if (!text || key == kExrColumns) continue;
    if (lower_case(key) == kQuantityKey && !is_ours(header)) {
      stated.add_comment(text->value(), 0, table.source + ": attribute " + std::string(key));
      continue;
    }
    if (key.starts_with(kExrPrefix)) key.remove_prefix(kExrPrefix.size());
    table.add_comment(key, text->value());
  }
}

RawAngle raw_angle(const std::string& name, const std::vector<double>& cells) {
  RawMagnitudes magnitudes;
  for (const double cell : cells) magnitudes.add(cell);
  RawAngle angle{name};
  std::move(magnitudes).store(angle);
  return angle;
}

// Moves the columns to their places in the table by name. Columns of standard deviations are assigned to
// their channels.
void place_columns(const std::vector<std::string>& names, std::vector<std::vector<double>>& columns,
                   const HeaderFacts& facts, SampleTable& table) {
  std::vector<double>* const angles[] = {&table.theta_i, &table.phi_i, &table.theta_o, &table.phi_o};
  Columns header;
  for (const std::string& name : names) {
    header.columns.emplace_back().name = name;
    if (is_plain_angle_name(name)) header.columns.back().kind = Column::Kind::angle;
  }
  place_values(header, facts, [](std::string_view, const std::string&) {});
  table.set_channels(header.channels);
  if (table.channels.empty())
    throw InputError(table.source + ": has no channel of values in addition to the angles");
  for (const std::string& note : header.assumptions) table.assume(note);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Column& column = header.columns[k];
    if (column.kind == Column::Kind::angle) {
      const std::ptrdiff_t angle = std::ranges::find(kAngleNames, names[k]) - kAngleNames;
      table.raw_angles[static_cast<std::size_t>(angle)] = raw_angle(names[k], columns[k]);
      *angles[angle] = std::move(columns[k]);
    } else if (column.kind == Column::Kind::value) {
      table.values[column.index] = std::move(columns[k]);
    } else if (column.kind == Column::Kind::sigma) {
      table.sigma[column.index] = std::move(columns[k]);
    }
  }
  make_f_r(table, header.quantities);
}

// Leaves out pixels that are not rows: the filler of the last line, and all other pixels with a number that
// is not finite.
std::vector<std::size_t> rows_of(const std::vector<std::vector<float>>& planes, SampleTable& table) {
  const auto finite = [&](std::size_t pixel) {
    return std::ranges::all_of(planes, [&](const auto& plane) { return std::isfinite(plane[pixel]); });
  };
  const auto filler = [&](std::size_t pixel) {
    return std::ranges::all_of(planes, [&](const auto& plane) { return std::isnan(plane[pixel]); });
  };
  std::size_t last = planes[0].size();
  while (last > 0 && filler(last - 1)) --last;
  std::vector<std::size_t> rows;
  for (std::size_t pixel = 0; pixel < last; ++pixel)
    if (finite(pixel)) rows.push_back(pixel);
  table.skipped = last - rows.size();
  if (rows.empty()) throw InputError(table.source + ": holds no row of finite numbers");
  if (table.skipped > 0)
    table.warnings.push_back(std::to_string(table.skipped) + " of " + std::to_string(last) +
                             " pixels left out, because they have a value that is not finite");
  return rows;
}

SampleTable read_table(const Content& content, const Supplied& supplied) {
  ExrBytes bytes(content);
  Imf::InputFile file(bytes);
  SampleTable table;
  table.source = content.name;
  table.format = "exr";
  const std::vector<std::string> names = column_names(file.header(), content.name);
  const Shape shape = shape_of(file.header(), names.size(), content);
  std::vector planes(names.size(), std::vector<float>(shape.width * shape.height));
  Imf::FrameBuffer frame;
  for (std::size_t k = 0; k < names.size(); ++k)
    frame.insert(names[k], Imf::Slice::Make(Imf::FLOAT, planes[k].data(), shape.window));
  file.setFrameBuffer(frame);
  file.readPixels(shape.window.min.y, shape.window.max.y);
  const std::vector<std::size_t> rows = rows_of(planes, table);
  std::vector<std::vector<double>> columns(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    columns[k].reserve(rows.size());
    for (const std::size_t pixel : rows) columns[k].push_back(as_written(planes[k][pixel]));
    planes[k] = {};
  }
  StatedQuantities stated(stated_by_option(supplied.quantity));
  add_comments(file.header(), table, stated);
  HeaderFacts facts{content.name, stated.result()};
  facts.is_plain = true;
  facts.keeps_names = is_ours(file.header());
  if (facts.keeps_names && !facts.stated)
    facts.stated =
        StatedQuantity{StatedQuantity::By::comment, {&quantity_kinds()[0]}, "f_r", "attribute columns"};
  place_columns(names, columns, facts, table);
  refuse_mirror_side(content.name, supplied);
  return table;
}

}  // namespace
}  // namespace brdf::io

namespace brdf::io::exr {

bool recognises(const Content& content) {
  return is_exr(content);
}

SampleTable read(const Content& content, const Supplied& supplied) try {
  return read_table(content, supplied);
} catch (const InputError&) {
  throw;
} catch (const std::exception& error) {
  throw InputError(content.name + ": is not a readable OpenEXR table: " + error.what());
}

}  // namespace brdf::io::exr
