#include "io/formats/read.h"

#include <span>

#include "io/columns/foreign_json.h"
#include "io/csv/csv.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/formats/other_formats.h"
#include "io/formats/program_formats.h"
#include "io/material/material_file.h"
#include "io/samples/repetition.h"
#include "io/samples/table_rules.h"

// The formats, in the order in which they are tried. To add a format, write a file with these two functions
// in a namespace of the format's name, and add this name to one of the three lists. Readers of JSON and of
// text receive UTF-8.
#define BRDF_FORMATS_OF_BYTES(FORMAT) FORMAT(rgl) FORMAT(merl) FORMAT(exr)
#define BRDF_FORMATS_OF_JSON(FORMAT) FORMAT(openmaterial) FORMAT(bird) FORMAT(early_bird)
#define BRDF_FORMATS_OF_TEXT(FORMAT) \
  FORMAT(klems)                      \
  FORMAT(zemax)                      \
  FORMAT(astm)                       \
  FORMAT(alta)                       \
  FORMAT(fred)                       \
  FORMAT(cornell)                    \
  FORMAT(speos)                      \
  FORMAT(aspecular)

#define BRDF_FUNCTIONS(name)                                          \
  namespace brdf::io::name {                                          \
  bool recognises(const Content& content);                            \
  SampleTable read(const Content& content, const Supplied& supplied); \
  }
BRDF_FORMATS_OF_BYTES(BRDF_FUNCTIONS)
BRDF_FORMATS_OF_JSON(BRDF_FUNCTIONS)
BRDF_FORMATS_OF_TEXT(BRDF_FUNCTIONS)
#undef BRDF_FUNCTIONS

namespace brdf::io {
namespace {

// Refuses a saved state of the window. The message names the forms of the material that the window shows.
[[noreturn]] void refuse_view(const Content& text) {
  std::string forms;
  for (const Term& term : read_material(text).terms)
    forms += (forms.empty() ? "" : "+") + std::string(info(term.form).name);
  throw InputError(
      text.name +
      ": is a saved state of `brdf view`, not a table of samples; the state shows a material of " + forms);
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
    throw InputError(
        text.name +
        ": is a material, not a table of samples; use `brdf synth` to compute samples of a material");
  const std::string foreign = foreign_json(text);
  throw InputError(text.name + ": " + (foreign.empty() ? "is JSON, not a table of samples" : foreign));
}

// Removes the byte order mark of UTF-8, so that every format is recognised behind it.
void drop_mark(Content& content) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (content.bytes.starts_with(kMark)) content.bytes.erase(0, kMark.size());
}

struct Format {
  const char* name;
  bool (*recognises)(const Content&);
  SampleTable (*read)(const Content&, const Supplied&);
};
#define BRDF_ROW(name) {#name, name::recognises, name::read},
constexpr Format kOfBytes[] = {BRDF_FORMATS_OF_BYTES(BRDF_ROW)};
constexpr Format kOfJson[] = {BRDF_FORMATS_OF_JSON(BRDF_ROW)};
constexpr Format kOfText[] = {BRDF_FORMATS_OF_TEXT(BRDF_ROW)};
#undef BRDF_ROW

const Format* format_of(std::span<const Format> formats, const Content& content) {
  for (const Format& format : formats)
    if (format.recognises(content)) return &format;
  return nullptr;
}

// Refuses a layout for a file that is not a table of columns of text.
void refuse_layout(const Content& content, const std::string& format, const Supplied& supplied) {
  if (!supplied.layout.empty())
    throw InputError(content.name + ": --layout applies to tables of columns of text, and this file is " +
                     format + ": leave --layout out");
}

// Reads a table by a layout. The message of a refusal names the format of text that the file is in, if any.
SampleTable read_by_layout(const Content& text, const Supplied& supplied) {
  try {
    return read_csv(text, true, supplied);
  } catch (const InputError& error) {
    const Format* const format = format_of(kOfText, text);
    if (!format) throw;
    throw InputError(std::string(error.what()) + "; the file is in the format " + format->name +
                     ", whose reader needs no layout: leave --layout out");
  }
}

// Texts of other programs are read value by value, several times slower than CSV.
void check_size(const Content& text) {
  constexpr std::size_t kLargestForeign = std::size_t{1} << 27;  // bytes
  if (text.bytes.size() > kLargestForeign)
    throw InputError(text.name + ": is larger than " + std::to_string(kLargestForeign >> 20) +
                     " MiB, the limit of formats of other programs; CSV may be larger");
}

// Reads a table of columns. The message of a refusal begins with the advice on the text, if any.
SampleTable read_columns(const Content& text, bool need_values, const Supplied& supplied) {
  try {
    return read_csv(text, need_values, supplied);
  } catch (const ExchangedColumns&) {
    throw;
  } catch (const InputError& error) {
    const std::string advice = advice_on_text(text.bytes);
    if (advice.empty()) throw;
    throw InputError(text.name + ": " + advice + " (as a table of columns: " + error.what() + ")");
  }
}

SampleTable read_text(Content text, bool need_values, const Supplied& supplied) {
  const std::string transcoded = make_utf8(text);
  // JSON is tried apart from other text, because a document of one line may exceed the limit of lines.
  const bool is_any_json = is_json(text) || is_json_array(text);
  if (is_any_json) refuse_layout(text, "JSON", supplied);
  // A layout takes precedence over the formats of text, which resemble tables of columns.
  const bool has_layout = !supplied.layout.empty();
  const Format* const format = !need_values || has_layout ? nullptr
                               : is_any_json              ? format_of(kOfJson, text)
                                                          : format_of(kOfText, text);
  if (!format && is_any_json) refuse_json(text);
  if (format) check_size(text);
  SampleTable table = format       ? format->read(text, supplied)
                      : has_layout ? read_by_layout(text, supplied)
                                   : read_columns(text, need_values, supplied);
  if (!transcoded.empty()) table.warnings.push_back(transcoded);
  return table;
}

}  // namespace

SampleTable read_samples(Content content, const Supplied& supplied) {
  drop_mark(content);
  refuse_other_formats(content);
  const Format* const format = format_of(kOfBytes, content);
  if (format) refuse_layout(content, format->name, supplied);
  SampleTable table =
      format ? format->read(content, supplied) : read_text(std::move(content), true, supplied);
  if (!supplied.matrix.empty() && table.format != "klems")
    throw InputError(table.name() + ": --matrix applies to Klems matrices (XML), but the file is " +
                     table.format);
  leave_out_repetitions(table);
  check_table(table);
  return table;
}

std::string format_name(Content content) {
  drop_mark(content);
  refuse_other_formats(content);
  const Format* format = format_of(kOfBytes, content);
  if (format) return format->name;
  make_utf8(content);
  const bool is_any_json = is_json(content) || is_json_array(content);
  format = is_any_json ? format_of(kOfJson, content) : format_of(kOfText, content);
  return format ? format->name : is_any_json ? "json" : "csv";
}

SampleTable read_directions(Content content) {
  drop_mark(content);
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
