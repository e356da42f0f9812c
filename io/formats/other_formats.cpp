#include "io/formats/other_formats.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "io/columns/foreign_json.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/files/xml.h"
#include "io/formats/program_formats.h"

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

// UTIA's BRDF has 6 polar angles and 48 azimuths of the light, and as many of the viewer.
constexpr std::uint32_t kUtiaWidth = 6 * 48;
constexpr std::string_view kUtia =
    ", which is not read: write its directions (theta 0 to 75 degrees in steps of 15, phi in steps of 7.5) "
    "and "
    "values as columns theta_i, phi_i, theta_o, phi_o, r, g, b of a CSV table";

// Returns whether the bytes are the three planes of UTIA's BRDF as numbers, which have no header.
template <class Number>
bool are_planes_of_utia(std::string_view bytes) {
  constexpr std::size_t kNumbers = std::size_t{3} * kUtiaWidth * kUtiaWidth;
  if (bytes.size() != kNumbers * sizeof(Number)) return false;
  constexpr std::size_t kStep = 17;
  constexpr Number kLargest = 1e5;
  bool is_above_0 = false;
  for (std::size_t k = 0; k < kNumbers; k += kStep) {
    Number number;
    std::memcpy(&number, bytes.data() + k * sizeof(Number), sizeof(Number));
    if (!(std::abs(number) <= kLargest)) return false;
    is_above_0 = is_above_0 || number > Number(1e-9);
  }
  return is_above_0;
}

// Reads an integer of 4 bytes.
std::uint32_t integer_at(std::string_view bytes, std::size_t at, bool is_big) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value |= std::uint32_t(static_cast<unsigned char>(bytes[at + k])) << (8 * (is_big ? 3 - k : k));
  return value;
}

// Describes the files of UTIA's database; returns an empty string for other files.
std::string utia(std::string_view bytes) {
  if (are_planes_of_utia<double>(bytes) || are_planes_of_utia<float>(bytes))
    return "has the size of a binary BRDF of UTIA (3 x 288 x 288 numbers)" + std::string(kUtia);
  constexpr std::size_t kWidthOfPng = 16;  // the place of the width in a PNG
  const std::string advice = "of 288 x 288 pixels, the size of a BRDF of UTIA" + std::string(kUtia);
  if (bytes.starts_with("\x89PNG") && bytes.size() >= kWidthOfPng + 8 &&
      integer_at(bytes, kWidthOfPng, true) == kUtiaWidth &&
      integer_at(bytes, kWidthOfPng + 4, true) == kUtiaWidth)
    return "is a picture (PNG) " + advice;
  constexpr std::string_view kWindow = "dataWindow\0box2i\0\x10\0\0\0"sv;  // then four integers follow
  const std::string_view head = bytes.substr(0, kHead);
  const std::size_t window = head.find(kWindow);
  if (!bytes.starts_with("\x76\x2f\x31\x01") || window == head.npos ||
      window + kWindow.size() + 16 > bytes.size() || holds(head, "theta_i\0"sv))
    return "";
  const auto side = [&](std::size_t axis) {
    const std::size_t at = window + kWindow.size() + 4 * axis;
    return integer_at(bytes, at + 8, false) - integer_at(bytes, at, false) + 1;
  };
  return side(0) == kUtiaWidth && side(1) == kUtiaWidth ? "is a picture (OpenEXR) " + advice : "";
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
  if (const std::string name = utia(content.bytes); !name.empty())
    throw InputError(content.name + ": " + name);
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
