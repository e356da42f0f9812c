#include "io/samples.h"

#include "io/alta.h"
#include "io/astm.h"
#include "io/csv.h"
#include "io/error.h"
#include "io/exr_stream.h"
#include "io/exr_table.h"
#include "io/material_file.h"
#include "io/merl.h"
#include "io/other_formats.h"
#include "io/repetition.h"
#include "io/rgl.h"
#include "io/stated_quantity.h"
#include "io/table_rules.h"
#include "io/text.h"
#include "io/zemax.h"

namespace brdf::io {

std::string SampleTable::where(std::size_t row) const {
  if (row < lines.size()) return name() + ", line " + std::to_string(lines[row]);
  return name() + ", row " + std::to_string(row + 1);
}

std::optional<std::string> SampleTable::find_metadata(std::string_view key) const {
  for (const auto& [name, value] : metadata)
    if (name == key) return value;
  return std::nullopt;
}

void SampleTable::assume(const std::string& sentence) {
  warnings.push_back(sentence);
  assumptions.push_back(sentence);
}

void SampleTable::add_comment(std::string_view key, std::string_view value) {
  metadata.push_back(parse_comment(comment_text({std::string(key), std::string(value)})));
}

void SampleTable::reserve(std::size_t rows) {
  for (auto* column : {&theta_i, &phi_i, &theta_o, &phi_o}) column->reserve(rows);
  for (auto& column : values) column.reserve(rows);
}

void SampleTable::add_directions(double theta_of_light, double phi_of_light, double theta_of_viewer,
                                 double phi_of_viewer) {
  theta_i.push_back(theta_of_light);
  phi_i.push_back(phi_of_light);
  theta_o.push_back(theta_of_viewer);
  phi_o.push_back(phi_of_viewer);
}

namespace {

// A table of a format that states f_r and its directions itself.
SampleTable of_f_r(SampleTable table, const Supplied& supplied) {
  const std::optional<StatedQuantity> stated = stated_by_option(supplied.quantity);
  if (stated && !stated->quantity.is_f_r())
    throw InputError(table.name() + ": --quantity " + stated->words + ": the format states f_r");
  if (supplied.mirror_side != MirrorSide::automatic)
    throw InputError(table.name() +
                     ": --mirror-side is for tables of two angles; this format states azimuths");
  return table;
}

// A saved state of the window: what it is, and of which forms the material is that it shows.
[[noreturn]] void refuse_view(const Content& text) {
  std::string forms;
  for (const Term& term : read_material(text).terms)
    forms += (forms.empty() ? "" : "+") + std::string(info(term.form).name);
  throw InputError(text.name +
                   ": is a saved state of `brdf view`, not a table of samples; it shows a material of " +
                   forms);
}

bool is_json_array(const Content& content) {
  const std::size_t first = content.bytes.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || content.bytes[first] != '[') return false;
  const std::size_t next = content.bytes.find_first_not_of(" \t\r\n", first + 1);
  return next != std::string::npos &&
         std::string_view("{[\"-0123456789").find(content.bytes[next]) != std::string::npos;
}

[[noreturn]] void refuse_json(const Content& text) {
  const std::size_t format = text.bytes.find("\"format\"");
  if (format < 10 && text.bytes.substr(format, 30).find("brdf-view") != text.bytes.npos) refuse_view(text);
  if (text.bytes.find("\"brdf-material\"") != text.bytes.npos)
    throw InputError(text.name + ": is a material, not a table of samples; `brdf synth` measures materials");
  const std::string foreign = foreign_json(text);
  throw InputError(text.name + ": " + (foreign.empty() ? "is JSON, not a table of samples" : foreign));
}

SampleTable read_text(Content text, bool need_values, const Supplied& supplied) {
  if (is_json(text) || is_json_array(text)) refuse_json(text);
  const std::string transcoded = make_utf8(text);
  SampleTable table = need_values && zemax::recognises(text)  ? of_f_r(zemax::read(text), supplied)
                      : need_values && astm::recognises(text) ? astm::read(text, supplied)
                      : need_values && alta::recognises(text) ? of_f_r(alta::read(text), supplied)
                                                              : read_csv(text, need_values, supplied);
  if (!transcoded.empty()) table.warnings.push_back(transcoded);
  return table;
}

}  // namespace

SampleTable read_samples(Content content, const Supplied& supplied) {
  refuse_other_formats(content);
  SampleTable table = rgl::recognises(content)    ? of_f_r(rgl::read(content), supplied)
                      : merl::recognises(content) ? of_f_r(merl::read(content), supplied)
                      : is_exr(content)           ? read_exr_table(content, supplied)
                                                  : read_text(std::move(content), true, supplied);
  leave_out_repetitions(table);
  check_table(table);
  return table;
}

SampleTable read_directions(Content content) {
  refuse_other_formats(content);
  SampleTable table = read_text(std::move(content), false, {});
  check_table(table);
  return table;
}

SampleTable read_samples(const std::filesystem::path& path, const Supplied& supplied) {
  return read_samples(read_content(path), supplied);
}

SampleTable read_directions(const std::filesystem::path& path) {
  return read_directions(read_content(path));
}

}  // namespace brdf::io
