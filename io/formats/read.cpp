#include "io/formats/read.h"

#include "io/columns/foreign_json.h"
#include "io/columns/stated_quantity.h"
#include "io/csv/csv.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/formats/alta.h"
#include "io/formats/astm.h"
#include "io/formats/exr_stream.h"
#include "io/formats/exr_table.h"
#include "io/formats/merl.h"
#include "io/formats/other_formats.h"
#include "io/formats/rgl.h"
#include "io/formats/zemax.h"
#include "io/material/material_file.h"
#include "io/samples/repetition.h"
#include "io/samples/table_rules.h"

namespace brdf::io {
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
