#include "io/samples.h"

#include "io/alta.h"
#include "io/astm.h"
#include "io/csv.h"
#include "io/error.h"
#include "io/exr_stream.h"
#include "io/exr_table.h"
#include "io/material_file.h"
#include "io/merl.h"
#include "io/rgl.h"
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

// A saved state of the window: what it is, and of which forms the material is that it shows.
[[noreturn]] void refuse_view(const Content& text) {
  std::string forms;
  for (const Term& term : read_material(text).terms)
    forms += (forms.empty() ? "" : "+") + std::string(info(term.form).name);
  throw InputError(text.name +
                   ": is a saved state of `brdf view`, not a table of samples; it shows a material of " +
                   forms);
}

// Files of other kinds by their first bytes, and what to do with them.
void refuse_other_kinds(const Content& content) {
  using namespace std::string_view_literals;
  constexpr std::pair<std::string_view, std::string_view> kKinds[] = {
      {"\x89PNG"sv, "is a picture (PNG), not a table of samples"},
      {"\xff\xd8\xff"sv, "is a picture (JPEG), not a table of samples"},
      {"PK\x03\x04"sv, "is a spreadsheet (.xlsx, .ods) or another ZIP archive: export the sheet as CSV"},
      {"\xd0\xcf\x11\xe0"sv, "is an Excel workbook: export the sheet as CSV"},
      {"\x1f\x8b"sv, "is compressed: `zcat FILE | brdf fit /dev/stdin` reads what is in it"},
      {"%PDF"sv, "is a PDF: copy the table out of it as text"},
      {"\xff\xfe\0\0"sv, "is UTF-32 text: save it as UTF-8"},
      {"\0\0\xfe\xff"sv, "is UTF-32 text: save it as UTF-8"}};
  for (const auto& [magic, what] : kKinds)
    if (content.bytes.starts_with(magic)) throw InputError(content.name + ": " + std::string(what));
  const std::size_t first = content.bytes.find_first_not_of(" \t\r\n");
  if (first == content.bytes.npos) return;
  if (content.bytes[first] == '<')
    throw InputError(content.name + ": is a web page or XML, not a table of samples");
  constexpr std::string_view kFred = "type bsdf_data";
  if (lower_case(content.bytes.substr(first, kFred.size())) == kFred)
    throw InputError(
        content.name +
        ": is FRED's tabulated BSDF ('type bsdf_data'), of which no published file tells where its azimuths "
        "begin: export columns theta_i, phi_i, theta_o, phi_o and the value as CSV");
}

SampleTable read_text(Content text, bool need_values) {
  const std::size_t format = text.bytes.find("\"format\"");
  if (is_json(text) && format < 10 && text.bytes.substr(format, 30).find("brdf-view") != text.bytes.npos)
    refuse_view(text);
  if (is_json(text)) {
    const bool material = text.bytes.find("\"brdf-material\"") != text.bytes.npos;
    throw InputError(text.name +
                     (material ? ": is a material, not a table of samples; `brdf synth` measures materials"
                               : ": is JSON, not a table of samples"));
  }
  const std::string transcoded = make_utf8(text);
  SampleTable table = need_values && zemax::recognises(text)  ? zemax::read(text)
                      : need_values && astm::recognises(text) ? astm::read(text)
                      : need_values && alta::recognises(text) ? alta::read(text)
                                                              : read_csv(text, need_values);
  if (!transcoded.empty()) table.warnings.push_back(transcoded);
  return table;
}

}  // namespace

SampleTable read_samples(Content content) {
  refuse_other_kinds(content);
  SampleTable table = rgl::recognises(content)    ? rgl::read(content)
                      : merl::recognises(content) ? merl::read(content)
                      : is_exr(content)           ? read_exr_table(content)
                                                  : read_text(std::move(content), true);
  check_table(table);
  return table;
}

SampleTable read_directions(Content content) {
  refuse_other_kinds(content);
  SampleTable table = read_text(std::move(content), false);
  check_table(table);
  return table;
}

SampleTable read_samples(const std::filesystem::path& path) {
  return read_samples(read_content(path));
}

SampleTable read_directions(const std::filesystem::path& path) {
  return read_directions(read_content(path));
}

}  // namespace brdf::io
