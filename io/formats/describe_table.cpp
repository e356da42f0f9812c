#include "io/formats/describe_table.h"

#include <algorithm>
#include <set>

#include "brdf/angle.h"
#include "io/columns/name_unit.h"
#include "io/columns/plain_names.h"
#include "io/columns/value_names.h"
#include "io/columns/wavelengths.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/formats/read.h"
#include "io/formats/table_scan.h"
#include "io/samples/fill_values.h"
#include "io/samples/highlight.h"

namespace brdf::io {
namespace {

// Returns a word for the unit that is read back to the same unit.
std::string word_of(const Unit& unit, const std::string& column) {
  for (const char* word : {"deg", "rad", "nm", "um", "m", "cm-1", "GHz", "THz", "eV", "angstrom"})
    if (unit_named(word) == unit) return word;
  return plain_symbols(parted(column).unit_text);
}

// Returns words for the quantity that are read back to the same quantity; an empty string if no words do.
std::string words_for_quantity(const Quantity& quantity) {
  const std::string name(quantity.kind->name);
  for (const std::string& words :
       {name, name + " %", "milli " + name, name + " x1000", name + " ppm", "log10 " + name, "ln " + name,
        name + " dB", name + " (dB)", "log10 " + name + " %"})
    if (quantity_named(words) == quantity) return words;
  return "";
}

std::string separator_word(char separator) {
  return separator == '\t' ? "tab" : separator == ' ' ? "blanks" : std::string(1, separator);
}

class Proposer {
 public:
  explicit Proposer(const Content& text) : text_(text), scan_(text) {}

  TableProposal result() {
    try {
      out_.alone = read_samples(Content(text_));
    } catch (const InputError& error) {
      out_.refusal = error.what();
    }
    if (!out_.alone) scan_.find_comment_sign();
    scan_.read();
    write();
    return std::move(out_);
  }

 private:
  void be_unsure(const std::string& path, const std::string& reason) {
    unsure_.push_back({{"path", path}, {"reason", reason}});
  }
  // Leaves a place to the user. A table that is read without a layout has no such place.
  Json open(const std::string& path, const std::string& reason) {
    be_unsure(path, reason);
    ++out_.open;
    return nullptr;
  }

  void write() {
    Json& j = out_.layout;
    j["format"] = "brdf-layout";
    j["version"] = 1;
    j["separator"] = separator_word(scan_.dialect().separator());
    if (scan_.dialect().mark() != 0) j["decimal"] = std::string(1, scan_.dialect().mark());
    if (!scan_.comment_sign().empty()) j["comment"] = scan_.comment_sign();
    if (scan_.is_without_header()) j["header"] = 0;
    write_quantity(j);
    write_sides(j);
    write_fill(j);
    j["columns"] = Json::array();
    for (std::size_t k = 0; k < scan_.facts().size(); ++k) j["columns"].push_back(entry(k));
    if (const auto& only = scan_.found().only_azimuth) add_other_azimuth(j["columns"], *only);
    add_stated_angles(j["columns"]);
    note_missing_angles();
    for (const std::string& sentence : scan_.found().assumptions)
      if (sentence.find("Mueller") != sentence.npos) be_unsure("$.columns", sentence);
    if (!out_.alone && out_.open == 0)
      be_unsure("$", "the table is refused without a layout: " + out_.refusal);
    if (!unsure_.empty()) j["unsure"] = unsure_;
  }

  // Writes one quantity for all columns of values if all have the same.
  void write_quantity(Json& j) {
    std::set<std::string> all;
    bool is_open = false;
    for (std::size_t k = 0; k < scan_.columns().size(); ++k)
      if (scan_.columns()[k].kind == Column::Kind::value) {
        is_open = is_open || scan_.doubt(k, ColumnDoubt::Of::quantity) || !is_value(k);
        all.insert(words_for_quantity(scan_.found().quantities[scan_.columns()[k].index]));
      }
    if (is_open || all.size() != 1 || all.begin()->empty()) return;
    j["quantity"] = *all.begin();
    has_one_quantity_ = true;
    for (const Column& column : scan_.columns())
      if (column.kind == Column::Kind::value)
        if (const std::string reason = doubt_of_quantity(column); !reason.empty())
          return be_unsure("$.quantity", reason);
  }

  // Returns the reason for doubt about a quantity that the reader accepts, or an empty string.
  std::string doubt_of_quantity(const Column& column) const {
    if (scan_.header().stated()) return "";
    if (!mueller_place(column.name).empty()) return "";
    const NamedQuantity named = quantity_of_column(column.name);
    if (named.is_default)
      return "the name " + shown(column.name) + " is common for any quantity; f_r in 1/sr is assumed";
    if (named.says == NamedQuantity::Says::nothing)
      return "the name " + shown(column.name) + " gives no quantity; f_r in 1/sr is assumed";
    if (named.needs_a_line)
      return "f_r follows from the unit of " + shown(column.name) + " alone; its word has other meanings";
    return "";
  }

  // Two signed angles: states the side of the mirror direction.
  void write_sides(Json& j) {
    if (!scan_.found().in_plane) check_azimuths(j);
    if (!scan_.found().in_plane || !scan_.has_angles()) return;
    for (std::size_t k = 0; k < scan_.columns().size(); ++k)
      if (scan_.columns()[k].kind == Column::Kind::angle && scan_.columns()[k].index == 0 &&
          scan_.facts()[k].least < 0)
        return;
    if (!out_.alone) {
      j["mirror_side"] = open("$.mirror_side",
                              "the sign of the viewing angle on the mirror side is not known, and the table "
                              "cannot be read without a layout to judge it");
      return;
    }
    const SampleTable positive = read_samples(Content(text_), {.mirror_side = MirrorSide::positive});
    j["mirror_side"] = positive.phi_o == out_.alone->phi_o ? "positive" : "negative";
    for (const std::string& sentence : out_.alone->assumptions)
      if (sentence.starts_with("two angles in the plane")) be_unsure("$.mirror_side", sentence);
  }

  // Tests the convention of the azimuths on the values.
  void check_azimuths(Json& j) {
    if (!out_.alone || scan_.found().has(Column::Kind::phase)) return;
    SampleTable judged = *out_.alone;
    judged.assumptions.clear();
    check_highlight(judged);
    if (judged.assumptions.empty()) return;
    j["mirror_azimuth"] = 180;
    be_unsure("$.mirror_azimuth", judged.assumptions[0]);
  }

  // Words in columns of numbers, and numbers such as -999, mark directions that were not measured. A table
  // with such cells is refused without a layout.
  void write_fill(Json& j) {
    if (out_.alone) return;
    Json fill = Json::array();
    for (std::size_t k = 0; k < scan_.columns().size(); ++k) {
      const bool has_values = scan_.columns()[k].kind == Column::Kind::value && is_value(k);
      if (!(has_values || scan_.columns()[k].kind == Column::Kind::sigma) || scan_.facts()[k].numbers == 0)
        continue;
      for (const std::string& word : scan_.facts()[k].word_list) add_new(fill, word);
      const ColumnFacts& facts = scan_.facts()[k];
      for (const auto& [number, times] : facts.times) {
        const bool is_an_end = number == facts.least || number == facts.largest;
        if (is_fill_value(number) || (is_an_end && times > 1 && may_be_fill_value(number)))
          add_new(fill, number);
      }
    }
    if (fill.empty()) return;
    j["fill"] = fill;
    be_unsure("$.fill", "these cells of value columns are taken for directions that were not measured");
  }

  static void add_new(Json& list, const Json& item) {
    if (std::ranges::find(list, item) == list.end()) list.push_back(item);
  }

  // Returns whether a column of the kind `value` holds values: in a table without one of the two polar
  // angles, an unknown word may be the word for an angle.
  bool is_value(std::size_t k) const {
    return scan_.has_angles() ||
           quantity_of_column(scan_.columns()[k].name).says == NamedQuantity::Says::quantity;
  }

  Json entry(std::size_t k) {
    const std::string path = "$.columns[" + std::to_string(k) + "]";
    Json e;
    if (scan_.is_without_header()) {
      e["position"] = k + 1;
      e["is"] = open(path + ".is", "column " + std::to_string(k + 1) + " " + scan_.facts()[k].in_words());
      return e;
    }
    const std::vector<std::string>& names = scan_.header().written_names();
    if (names[k].empty() || std::ranges::count(names, names[k]) > 1)
      e["position"] = k + 1;
    else
      e["name"] = names[k];
    write_meaning(e, k, path);
    return e;
  }

  void write_meaning(Json& e, std::size_t k, const std::string& path) {
    const Column& column = scan_.columns()[k];
    if (const ColumnDoubt* d = scan_.doubt(k, ColumnDoubt::Of::meaning)) {
      e["is"] = open(path + ".is", d->reason + "; it " + scan_.facts()[k].in_words());
      return;
    }
    switch (column.kind) {
      case Column::Kind::angle:
        e["is"] = kAngleNames[column.index];
        write_angle(e, k, path);
        break;
      case Column::Kind::phase:
      case Column::Kind::rotation:
        e["is"] = column.kind == Column::Kind::phase ? "phase" : "rotation";
        write_angle(e, k, path);
        break;
      case Column::Kind::wavelength:
        e["is"] = "wavelength";
        write_band(e, k, path);
        break;
      case Column::Kind::polarisation:
        e["is"] = "polarisation";
        break;
      case Column::Kind::sigma:
        e["is"] = name_of(Meaning::sigma);
        if (scan_.found().channels.size() > 1) e["of"] = scan_.found().channels[column.index];
        break;
      case Column::Kind::value:
        write_value(e, k, path);
        break;
      case Column::Kind::aside:
        write_aside(e, k, path);
        break;
    }
  }

  void write_angle(Json& e, std::size_t k, const std::string& path) {
    const Column& column = scan_.columns()[k];
    e["unit"] = column.unit ? word_of(*column.unit, column.name) : "deg";
    if (column.is_elevation) e["from"] = "surface";
    const bool is_polar = column.kind == Column::Kind::angle && column.index % 2 == 0;
    constexpr double kMostRadians = kPi / 2 * 1.001;
    const double largest = scan_.facts()[k].largest_size();
    if (!column.unit && is_polar && largest > 0 && largest <= kMostRadians)
      be_unsure(path + ".unit", "the header gives no unit, and the angles reach only " +
                                    short_number(largest, 6) + ": they may be radians");
  }

  void write_band(Json& e, std::size_t k, const std::string& path) {
    const Column& column = scan_.columns()[k];
    if (const ColumnDoubt* d = scan_.doubt(k, ColumnDoubt::Of::unit)) {
      e["unit"] = open(path + ".unit", d->reason);
      return;
    }
    if (column.unit) {
      e["unit"] = word_of(*column.unit, column.name);
      return;
    }
    const bool is_um = are_micrometres(scan_.facts()[k].largest);
    e["unit"] = is_um ? "um" : "nm";
    be_unsure(path + ".unit", "the header gives no unit of the wavelengths, which reach " +
                                  short_number(scan_.facts()[k].largest, 6) + ": read as " +
                                  std::string(is_um ? "micrometres" : "nm"));
  }

  void write_value(Json& e, std::size_t k, const std::string& path) {
    const Column& column = scan_.columns()[k];
    if (!is_value(k)) {
      e["is"] = open(path + ".is", "the name " + shown(column.name) + " is not understood; the column " +
                                       scan_.facts()[k].in_words());
      return;
    }
    e["is"] = "value";
    if (!scan_.found().has(Column::Kind::wavelength)) e["channel"] = scan_.found().channels[column.index];
    if (has_one_quantity_) return;
    const std::string words = words_for_quantity(scan_.found().quantities[column.index]);
    if (const ColumnDoubt* d = scan_.doubt(k, ColumnDoubt::Of::quantity))
      e["quantity"] = open(path + ".quantity", d->reason);
    else if (words.empty())
      e["quantity"] = open(path + ".quantity", "the quantity has no name that options take");
    else
      e["quantity"] = words;
  }

  void write_aside(Json& e, std::size_t k, const std::string& path) {
    if (!scan_.has_angles()) {
      e["is"] = open(path + ".is", "the name " + shown(scan_.columns()[k].name) +
                                       " may be one of metadata; the column " + scan_.facts()[k].in_words());
      return;
    }
    e["is"] = "ignored";
    if (!mueller_place(scan_.columns()[k].name).empty()) return;
    be_unsure(path + ".is", "column " + shown(scan_.columns()[k].name) + " is taken for metadata; it " +
                                scan_.facts()[k].in_words());
  }

  void add_other_azimuth(Json& entries, std::size_t stated) {
    const std::string other(kAngleNames[4 - stated]);
    be_unsure("$.columns[" + std::to_string(entries.size()) + "].constant",
              "the table has one azimuth only, which is taken as relative: " + other +
                  " is 0, and the mirror "
                  "direction is at 180 degrees (if it is at 0: \"mirror_azimuth\": 0)");
    entries.push_back({{"constant", 0}, {"is", other}});
  }

  // Angles that lines above the header row state. The constants of road tables have no name.
  void add_stated_angles(Json& entries) {
    for (const auto& [column, number] : scan_.found().constants) {
      if (column.name.empty()) continue;
      be_unsure("$.columns[" + std::to_string(entries.size()) + "].constant",
                "the line " + shown(column.name) + " above the header row is taken for all rows");
      entries.push_back({{"constant", column.converted(number)}, {"is", kAngleNames[column.index]}});
    }
  }

  void note_missing_angles() {
    std::string missing;
    for (const std::size_t angle : {0, 2})
      if (!scan_.found().has_angle(angle))
        missing += (missing.empty() ? "" : " and ") + std::string(kAngleNames[angle]);
    if (missing.empty()) return;
    const bool can_be_null = out_.open > 0;
    be_unsure("$.columns", "no column is understood as " + missing +
                               (can_be_null ? "" : ": add an entry, with \"constant\" for a fixed angle"));
  }

  const Content& text_;
  TableScan scan_;
  bool has_one_quantity_ = false;
  Json unsure_ = Json::array();
  TableProposal out_;
};

}  // namespace

TableProposal propose_layout(Content content) {
  const std::string format = format_name(content);
  if (format != "csv")
    throw InputError(content.name + ": is in the format " + format +
                     ", and a layout describes only tables of columns of text" +
                     (format == "json" ? "" : ": the reader of this format needs no layout"));
  make_utf8(content);
  return Proposer(content).result();
}

void add_fill(TableProposal& proposal, Content content, const std::vector<std::uint32_t>& lines) {
  make_utf8(content);
  const std::vector<double> numbers = TableScan(content).read_numbers_in(lines);
  if (numbers.empty()) return;
  Json& j = proposal.layout;
  // The order of keys is that of the schema.
  Json ordered;
  for (const auto& [key, value] : j.items()) {
    if (key == "columns") ordered["fill"] = numbers;
    ordered[key] = value;
  }
  j = std::move(ordered);
  j["unsure"].push_back({{"path", "$.fill"},
                         {"reason", plural(lines.size(), "row") +
                                        " with these values contradict the rows around them: they are taken "
                                        "for directions that were not measured"}});
}

}  // namespace brdf::io
