#include "io/formats/other_formats.h"

#include <algorithm>
#include <utility>

#include "io/columns/foreign_json.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/files/xml.h"

namespace brdf::io {
namespace {

using namespace std::string_view_literals;

bool holds(std::string_view text, std::string_view part) {
  return text.find(part) != text.npos;
}

constexpr std::size_t kHead = 1 << 16;  // bytes that are searched

// Names a ZIP archive by the names of its first files.
std::string archive(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, kHead);
  if (holds(head, "opendocument.spreadsheet")) return "is a spreadsheet (.ods): export the sheet as CSV";
  if (holds(head, "[Content_Types].xml") || holds(head, "xl/"))
    return "is a spreadsheet or another document of Office (.xlsx): export the sheet as CSV";
  return "is a ZIP archive: unpack the archive and pass the table in it";
}

// AxF is stored as HDF5.
std::string hdf5(std::string_view bytes) {
  if (holds(bytes.substr(0, kHead), "com.xrite"))
    return "is an AxF file, which is not read: export the measured samples from the program of the "
           "instrument: "
           "columns theta_i, phi_i, theta_o, phi_o and the value as CSV";
  return "is an HDF5 file (AxF, NetCDF, MATLAB 7.3 and others), which is not read: export the table as CSV";
}

// Refuses formats that are recognised by their first bytes.
void refuse_by_magic(const Content& content) {
  constexpr std::pair<std::string_view, std::string_view> kKinds[] = {
      {"\x89PNG"sv, "is a picture (PNG), not a table of samples"},
      {"\xff\xd8\xff"sv, "is a picture (JPEG), not a table of samples"},
      {"\xd0\xcf\x11\xe0"sv, "is an Excel workbook (.xls): export the sheet as CSV"},
      {"\x09\x08\x10\x00"sv, "is an Excel workbook (.xls): export the sheet as CSV"},
      {"\x1f\x8b"sv, "is compressed: use `zcat FILE | brdf fit -`"},
      {"%PDF"sv, "is a PDF: copy the table as text"},
      {"\x93NUMPY"sv, "is an array of NumPy: write it with numpy.savetxt and a header row"},
      {"MATLAB 5.0"sv, "is a MATLAB file: write the table with writetable, as CSV"},
      {"\xff\xfe\0\0"sv, "is UTF-32 text: save it as UTF-8"},
      {"\0\0\xfe\xff"sv, "is UTF-32 text: save it as UTF-8"}};
  if (content.bytes.starts_with("PK\x03\x04"sv))
    throw InputError(content.name + ": " + archive(content.bytes));
  if (content.bytes.starts_with("\x89HDF"sv)) throw InputError(content.name + ": " + hdf5(content.bytes));
  for (const auto& [magic, what] : kKinds)
    if (content.bytes.starts_with(magic)) throw InputError(content.name + ": " + std::string(what));
}

// Returns an empty string for the text formats of Speos that are read. The first line is "OPTIS - brdf
// surface file v8.0", then 0 for text or 1 for binary.
std::string optis(std::string_view text) {
  const std::size_t end = text.find('\n');
  const std::string_view first = trimmed(text.substr(0, end));
  const std::string_view second = end == text.npos ? "" : trimmed(text.substr(end + 1, 8));
  const std::string lower = lower_case(first.substr(0, 100));
  const bool is_anisotropic = holds(lower, "anisotropic bsdf surface file");
  const std::string name = shown(first.substr(0, first.find('\r')));
  if (!is_anisotropic && !holds(lower, "brdf surface file"))
    return "is a file of Speos (" + name +
           ") other than a BRDF or anisotropic BSDF, which is not read: " + std::string(kExportAsCsv);
  if (!second.starts_with('1')) return "";
  return "is a binary " + std::string(is_anisotropic ? "anisotropic BSDF" : "BRDF") + " file of Speos (" +
         name + "), which is not read: save it as text in Speos' editor of surfaces";
}

std::string xml(std::string_view text) {
  const std::string_view root = xml_root(text);
  if (lower_case(root) == "html" ||
      lower_case(text.substr(0, 20)).find("<!doctype html") != std::string::npos)
    return "is a web page or XML, not a table of samples";
  const std::string_view head = text.substr(0, kHead);
  if (root == "Workbook" || (root == "document" && holds(head, "opendocument")))
    return "is a spreadsheet in XML (" + shown(root) + "): export the sheet as CSV";
  if (root != "WindowElement") return "is XML (root element " + shown(root) + "), not a table of samples";
  if (!holds(text, "TensorTree")) return "";
  return "is a BSDF of Radiance as a tensor tree, which is not read: export a matrix in a Klems basis "
         "(genBSDF without -t), or evaluate directions with bsdfquery and " +
         std::string(kExportAsCsv);
}

std::string text_format(std::string_view text) {
  const std::string lower = lower_case(text.substr(0, 200));
  if (text.starts_with('<')) return xml(text);
  if (lower.starts_with("optis")) return optis(text);
  if (lower.starts_with("version") && holds(lower, "data_type") && holds(lower, "color_model"))
    return std::string("is SSDD text of libbsdf, which is not read: ") + std::string(kExportAsCsv);
  if (lower.starts_with(";;") && holds(lower, "data"))
    return std::string("is a DDR or DDT file of libbsdf, which is not read: ") + std::string(kExportAsCsv);
  return "";
}

}  // namespace

void refuse_other_formats(const Content& content) {
  refuse_by_magic(content);
  const std::size_t first = content.bytes.find_first_not_of(" \t\r\n");
  if (first == content.bytes.npos) return;
  const std::string what = text_format(std::string_view(content.bytes).substr(first));
  if (!what.empty()) throw InputError(content.name + ": " + what);
}

}  // namespace brdf::io
