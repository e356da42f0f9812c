#include "io/formats/program_formats.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/columns/column_names.h"
#include "io/columns/foreign_json.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using Words = std::vector<std::string_view>;

bool has_part(std::string_view text, std::string_view part) {
  return text.find(part) != text.npos;
}

constexpr std::size_t kHeadOfText = 1 << 16;  // bytes that are searched

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

// Returns whether a line begins with this word. The words of another program within a line may be a comment
// or the name of a column in a table of samples.
bool begins_line(std::string_view text, std::string_view word) {
  return text.starts_with(word) || has_part(text, "\n" + std::string(word));
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
  const std::vector<std::string_view> lines = first_lines(text.substr(0, kHeadOfText), kHeadLines);
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
  split_blanks(first_lines(text.substr(0, kHeadOfText), 1).front(), words);
  if (words.size() != 1 || !is_whole(words[0], 1, kMostDimensions)) return false;
  double dimensions = 0, product = 1;
  parse_number(words[0], dimensions);
  const std::vector<std::string_view> lines =
      first_lines(text.substr(0, kHeadOfText), static_cast<std::size_t>(dimensions) + 1);
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

// A function file of Radiance begins with a comment in braces and defines functions.
bool is_radiance_function(std::string_view text) {
  const std::size_t next = text.find_first_not_of(" \t\r\n", 1);
  return text.starts_with('{') && next != text.npos && text[next] != '"' && text[next] != '}' &&
         has_part(text.substr(0, kHeadOfText), "=") && has_part(text.substr(0, kHeadOfText), ";");
}

constexpr std::size_t kLinesOfHeader = 60;

// Returns the parts between any of these characters, without empty parts.
Words parts_of(std::string_view line, std::string_view separators) {
  Words parts;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(separators, at), line.size());
    if (const std::string_view part = trimmed(line.substr(at, end - at)); !part.empty())
      parts.push_back(part);
    at = end + 1;
  }
  return parts;
}

bool is_header_of_samples(std::string_view line) {
  line = line.substr(std::min(line.size(), line.find_first_not_of("#%!/ ")));
  return names_angles(parts_of(line, ",;\t|")) || names_angles(parts_of(line, " ,;\t|"));
}

bool has_word(const Words& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

// Returns the lines that may name parameters of a model. A table of samples names its angles and has no such
// lines, because its comments may hold a fit of the model.
Words lines_of_parameters(std::string_view text) {
  Words lines = first_lines(text.substr(0, kHeadOfText), kLinesOfHeader);
  return std::ranges::any_of(lines, is_header_of_samples) ? Words() : lines;
}

// Coefficients of the ABg model have A, B and g as the names of three columns or of three lines.
bool holds_abg(const Words& lines) {
  bool has_columns = false;
  Words names_of_lines;
  for (const std::string_view line : lines) {
    const Words words = parts_of(line, " ,;:=|()[]#%!/\t");
    has_columns = has_columns || (has_word(words, "A") && has_word(words, "B") && has_word(words, "g"));
    double number;
    if (words.size() >= 2 && words[0].size() == 1 && parse_number(words[1], number))
      names_of_lines.push_back(words[0]);
  }
  return has_columns ||
         (has_word(names_of_lines, "A") && has_word(names_of_lines, "B") && has_word(names_of_lines, "g"));
}

// Returns whether these lines name each of these quantities.
bool names_all(const Words& lines, std::initializer_list<std::string_view> quantities) {
  Words found;
  for (const std::string_view line : lines)
    for (const std::string_view word : parts_of(line, " ,;:=|()[]{}#%!/\t\"'")) found.push_back(word);
  return std::ranges::all_of(quantities, [&](std::string_view name) {
    return std::ranges::any_of(found, [&](std::string_view word) {
      std::string plain = lower_case(word);
      std::erase(plain, '_');
      return plain == name;
    });
  });
}

// The weights of the three kernels of MODIS' products (Lucht, Schaaf and Strahler 2000), by either of their
// names.
bool holds_kernel_weights(const Words& lines) {
  return names_all(lines, {"fiso", "fvol", "fgeo"}) || names_all(lines, {"iso", "vol", "geo"});
}

bool holds_harvey_shack(const Words& lines) {
  return std::ranges::any_of(lines,
                             [](std::string_view line) { return has_part(lower_case(line), "harvey"); }) ||
         names_all(lines, {"b0", "l", "s"});
}

// YAML begins with its mark, or consists of lines with a key; TOML has the names of its parts in brackets.
std::string_view settings_language(std::string_view text) {
  const std::vector<std::string_view> lines = first_lines(text.substr(0, kHeadOfText), kLinesOfHeader);
  const auto starts_with_key = [](std::string_view line, char mark) {
    const std::size_t end = line.find(mark);
    return end != line.npos && end > 0 &&
           line.substr(0, end).find_first_not_of(
               "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_- ") == line.npos;
  };
  std::size_t keys = 0, parts = 0, assigned = 0, filled = 0;
  for (const std::string_view line : lines) {
    if (line.empty() || line.starts_with('#')) continue;
    ++filled;
    const std::string_view entry = line.starts_with("- ") ? line.substr(2) : line;
    keys += starts_with_key(entry, ':') || line.starts_with("- ");
    parts += line.starts_with('[') && line.ends_with(']') && line.find(',') == line.npos;
    assigned += starts_with_key(line, '=');
  }
  if (!lines.empty() && (lines[0] == "---" || lines[0].starts_with("%YAML"))) return "YAML";
  if (filled >= 3 && keys == filled) return "YAML";
  return parts > 0 && assigned > 0 && parts + assigned == filled ? "TOML" : "";
}

bool refers_to_e2387(std::string_view text) {
  std::string head = lower_case(text.substr(0, kHeadOfText));
  std::erase_if(head, [](char c) { return c == ' ' || c == '-' || c == '_'; });
  return has_part(head, "e2387");
}

}  // namespace

std::string program_format(std::string_view text) {
  const std::string_view head = text.substr(0, kHeadOfText);
  const std::string unread = std::string(", which is not read: ") + std::string(kExportAsCsv);
  if (text.starts_with("IESNA") || begins_line(head, "TILT="))
    return "is a photometric file of IES (LM-63)" + std::string(kLuminaire);
  if (is_eulumdat(text)) return "is a photometric file in EULUMDAT (.ldt)" + std::string(kLuminaire);
  if (is_radiance_data(text)) return "is a data file of Radiance (.dat)" + unread;
  if (text.starts_with("TracePro")) return "is a surface property of TracePro" + unread;
  const bool is_light_tools =
      begins_line(head, "ScatterRadial") && begins_line(head, "AOI") && begins_line(head, "Side");
  if (is_light_tools) return "is a BSDF of LightTools" + unread;
  if (is_radiance_function(text)) return "is a function file of Radiance (.cal)" + unread;
  constexpr std::size_t kHeadOfSpectrum = 400;
  const std::string start = lower_case(text.substr(0, kHeadOfSpectrum));
  const std::string spectrum =
      ", which has no directions: a spectrum alone is no BRDF; " + std::string(kExportAsCsv);
  if (start.starts_with("##title") || begins_line(start, "##jcamp-dx"))
    return "is a spectrum in JCAMP-DX" + spectrum;
  if (start.starts_with("pe ") && has_part(start, "peds"))
    return "is a spectrum of PerkinElmer (ASCII)" + spectrum;
  if (start.starts_with("netcdf ") && has_part(start, "{"))
    return "is CDL, the text of a NetCDF file, which is not read: write the table as CSV";
  return "";
}

std::string advice_on_text(std::string_view text) {
  const Words lines = lines_of_parameters(text);
  if (holds_abg(lines))
    return "holds coefficients of the ABg model of scatter (A, B, g), which are not read: export "
           "the "
           "measured BSDF, or compute A/(B + |sin(theta_o) - sin(theta_i)|^g) for pairs of directions, and " +
           std::string(kExportAsCsv);
  if (holds_harvey_shack(lines))
    return "holds parameters of Harvey and Shack's model of scatter, which are not read: export the measured "
           "BSDF, or "
           "compute b0 (1 + (|sin(theta_o) - sin(theta_i)|/L)^2)^(s/2) for pairs of directions, and " +
           std::string(kExportAsCsv);
  if (holds_kernel_weights(lines))
    return "holds weights of the kernels of MODIS' BRDF products, a formula and no samples, which are not "
           "read: compute "
           "the reflectance factor for pairs of directions, and " +
           std::string(kExportAsCsv);
  if (const std::string_view language = settings_language(text); !language.empty())
    return "looks like " + std::string(language) + ", which is not read: " + std::string(kExportAsCsv);
  if (refers_to_e2387(text))
    return "refers to ASTM E2387, which gives no layout of files: " + std::string(kExportAsCsv) +
           ", or describe the table by a layout (`brdf describe-table FILE` proposes one)";
  return "";
}

}  // namespace brdf::io
