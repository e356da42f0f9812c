#include "io/columns/value_columns.h"

#include <algorithm>
#include <array>
#include <map>

#include "io/columns/angle_names.h"
#include "io/columns/metadata_names.h"
#include "io/columns/plain_names.h"
#include "io/columns/polarisation_names.h"
#include "io/columns/value_names.h"
#include "io/columns/wavelengths.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using Says = NamedQuantity::Says;
using Use = QuantityKind::Use;
using Announce = std::function<void(std::string_view, const std::string&)>;

std::string quoted(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 6;
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), kMost); ++k) text += (k ? ", " : "") + shown(names[k]);
  return text + (names.size() > kMost ? ", ... (" + std::to_string(names.size()) + ")" : "");
}

// "column 'a' is", "each of the columns 'a', 'b' is".
std::string columns_are(const std::vector<std::string>& names) {
  return (names.size() == 1 ? "column " : "each of the columns ") + quoted(names) + " is ";
}

// A column that may hold values.
struct Candidate {
  enum class Rank {
    values,   // values of a quantity that is converted
    neutral,  // the name states no quantity
    asked,    // the name is ambiguous
    refused,  // values of a quantity that cannot be converted to f_r
    aside     // no values
  };
  Column* column;
  NamedQuantity named;
  Rank rank;
  std::string refusal;      // for `asked` and `refused`: the end of a sentence about the column
  bool is_perhaps = false;  // values only if no other column holds any
};

using Rank = Candidate::Rank;

class Values {
 public:
  Values(Columns& header, const HeaderFacts& facts, const Announce& announce)
      : header_(header), facts_(facts), announce_(announce) {}

  void place() {
    for (std::size_t k = 0; k < header_.columns.size(); ++k)
      if (header_.columns[k].kind == Column::Kind::value) add_candidate(k);
    part_deviations();
    rank_by_neighbours();
    settle();
    add_channels();
    for (Candidate& deviation : deviations_) place_deviation(deviation);
    add_notes();
  }

 private:
  // Refuses the table, or notes the doubt if the caller collects doubts.
  void refuse(const Candidate& c, ColumnDoubt::Of of, const std::string& what) const {
    if (!facts_.doubts) throw InputError(facts_.where + ": " + what);
    facts_.doubts->push_back({of, std::size_t(c.column - header_.columns.data()), what});
  }

  void add_candidate(std::size_t k) {
    Column& column = header_.columns[k];
    Candidate c{&column, quantity_of_column(column.name), Rank::neutral, ""};
    const bool is_text = k < facts_.is_text.size() && facts_.is_text[k] && !wavelength_of(column.name);
    if (c.named.says == Says::quantity) {
      const QuantityKind& kind = *c.named.quantity.kind;
      c.rank = kind.use == Use::converted ? Rank::values
               : kind.use == Use::asked   ? Rank::asked
                                          : Rank::refused;
      if (kind.use != Use::converted) c.refusal = refusal_of(kind);
    } else if (c.named.says == Says::contradicts) {
      c.rank = Rank::asked;
      c.refusal = c.named.reason;
    }
    const NoValues no_values = holds_no_values(column.name);
    const bool is_angle = facts_.is_plain && c.rank == Rank::neutral &&
                          angle_named(c.named.name).has_value() && !angle_named(c.named.name)->is_weak;
    if (c.named.says == Says::no_values || is_angle || (no_values == NoValues::yes && c.rank != Rank::values))
      c.rank = Rank::aside;
    const bool is_capital = column.name == "X" || column.name == "Y" || column.name == "Z";
    c.is_perhaps = ((no_values == NoValues::perhaps && !is_capital) || is_text) && c.rank == Rank::neutral;
    candidates_.push_back(std::move(c));
  }

  bool any(Rank rank) const {
    return std::ranges::any_of(candidates_, [&](const Candidate& c) { return c.rank == rank; });
  }

  Candidate* named(std::string_view name) {
    const auto at =
        std::ranges::find_if(candidates_, [&](const Candidate& c) { return c.column->name == name; });
    return at == candidates_.end() ? nullptr : &*at;
  }

  // Adjusts the ranks of names that depend on the other columns.
  void rank_by_neighbours() {
    if (facts_.keeps_names) return;
    // Points, runs, places and texts are not values if other columns hold values.
    for (Candidate& c : candidates_)
      if (c.is_perhaps) c.rank = Rank::aside;
    const bool has_others = any(Rank::values) || any(Rank::neutral) || any(Rank::asked) || any(Rank::refused);
    for (Candidate& c : candidates_)
      if (c.is_perhaps && !has_others) c.rank = Rank::neutral;
    // "(s)" means seconds, unless another column has the other polarisation.
    const bool has_p = std::ranges::any_of(candidates_, [](const Candidate& c) {
      const auto of = polarised_name(c.column->name).of;
      return of && *of != Polarisation::s;
    });
    for (Candidate& c : candidates_)
      if (c.rank == Rank::neutral && !has_p &&
          (c.column->name.ends_with("(s)") || c.column->name.ends_with("[s]")))
        c.rank = Rank::aside;
    if (!facts_.is_format) rank_tristimulus();
    if (!facts_.is_format) rank_cielab();
    rank_mueller();
    rank_stokes();
  }

  void rank_tristimulus() {
    std::array<Candidate*, 3> xyz{named("X"), named("Y"), named("Z")};
    if (std::ranges::any_of(xyz, [](const Candidate* c) { return !c; })) return;
    for (Candidate* c : xyz) {
      c->rank = Rank::asked;
      c->refusal =
          "is, with X, Y and Z, a tristimulus value: if the three are f_r weighted by the CIE observer, give "
          "--quantity f_r; values of a colour instrument lack the geometry and the scale";
    }
  }

  // Refuses L, a, b and L, C, h, which instruments for colours write without asterisks.
  void rank_cielab() {
    for (const auto& names : {std::array{"L", "a", "b"}, std::array{"L", "C", "h"}}) {
      std::array<Candidate*, 3> lab{named(names[0]), named(names[1]), named(names[2])};
      if (std::ranges::any_of(lab, [](const Candidate* c) { return !c || c->rank != Rank::neutral; }))
        continue;
      for (Candidate* c : lab) {
        c->rank = Rank::asked;
        c->refusal = "is, with " + std::string(names[0]) + ", " + names[1] + " and " + names[2] +
                     ", a colour coordinate (CIELAB): if the three are channels of f_r, give --quantity f_r; "
                     "colour coordinates lack the geometry and the spectrum: export reflectance factors for "
                     "each wavelength";
      }
    }
  }

  // Recognises f_r11, f_r12/f_r11, ...; m11, m12, ...: the first element is f_r of unpolarised light.
  void rank_mueller() {
    std::vector<Candidate*> elements;
    Candidate* first = nullptr;
    counts_from_zero_ = std::ranges::any_of(
        candidates_, [](const Candidate& c) { return mueller_place(c.column->name) == "00"; });
    for (Candidate& c : candidates_) {
      const std::string element = element_of(c.column->name);
      if (element == "11") first = &c;
      if (!element.empty()) elements.push_back(&c);
    }
    if (elements.size() < 4) return;
    for (Candidate* c : elements) {
      c->rank = c == first ? Rank::values : Rank::aside;
      if (c == first) c->named.quantity = {&quantity_kinds()[0]};
    }
    if (!first) return;
    note_mueller(*first);
    header_.assume(std::to_string(elements.size()) + " elements of a Mueller matrix: " +
                   shown(first->column->name) + ", f_r of unpolarised light, is read");
  }

  // Returns the element, "11" to "44", that the name of a column denotes, or an empty string. Some tables
  // count rows and columns of the matrix from 0.
  std::string element_of(const std::string& name) const {
    std::string place = mueller_place(name);
    for (char& c : place) {
      c = static_cast<char>(c + counts_from_zero_);
      if (c < '1' || c > '4') return "";
    }
    return place;
  }

  // Recognises the Stokes vector of the scattered light. Only its first element is a value of f_r.
  void rank_stokes() {
    for (const auto& names : {std::array{"S0", "S1", "S2", "S3"}, std::array{"I", "Q", "U", "V"}}) {
      if (!named(names[0]) || !named(names[1]) || !named(names[2])) continue;
      for (const char* name : {names[1], names[2], names[3]})
        if (Candidate* const c = named(name)) c->rank = Rank::aside;
      note("the columns are a Stokes vector: " + shown(names[0]) + ", the intensity, is read");
    }
  }

  // Elements are divided by the first one if their names say so ("f_r12/f_r11"), or if their names differ
  // from the first one in more than the place (fr11, m12).
  void note_mueller(const Candidate& first) {
    MuellerColumns found;
    std::size_t count = 0;
    const char* const of_numbers = counts_from_zero_ ? "00" : "11";
    const std::string of_first = first.column->name.substr(0, first.column->name.find(of_numbers));
    for (std::size_t k = 0; k < header_.columns.size(); ++k) {
      const std::string& name = header_.columns[k].name;
      const std::string element = element_of(name);
      std::size_t* const place = element == "12"   ? &found.m12
                                 : element == "21" ? &found.m21
                                 : element == "22" ? &found.m22
                                                   : nullptr;
      if (!place) continue;
      *place = k;
      ++count;
      found.is_divided = found.is_divided || name.find('/') != name.npos ||
                         name.substr(0, name.find(mueller_place(name))) != of_first;
    }
    if (count == 3) header_.mueller = found;
  }

  // Moves the columns of standard deviations out of the candidates.
  void part_deviations() {
    std::vector<bool> is_deviation;
    note_names();
    for (const Candidate& c : candidates_) {
      const std::string& name = c.column->name;
      const auto of = deviation_of(name);
      const bool is_literal = facts_.keeps_names && !name.starts_with(kSigmaPrefix);
      const bool is_of_one = of && (of->empty() || name.starts_with(kSigmaPrefix) || find(*of) ||
                                    quantity_of_column(*of).says == Says::quantity);
      is_deviation.push_back(is_of_one && !is_literal);
    }
    // The deviation of something unknown is not a channel if other columns hold values.
    for (Candidate& c : candidates_)
      if (c.rank == Rank::neutral && deviation_of(c.column->name)) c.is_perhaps = true;
    std::vector<Candidate> values;
    for (std::size_t k = 0; k < candidates_.size(); ++k)
      (is_deviation[k] ? deviations_ : values).push_back(std::move(candidates_[k]));
    candidates_ = std::move(values);
    note_names();
  }

  // Collects the names of each candidate: as written; then without the unit; then also without the words of
  // the quantity. If HeaderFacts::keeps_names is set, only the written names count.
  void note_names() {
    by_name_.clear();
    for (std::size_t k = 0; k < candidates_.size(); ++k)
      by_name_.emplace(with_band_unit(candidates_[k].column->name), k);
    if (facts_.keeps_names) return;
    for (std::size_t k = 0; k < candidates_.size(); ++k)
      for (const std::string* name : {&candidates_[k].named.bare, &candidates_[k].named.name})
        by_name_.emplace(with_band_unit(*name), k);
  }

  // Returns the candidate that a deviation's name denotes, or null.
  Candidate* find(const std::string& text) {
    const auto known_by = [&](const std::string& name) -> Candidate* {
      const auto at = by_name_.find(with_band_unit(name));
      return at == by_name_.end() ? nullptr : &candidates_[at->second];
    };
    Candidate* const found = known_by(text);
    return found || facts_.keeps_names ? found : known_by(quantity_of_column(text).bare);
  }

  // Makes each candidate a channel, sets it aside, or refuses the table.
  void settle() {
    const bool has_values = any(Rank::values), has_neutral = any(Rank::neutral);
    for (Candidate& c : candidates_) {
      if (facts_.keeps_names)
        keep(c);
      else if (c.rank == Rank::values || c.rank == Rank::neutral)
        state(c);
      else if (c.rank == Rank::asked)
        settle_asked(c, has_values);
      else if (c.rank == Rank::refused && !has_values && !has_neutral)
        settle_refused(c);
      else
        set_aside(c);
    }
  }

  // Keeps a column of a table of our own, in which column names carry no meaning.
  void keep(Candidate& c) {
    const bool is_f_r = c.named.says == Says::quantity && c.named.quantity.is_f_r();
    if (c.named.says != Says::nothing && !is_f_r) outranked_.push_back(c.column->name);
    c.named.name = c.column->name;
    c.named.quantity = {&quantity_kinds()[0]};
    c.rank = Rank::values;
    kept_.push_back(&c);
  }

  void settle_asked(Candidate& c, bool has_values) {
    if (facts_.stated) return state(c);
    if (has_values || !facts_.needs_values) return set_aside(c);
    refuse_quantity(c);
  }

  void settle_refused(Candidate& c) {
    if (facts_.stated) return state(c);
    if (!facts_.needs_values) return set_aside(c);
    refuse_quantity(c);
  }

  // Refuses values of this quantity. If the caller collects doubts, the column becomes a channel.
  void refuse_quantity(Candidate& c) {
    refuse(c, ColumnDoubt::Of::quantity, "column " + shown(c.column->name) + " " + c.refusal);
    c.named.quantity = {&quantity_kinds()[0]};
    kept_.push_back(&c);
  }

  void set_aside(Candidate& c) {
    c.column->kind = Column::Kind::aside;
    aside_.push_back(c.column->name);
  }

  // Sets the quantity of a column. A quantity stated in a comment overrides the column's name. A quantity
  // stated by a title or an option must not contradict the name.
  void state(Candidate& c) {
    kept_.push_back(&c);
    Quantity& own = c.named.quantity;
    const bool is_own = c.rank == Rank::values;
    if (!facts_.stated) {
      if (is_own && c.named.needs_a_line) by_unit_.push_back(c.column->name);
      if (header_.is_road && !is_own) return state_road_value(c);
      if (!is_own) unnamed_.push_back(c.column->name);
      header_.has_unnamed = header_.has_unnamed || !is_own || c.named.is_default;
      if (!is_own) own = {&quantity_kinds()[0]};
      return;
    }
    const StatedQuantity& stated = *facts_.stated;
    const bool says_other =
        (is_own || c.rank == Rank::refused) && own.kind != stated.quantity.kind && !c.named.is_default;
    if (says_other && stated.by != StatedQuantity::By::comment) return refuse_contradiction(c);
    if (says_other) {
      outranked_.push_back(c.column->name);
      own = stated.quantity;
      return;
    }
    // If one of the two states no scale, the other's scale applies: quantity BRF, column '550nm (%)'.
    const Quantity plain{stated.quantity.kind};
    own = stated.quantity == plain ? Quantity{stated.quantity.kind, own.factor, own.scale} : stated.quantity;
    if (c.named.says == Says::contradicts) outranked_.push_back(c.column->name);
  }

  // In a road table r is the reduced luminance coefficient, and q is the luminance coefficient.
  void state_road_value(Candidate& c) {
    const std::string name = lower_case(trimmed(c.column->name));
    const bool is_reduced = name.starts_with('r') && (name.size() == 1 || name.find_first_of(" _*(x") == 1);
    if (!is_reduced && name != "q")
      refuse(c, ColumnDoubt::Of::quantity,
             "column " + shown(c.column->name) +
                 " of an r-table of road lighting gives no quantity: name the column r (reduced luminance "
                 "coefficient times 10^4) or q (luminance coefficient), or give --quantity");
    c.named.quantity = is_reduced ? *quantity_named("r") : Quantity{&quantity_kinds()[0]};
  }

  void refuse_contradiction(const Candidate& c) const {
    const StatedQuantity& stated = *facts_.stated;
    const bool is_title = stated.by == StatedQuantity::By::title;
    refuse(c, ColumnDoubt::Of::quantity,
           "column " + shown(c.column->name) + " is " + c.named.quantity.meaning() + ", but " +
               (is_title ? "the title in " + stated.where + " gives " : "--quantity gives ") +
               shown(stated.words) + ": if the name is wrong, write '# quantity: " + printable(stated.words) +
               "' above the header row");
  }

  void add_channels() {
    std::map<std::string, int> times;
    for (const Candidate* c : kept_) ++times[with_band_unit(c->named.name)];
    for (Candidate* c : kept_) {
      std::string name = facts_.keeps_names ? with_band_unit(c->column->name) : with_band_unit(c->named.name);
      // The words of the quantities distinguish these columns.
      if (times[name] > 1) name = with_band_unit(c->column->name);
      c->column->index = header_.channels.size();
      header_.channels.push_back(name);
      header_.quantities.push_back(c->named.quantity);
      announce_(c->column->name, name);
    }
  }

  void place_deviation(Candidate& deviation) {
    Column& column = *deviation.column;
    const std::string of = *deviation_of(column.name);
    const bool is_relative = !facts_.keeps_names && unit_of_deviation_is_percent(deviation);
    const bool is_literal = column.name.starts_with(kSigmaPrefix);
    const Candidate* value = of.empty() ? nullptr : find_kept(of);
    if (!value && !is_literal && kept_.size() == 1) value = kept_[0];
    if (!value && is_literal)
      refuse(deviation, ColumnDoubt::Of::meaning,
             "column " + shown(column.name) + " has no column of values");
    if (!value || (is_relative && value->named.quantity.factor != 0.01)) return set_aside(deviation);
    const UncertaintyWords words = facts_.keeps_names ? UncertaintyWords{} : uncertainty_words(column.name);
    if (words.is_relative || !(words.coverage > 0)) {
      column.kind = Column::Kind::aside;
      return note(
          "column " + shown(column.name) + " is ignored: " +
          (words.is_relative ? "a relative uncertainty" : "an expanded uncertainty without its factor k") +
          " is read with a layout (sigma, relative, coverage)");
    }
    if (words.coverage != 1)
      note("column " + shown(column.name) + " is an expanded uncertainty: divided by " +
           to_text(words.coverage));
    column.coverage = words.coverage;
    column.kind = Column::Kind::sigma;
    column.index = value->column->index;
    for (const Column& other : header_.columns)
      if (&other != &column && other.kind == Column::Kind::sigma && other.index == column.index)
        refuse(deviation, ColumnDoubt::Of::meaning,
               other.name == column.name
                   ? "column " + shown(column.name) + " twice"
                   : "columns " + shown(other.name) + " and " + shown(column.name) +
                         " are both standard deviations of " + shown(header_.channels[column.index]));
    announce_(column.name, std::string(kSigmaPrefix) + header_.channels[column.index]);
  }

  static bool unit_of_deviation_is_percent(const Candidate& c) {
    for (const auto& [bare, unit] : ways_to_part(c.column->name))
      if (const auto named = unit_named(unit); named && named->is_percent) return true;
    return false;
  }

  const Candidate* find_kept(const std::string& text) {
    Candidate* const found = find(text);
    return found && std::ranges::find(kept_, found) != kept_.end() ? found : nullptr;
  }

  void note(const std::string& sentence) { header_.assume(sentence); }

  void add_notes() {
    note_quantities();
    if (!unnamed_.empty() && !facts_.is_plain)
      note(columns_are(unnamed_) + "interpreted as f_r in 1/sr, because its name gives no quantity");
    if (!by_unit_.empty()) note(columns_are(by_unit_) + "interpreted as f_r, because the unit is 1/sr");
    if (!outranked_.empty())
      note("quantity " + shown(facts_.stated->words) +
           (facts_.stated->where.empty() ? "" : " (" + facts_.stated->where + ")") +
           " takes precedence over the name" + (outranked_.size() == 1 ? " " : "s ") + quoted(outranked_));
    if (!aside_.empty())
      note((aside_.size() == 1 ? "column " : "columns ") + quoted(aside_) +
           (aside_.size() == 1 ? " is" : " are") + " ignored: not values of f_r");
  }

  // Adds one sentence for the columns of each quantity.
  void note_quantities() {
    std::vector<std::pair<Quantity, std::vector<std::string>>> groups;
    for (const Candidate* c : kept_) {
      if (c->named.quantity.is_f_r()) continue;
      const auto at =
          std::ranges::find_if(groups, [&](const auto& group) { return group.first == c->named.quantity; });
      if (at == groups.end())
        groups.push_back({c->named.quantity, {c->column->name}});
      else
        at->second.push_back(c->column->name);
    }
    for (const auto& [quantity, names] : groups)
      note(columns_are(names) + quantity.meaning() + ": " + quantity.operation());
  }

  Columns& header_;
  const HeaderFacts& facts_;
  const Announce& announce_;
  std::vector<Candidate> candidates_, deviations_;
  std::map<std::string, std::size_t> by_name_;  // indices of candidates
  std::vector<Candidate*> kept_;                // candidates that become channels
  bool counts_from_zero_ = false;               // the elements of a Mueller matrix
  std::vector<std::string> unnamed_, by_unit_, outranked_, aside_;
};

}  // namespace

void place_values(Columns& header, const HeaderFacts& facts, const Announce& announce) {
  Values(header, facts, announce).place();
}

}  // namespace brdf::io
