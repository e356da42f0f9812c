#include "io/formats/other_formats.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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
  if (holds(head, ".iwa")) return "is a document of Apple Numbers or Pages: export the sheet as CSV";
  if (holds(head, ".zgroup") || holds(head, ".zarray") || holds(head, "zarr.json"))
    return "is a Zarr store: write the table as CSV";
  if (holds(head, ".npy")) return "is an archive of NumPy arrays (.npz): write a table with numpy.savetxt";
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
      {"II*\0"sv, "is a picture (TIFF), not a table of samples"},
      {"MM\0*"sv, "is a picture (TIFF), not a table of samples"},
      {"GIF8"sv, "is a picture (GIF), not a table of samples"},
      {"#?R"sv, "is a picture of Radiance (.hdr, .pic), not a table of samples"},
      {"\x1f\x8b"sv, "is compressed: use `zcat FILE | brdf fit -`"},
      {"BZh"sv, "is compressed: use `bzcat FILE | brdf fit -`"},
      {"\xfd"
       "7zXZ"sv,
       "is compressed: use `xzcat FILE | brdf fit -`"},
      {"\x28\xb5\x2f\xfd"sv, "is compressed: use `zstdcat FILE | brdf fit -`"},
      {"7z\xbc\xaf"sv, "is an archive (7-Zip): unpack the archive and pass the table in it"},
      {"Rar!\x1a"sv, "is an archive (RAR): unpack the archive and pass the table in it"},
      {"PAR1"sv, "is a Parquet file: write the table as CSV"},
      {"ARROW1"sv, "is an Arrow or Feather file: write the table as CSV"},
      {"CDF\1"sv, "is a NetCDF file: write the table as CSV (ncdump shows its variables)"},
      {"CDF\2"sv, "is a NetCDF file: write the table as CSV (ncdump shows its variables)"},
      {"CDF\5"sv, "is a NetCDF file: write the table as CSV (ncdump shows its variables)"},
      {"SQLite format 3\0"sv, "is a database (SQLite): export the table as CSV"},
      {"\x80\x02"sv, "is a pickle of Python: write the table as CSV"},
      {"\x80\x03"sv, "is a pickle of Python: write the table as CSV"},
      {"\x80\x04"sv, "is a pickle of Python: write the table as CSV"},
      {"\x80\x05"sv, "is a pickle of Python: write the table as CSV"},
      {"{\\rtf"sv, "is a document (RTF): save the table as plain text"},
      {"%!PS"sv, "is PostScript: copy the table as text"},
      {"\0\0\0\x5a\0\0\0\x5a"sv,
       "is a MERL file in big-endian byte order, which is not read: swap the bytes of its integers and "
       "doubles"},
      {"%PDF"sv, "is a PDF: copy the table as text"},
      {"\x93NUMPY"sv, "is an array of NumPy: write it with numpy.savetxt and a header row"},
      {"MATLAB 7.3"sv, "is a MATLAB file: write the table with writetable, as CSV"},
      {"MATLAB 5.0"sv, "is a MATLAB file: write the table with writetable, as CSV"},
      {"\xff\xfe\0\0"sv, "is UTF-32 text: save it as UTF-8"},
      {"\0\0\xfe\xff"sv, "is UTF-32 text: save it as UTF-8"}};
  if (content.bytes.starts_with("PK\x03\x04"sv))
    throw InputError(content.name + ": " + archive(content.bytes));
  if (content.bytes.starts_with("\x89HDF"sv)) throw InputError(content.name + ": " + hdf5(content.bytes));
  for (const auto& [magic, what] : kKinds)
    if (content.bytes.starts_with(magic)) throw InputError(content.name + ": " + std::string(what));
}

// Returns the first lines of a text, without blanks at their ends.
std::vector<std::string_view> first_lines(std::string_view text, std::size_t count) {
  std::vector<std::string_view> lines;
  for (std::size_t at = 0; at < text.size() && lines.size() < count;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(trimmed(text.substr(at, end - at)));
    at = end + 1;
  }
  return lines;
}

bool is_whole(std::string_view text, double least, double most) {
  double number;
  return parse_number(text, number) && number >= least && number <= most && number == std::floor(number);
}

// EULUMDAT has one entry on each line, without keywords: the company, the kinds of the luminaire (1 to 3)
// and of its symmetry (0 to 4), the numbers and steps of the planes and of the angles, five lines of text,
// then the dimensions.
bool is_eulumdat(std::string_view text) {
  constexpr std::size_t kHeadLines = 26;
  const std::vector<std::string_view> lines = first_lines(text.substr(0, kHead), kHeadLines);
  double number;
  const auto is_number = [&](std::size_t k) { return parse_number(lines[k], number); };
  if (lines.size() < kHeadLines || is_number(0) || !is_whole(lines[1], 0, 3) || !is_whole(lines[2], 0, 4) ||
      !is_whole(lines[3], 1, 721) || !is_number(4) || !is_whole(lines[5], 1, 721) || !is_number(6))
    return false;
  for (std::size_t k = 12; k < 22; ++k)
    if (!is_number(k)) return false;
  return true;
}

// A data file of Radiance has the number of dimensions, for each dimension its first and last coordinate
// and the number of values along it, and then the values, as many as the product of these numbers.
bool is_radiance_data(std::string_view text) {
  constexpr double kMostDimensions = 6;
  std::vector<std::string_view> words;
  while (text.starts_with('#')) {
    const std::size_t end = text.find('\n');
    text.remove_prefix(std::min(end, text.size() - 1) + 1);
  }
  if (text.empty()) return false;
  split_blanks(first_lines(text.substr(0, kHead), 1).front(), words);
  if (words.size() != 1 || !is_whole(words[0], 1, kMostDimensions)) return false;
  double dimensions = 0, product = 1;
  parse_number(words[0], dimensions);
  const std::vector<std::string_view> lines =
      first_lines(text.substr(0, kHead), static_cast<std::size_t>(dimensions) + 1);
  for (std::size_t k = 1; k < lines.size(); ++k) {
    split_blanks(lines[k], words);
    double count = 0;
    if (words.size() != 3 || !is_whole(words[2], 1, 1e6) || !parse_number(words[2], count)) return false;
    product *= count;
  }
  const char* const end_of_head = lines.back().data() + lines.back().size();
  const std::string_view rest = text.substr(static_cast<std::size_t>(end_of_head - text.data()));
  std::size_t values = 0;
  bool is_inside = false;
  for (const char c : rest) {
    const bool is_blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    values += !is_blank && !is_inside;
    is_inside = !is_blank;
  }
  return lines.size() == dimensions + 1 && static_cast<double>(values) == product;
}

constexpr std::string_view kLuminaire =
    ", which describes the light of a luminaire, not a surface: `brdf` reads samples of surfaces";

// Files of optical and lighting programs without a reader, by their words.
std::string program_format(std::string_view text) {
  const std::string_view head = text.substr(0, kHead);
  const std::string unread = std::string(", which is not read: ") + std::string(kExportAsCsv);
  if (text.starts_with("IESNA") || text.starts_with("TILT=") || holds(head, "\nTILT="))
    return "is a photometric file of IES (LM-63)" + std::string(kLuminaire);
  if (is_eulumdat(text)) return "is a photometric file in EULUMDAT (.ldt)" + std::string(kLuminaire);
  if (is_radiance_data(text)) return "is a data file of Radiance (.dat)" + unread;
  if (text.starts_with("TracePro")) return "is a surface property of TracePro" + unread;
  const bool is_light_tools = holds(head, "ScatterRadial") && holds(head, "AOI") && holds(head, "Side");
  if (is_light_tools) return "is a BSDF of LightTools" + unread;
  return "";
}

// A function file of Radiance begins with a comment in braces and defines functions.
bool is_radiance_function(std::string_view text) {
  const std::size_t next = text.find_first_not_of(" \t\r\n", 1);
  return text.starts_with('{') && next != text.npos && text[next] != '"' && text[next] != '}' &&
         holds(text.substr(0, kHead), "=") && holds(text.substr(0, kHead), ";");
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
  const std::string instead = "), not a table of samples: " + std::string(kExportAsCsv);
  if (root == "CxF")
    return "is CxF (XML of colour instruments), which is not read: export reflectance factors for each "
           "wavelength and geometry (45as15) as CSV";
  if (root == "IESTM33-22" || root == "IESTM33-18")
    return "is a photometric file of IES (TM-33)" + std::string(kLuminaire);
  if (root != "WindowElement") return "is XML (root element " + shown(root) + instead;
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
  if (is_radiance_function(text))
    return std::string("is a function file of Radiance (.cal), which is not read: ") +
           std::string(kExportAsCsv);
  return program_format(text);
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
