#include "io/columns/layout.h"

#include <algorithm>
#include <map>

#include "io/columns/layout_unsure.h"
#include "io/columns/wavelengths.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/limits.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using Keys = std::initializer_list<std::string_view>;

bool is_polar(Meaning is) {
  return is == Meaning::theta_i || is == Meaning::theta_o;
}

bool is_azimuth(Meaning is) {
  return is == Meaning::phi_i || is == Meaning::phi_o;
}

bool may_be_constant(Meaning is) {
  return is_polar(is) || is_azimuth(is) || is == Meaning::wavelength || is == Meaning::rotation;
}

// Returns the keys that have an effect on an entry of this meaning, in addition to `is` and to the place.
std::vector<std::string_view> keys_of(Meaning is) {
  switch (is) {
    case Meaning::theta_i:
    case Meaning::theta_o:
      return {"unit", "from"};
    case Meaning::phi_i:
    case Meaning::phi_o:
    case Meaning::phase:
    case Meaning::rotation:
    case Meaning::wavelength:
      return {"unit"};
    case Meaning::value:
      return {"channel", "quantity"};
    case Meaning::sigma:
      return {"of", "coverage", "relative"};
    case Meaning::polarisation:
    case Meaning::ignored:
      break;
  }
  return {};
}

class LayoutReader {
 public:
  LayoutReader(const Json& json, const std::string& file) : root_(json, file) { out_.file = file; }

  Layout read() {
    root_.allow_keys({"format", "version", "separator", "decimal", "comment", "header", "quantity",
                      "mirror_side", "mirror_azimuth", "fill", "aperture", "columns", "unsure"});
    if (root_.at("format").text() != "brdf-layout") root_.at("format").fail("must be \"brdf-layout\"");
    if (root_.at("version").number() != 1) root_.at("version").fail("must be 1");
    const UnsurePlaces unsure(root_);
    unsure.refuse_nulls();
    out_.guesses = unsure.guesses();
    read_notation();
    const JsonPlace columns = root_.at("columns");
    if (columns.size() > kMostLayoutEntries)
      fail("$.columns", std::to_string(columns.size()) + " entries exceed the limit of " +
                            std::to_string(kMostLayoutEntries));
    for (std::size_t k = 0; k < columns.size(); ++k) out_.columns.push_back(entry(columns.at(k)));
    check_columns();
    check_values();
    read_facts();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const std::string& path, const std::string& rule) const {
    throw InputError(out_.file + ": " + path + ": " + rule);
  }

  // Refuses a key that changes nothing.
  void refuse_without_effect(std::string_view key, const std::string& why) const {
    if (root_.has(key)) root_.at(key).fail("has no effect: " + why + "; remove the key");
  }

  void read_notation() {
    if (root_.has("separator")) {
      const JsonPlace place = root_.at("separator");
      const std::string text = place.text();
      if (text == "tab") out_.separator = '\t';
      if (text == "blanks") out_.separator = ' ';
      if (text == "," || text == ";" || text == "|" || text == ":") out_.separator = text[0];
      if (!out_.separator) place.fail("must be \",\", \";\", \"|\", \":\", \"tab\" or \"blanks\"");
    }
    if (root_.has("decimal")) {
      const JsonPlace place = root_.at("decimal");
      const std::string text = place.text();
      if (text != "." && text != ",") place.fail("must be \".\" or \",\"");
      out_.decimal = text[0];
    }
    if (root_.has("comment")) {
      const JsonPlace place = root_.at("comment");
      out_.comment = place.text();
      constexpr std::size_t kLongest = 8;
      if (trimmed(out_.comment) != out_.comment || out_.comment.empty() || out_.comment.size() > kLongest)
        place.fail("must be the 1 to 8 characters that open a comment line, without blanks at the ends");
    }
    constexpr double kLastLine = 1e6;
    if (root_.has("header")) out_.header = std::size_t(root_.at("header").whole(0, kLastLine));
  }

  LayoutColumn entry(const JsonPlace& place) const {
    LayoutColumn column;
    column.path = place.path();
    place.allow_keys({"name", "position", "constant", "is", "unit", "from", "channel", "quantity", "of",
                      "coverage", "relative"});
    column.is = place.at("is").named<Meaning>();
    read_place(place, column);
    const std::vector<std::string_view> keys = keys_of(column.is);
    for (const std::string_view key : {"unit", "from", "channel", "quantity", "of", "coverage", "relative"})
      if (place.has(key) && std::ranges::find(keys, key) == keys.end())
        place.at(key).fail("has no effect on an entry that is " + std::string(name_of(column.is)) +
                           "; remove the key");
    if (column.is == Meaning::value || column.is == Meaning::sigma)
      read_value(place, column);
    else
      read_unit(place, column);
    if (place.has("from")) column.from = place.at("from").named<From>();
    return column;
  }

  void read_place(const JsonPlace& place, LayoutColumn& column) const {
    if (place.has("name") + place.has("position") + place.has("constant") != 1)
      place.fail("must have exactly one of \"name\", \"position\" and \"constant\"");
    if (place.has("name")) {
      column.name = place.at("name").text();
      if (column.name.empty()) place.at("name").fail("must not be empty; give the column's \"position\"");
      if (out_.header == 0u)
        place.at("name").fail("cannot be found, because \"header\" is 0: give the column's \"position\"");
    }
    constexpr double kMostColumns = 100'000;
    if (place.has("position")) column.position = std::size_t(place.at("position").whole(1, kMostColumns));
    if (!place.has("constant")) return;
    column.constant = place.at("constant").number();
    if (!may_be_constant(column.is))
      place.at("constant")
          .fail("must be the name or the position of a column, because the entry is " +
                std::string(name_of(column.is)));
    if (column.is == Meaning::wavelength && !(*column.constant > 0))
      place.at("constant").fail("must be above 0");
  }

  static void read_unit(const JsonPlace& place, LayoutColumn& column) {
    const bool is_band = column.is == Meaning::wavelength;
    if (!place.has("unit")) {
      if (is_band) place.at("unit");  // throws: the key is missing
      return;
    }
    const JsonPlace unit = place.at("unit");
    column.unit = unit_named(plain_symbols(unit.text()));
    if (is_band && !(column.unit && is_of_light(*column.unit)))
      unit.fail("must be a unit of wavelengths: nm, um, m, angstrom, cm-1, GHz, THz, eV");
    if (!is_band && !(column.unit && column.unit->kind() == Unit::Kind::angle))
      unit.fail("must be a unit of angles: deg or rad");
  }

  static void read_value(const JsonPlace& place, LayoutColumn& column) {
    for (const char* key : {"channel", "of"}) {
      if (!place.has(key)) continue;
      column.channel = place.at(key).text();
      if (column.channel.empty()) place.at(key).fail("must not be empty");
    }
    if (place.has("quantity")) column.quantity = quantity_at(place.at("quantity"));
    constexpr double kLargest = 10;
    if (place.has("coverage")) {
      column.coverage = place.at("coverage").number(0, kLargest);
      if (!(column.coverage > 0)) place.at("coverage").fail("must be above 0");
    }
    if (!place.has("relative")) return;
    const std::string unit = place.at("relative").text();
    if (unit != "%" && unit != "1") place.at("relative").fail("must be \"%\" or \"1\" (a fraction)");
    column.is_relative = true;
    if (unit == "%") column.coverage *= 100;
  }

  static Quantity quantity_at(const JsonPlace& place) {
    const std::optional<Quantity> found = quantity_named(place.text());
    if (!found) place.fail("is unknown (known: " + known_quantities() + ")");
    if (found->kind->use != QuantityKind::Use::converted) place.fail(refusal_of(*found->kind));
    return *found;
  }

  // Checks that the directions are complete, and that no meaning is given twice.
  void check_columns() const {
    for (std::size_t k = 0; k < out_.columns.size(); ++k)
      for (std::size_t j = 0; j < k; ++j) check_pair(out_.columns[j], out_.columns[k]);
    for (const Meaning is : {Meaning::theta_i, Meaning::theta_o, Meaning::value})
      if (!out_.find(is)) fail("$.columns", "no entry is " + std::string(name_of(is)) + "; add the column");
    const LayoutColumn *const light = out_.find(Meaning::phi_i), *const viewer = out_.find(Meaning::phi_o);
    const LayoutColumn* const phase = out_.find(Meaning::phase);
    if (phase && (light || viewer))
      fail(phase->path, "a phase angle replaces the azimuths: remove it, or remove phi_i and phi_o");
    if ((light == nullptr) != (viewer == nullptr)) {
      const std::string missing(name_of(light ? Meaning::phi_o : Meaning::phi_i));
      fail("$.columns", "no entry is " + missing +
                            ", but the other azimuth is given: add {\"constant\": 0, " + "\"is\": \"" +
                            missing + "\"} if the other azimuth is relative");
    }
  }

  void check_pair(const LayoutColumn& a, const LayoutColumn& b) const {
    const bool may_repeat = a.is == Meaning::value || a.is == Meaning::sigma || a.is == Meaning::ignored;
    if (a.is == b.is && !may_repeat)
      fail(b.path, "is " + std::string(name_of(b.is)) + ", as " + a.path + " is: remove one of the two");
    if ((!a.name.empty() && a.name == b.name) || (a.position && a.position == b.position))
      fail(b.path, "is the column of " + a.path + ": remove one of the two");
  }

  void check_values() {
    const auto values = std::ranges::count(out_.columns, Meaning::value, &LayoutColumn::is);
    const bool has_bands = out_.find(Meaning::wavelength) != nullptr;
    const LayoutColumn* const band =
        has_bands ? out_.find(Meaning::wavelength) : out_.find(Meaning::polarisation);
    if (band && values != 1)
      fail(band->path, "a column of wavelengths or polarisations needs one entry that is value, not " +
                           std::to_string(values));
    for (LayoutColumn& column : out_.columns) {
      if (column.is != Meaning::value) continue;
      if (has_bands && !column.channel.empty())
        fail(column.path + ".channel", "has no effect: the wavelengths name the channels; remove the key");
      if (column.channel.empty()) {
        if (values > 1 && column.name.empty())
          fail(column.path, "key \"channel\" is missing: several columns of values need names");
        column.channel = values > 1 ? with_band_unit(column.name) : "fr";
      }
      for (const LayoutColumn& other : out_.columns)
        if (&other != &column && other.is == Meaning::value && other.channel == column.channel)
          fail(column.path, "is the channel " + shown(column.channel) + ", as " + other.path +
                                " is: give each its own \"channel\"");
    }
    check_deviations(values);
  }

  void check_deviations(std::ptrdiff_t values) {
    std::map<std::string, std::string> taken;
    for (LayoutColumn& column : out_.columns) {
      if (column.is != Meaning::sigma) continue;
      if (column.channel.empty()) {
        if (values != 1) fail(column.path, "key \"of\" is missing: it names the channel of the uncertainty");
        column.channel = out_.find(Meaning::value)->channel;
      }
      const bool is_known = std::ranges::any_of(out_.columns, [&](const LayoutColumn& other) {
        return other.is == Meaning::value && other.channel == column.channel;
      });
      if (!is_known) fail(column.path + ".of", shown(column.channel) + " must be the channel of a value");
      const auto [first, is_new] = taken.emplace(column.channel, column.path);
      if (!is_new)
        fail(column.path, "is the uncertainty of " + shown(column.channel) + ", as " + first->second + " is");
    }
  }

  void read_facts() {
    if (std::ranges::all_of(out_.columns, [](const LayoutColumn& c) {
          return c.is != Meaning::value || c.quantity.has_value();
        }))
      refuse_without_effect("quantity", "each entry that is value has its own quantity");
    if (root_.has("quantity")) out_.quantity = quantity_at(root_.at("quantity"));
    const bool has_azimuths = out_.find(Meaning::phi_i) != nullptr;
    if (has_azimuths || out_.find(Meaning::phase))
      refuse_without_effect("mirror_side", "azimuths or a phase angle give the side");
    if (root_.has("mirror_side")) out_.mirror_side = root_.at("mirror_side").named<MirrorSide>();
    if (!has_azimuths) refuse_without_effect("mirror_azimuth", "the layout has no azimuths");
    if (root_.has("mirror_azimuth")) {
      const double azimuth = root_.at("mirror_azimuth").number();
      if (azimuth != 0 && azimuth != 180) root_.at("mirror_azimuth").fail("must be 180 or 0 degrees");
      out_.mirror_is_at_zero = azimuth == 0;
    }
    constexpr double kWidest = 90;
    if (root_.has("aperture")) out_.aperture = root_.at("aperture").number(0, kWidest);
    if (root_.has("fill")) read_fill(root_.at("fill"));
  }

  void read_fill(const JsonPlace& list) {
    if (list.size() == 0) list.fail("must name at least one fill value; remove the key");
    for (std::size_t k = 0; k < list.size(); ++k) {
      const JsonPlace place = list.at(k);
      if (place.value().is_number())
        out_.fill_numbers.push_back(place.number());
      else if (place.value().is_string())
        out_.fill_words.push_back(lower_case(trimmed(place.text())));
      else
        place.fail("must be a number or a text");
    }
  }

  JsonPlace root_;
  Layout out_;
};

bool is_text_of_json(const std::string& file_or_json) {
  return file_or_json.starts_with('{');
}

}  // namespace

const LayoutColumn* Layout::find(Meaning meaning) const {
  const auto found = std::ranges::find(columns, meaning, &LayoutColumn::is);
  return found == columns.end() ? nullptr : &*found;
}

bool Layout::is_fill(std::string_view cell, std::optional<double> number) const {
  if (number && std::ranges::find(fill_numbers, *number) != fill_numbers.end()) return true;
  return !fill_words.empty() && std::ranges::find(fill_words, lower_case(cell)) != fill_words.end();
}

std::string layout_text(const std::string& file_or_json) {
  if (file_or_json.empty() || is_text_of_json(file_or_json)) return file_or_json;
  return read_content(file_or_json, kLargestJson).bytes;
}

Layout read_layout(const std::string& file_or_json) {
  if (is_text_of_json(file_or_json)) return LayoutReader(parse_json(file_or_json, "layout"), "layout").read();
  return LayoutReader(read_json(file_or_json), file_or_json).read();
}

}  // namespace brdf::io
