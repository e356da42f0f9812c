#include "io/columns/metadata_names.h"

#include <algorithm>
#include <string>
#include <vector>

#include "io/columns/angle_names.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// A name with one of these words holds no values.
constexpr std::string_view kYes[] = {
    "temperature", "temp",      "humidity", "rh",        "pressure",    "time",      "date",
    "timestamp",   "datetime",  "exposure", "gain",      "integration", "shutter",   "polariser",
    "polarizer",   "analyser",  "analyzer", "waveplate", "remark",      "remarks",   "comment",
    "comments",    "note",      "notes",    "operator",  "user",        "file",      "filename",
    "filepath",    "path",      "lamp",     "bandwidth", "fwhm",        "serial",    "repeat",
    "repetition",  "replicate", "aperture", "distance",  "snr",         "bemerkung", "kommentar",
    "temperatur",  "uhrzeit",   "datum",    "averages",  "scans",       "unnamed",   "solid"};
// A name that consists only of these words may hold no values.
constexpr std::string_view kPerhaps[] = {
    "point",  "number", "no",      "nr",   "num",   "run",    "sample", "spot",        "position",
    "pos",    "x",      "y",       "z",    "row",   "line",   "record", "scan",        "step",
    "status", "flag",   "quality", "name", "label", "id",     "index",  "measurement", "count",
    "of",     "weight", "stage",   "n",    "reps",  "repeats"};

// Returns the words of a name in small letters. Words are separated by characters other than letters, and
// before a capital after a small letter.
std::vector<std::string> name_words(std::string_view name) {
  std::vector<std::string> words;
  bool goes_on = false;
  for (std::size_t k = 0; k < name.size(); ++k) {
    const char c = name[k];
    const bool is_capital = c >= 'A' && c <= 'Z';
    const bool is_letter = is_capital || (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
    const bool after_small = k > 0 && name[k - 1] >= 'a' && name[k - 1] <= 'z';
    if (is_letter && (!goes_on || (is_capital && after_small))) words.emplace_back();
    if (is_letter) words.back() += c;
    goes_on = is_letter;
  }
  for (std::string& word : words) word = lower_case(word);
  return words;
}

template <std::size_t n>
bool is_in(const std::string& word, const std::string_view (&list)[n]) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

}  // namespace

namespace {

// Returns whether the name is an angle's, whichever angle it is: theta_h, phi_d, tilt angle.
bool is_an_angle(std::string_view name) {
  const std::string key = plain_spelling(name);
  for (const char* word : {"theta", "phi", "zenith", "angle"})
    if (key.starts_with(word)) return true;
  return key.ends_with("angle") || is_like_azimuth(name);
}

}  // namespace

NoValues holds_no_values(std::string_view name) {
  if (is_an_angle(name)) return NoValues::yes;
  // Degrees and angles of polarisation.
  constexpr std::string_view kPolarisation[] = {"dop", "dolp", "docp", "dlp", "aop", "aolp"};
  if (is_in(plain_spelling(name), kPolarisation)) return NoValues::yes;
  const std::vector<std::string> words = name_words(name);
  if (std::ranges::any_of(words, [](const auto& word) { return is_in(word, kYes); })) return NoValues::yes;
  const bool is_plain = std::ranges::all_of(words, [](const auto& word) { return is_in(word, kPerhaps); });
  const bool has_number = name.find_first_of("0123456789") != name.npos;
  return is_plain && !words.empty() && !has_number ? NoValues::perhaps : NoValues::no;
}

bool is_rotation_name(std::string_view bare_name) {
  constexpr std::string_view kNames[] = {"rotation",           "samplerotation",
                                         "rotationangle",      "samplerotationangle",
                                         "rotationofsample",   "turn",
                                         "sampleturn",         "psi",
                                         "sampleazimuth",      "sampleazimuthangle",
                                         "turntable",          "turntableangle",
                                         "samplephi",          "rot",
                                         "samplerot",          "sampleturnangle",
                                         "rotationofthesample"};
  return is_in(plain_spelling(bare_name), kNames);
}

}  // namespace brdf::io
