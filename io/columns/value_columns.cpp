#include "io/columns/value_columns.h"

#include <algorithm>
#include <map>

#include "io/columns/plain_names.h"
#include "io/columns/units.h"
#include "io/columns/value_candidates.h"
#include "io/columns/value_names.h"
#include "io/columns/wavelengths.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using Says = NamedQuantity::Says;
using Rank = ValueCandidate::Rank;
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

class Values {
 public:
  Values(Columns& header, const HeaderFacts& facts, const Announce& announce)
      : header_(header), facts_(facts), announce_(announce) {}

  void place() {
    for (std::size_t k = 0; k < header_.columns.size(); ++k)
      if (header_.columns[k].kind == Column::Kind::value)
        candidates_.push_back(candidate_of(header_, k, facts_));
    part_deviations();
    if (!facts_.keeps_names) rank_by_neighbours(candidates_, header_, facts_.is_format);
    settle();
    add_channels();
    for (ValueCandidate& deviation : deviations_) place_deviation(deviation);
    add_notes();
  }

 private:
  // Refuses the table, or notes the doubt if the caller collects doubts.
  void refuse(const ValueCandidate& c, ColumnDoubt::Of of, const std::string& what) const {
    if (!facts_.doubts) throw InputError(facts_.where + ": " + what);
    facts_.doubts->push_back({of, std::size_t(c.column - header_.columns.data()), what});
  }

  // Moves the columns of standard deviations out of the candidates.
  void part_deviations() {
    std::vector<bool> is_deviation;
    note_names();
    for (const ValueCandidate& c : candidates_) {
      const std::string& name = c.column->name;
      const auto of = deviation_of(name);
      const bool is_literal = facts_.keeps_names && !name.starts_with(kSigmaPrefix);
      const bool is_of_one = of && (of->empty() || name.starts_with(kSigmaPrefix) || find(*of) ||
                                    quantity_of_column(*of).says == Says::quantity);
      is_deviation.push_back(is_of_one && !is_literal);
    }
    // The deviation of something unknown is not a channel if other columns hold values.
    for (ValueCandidate& c : candidates_)
      if (c.rank == Rank::neutral && deviation_of(c.column->name)) c.is_perhaps = true;
    std::vector<ValueCandidate> values;
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
  ValueCandidate* find(const std::string& text) {
    const auto known_by = [&](const std::string& name) -> ValueCandidate* {
      const auto at = by_name_.find(with_band_unit(name));
      return at == by_name_.end() ? nullptr : &candidates_[at->second];
    };
    ValueCandidate* const found = known_by(text);
    return found || facts_.keeps_names ? found : known_by(quantity_of_column(text).bare);
  }

  // Makes each candidate a channel, sets it aside, or refuses the table.
  void settle() {
    const bool has_values = any(candidates_, Rank::values), has_neutral = any(candidates_, Rank::neutral);
    for (ValueCandidate& c : candidates_) {
      if (facts_.keeps_names)
        keep(c);
      else if (c.rank == Rank::values || c.rank == Rank::neutral)
        state(c);
      else if (c.rank == Rank::asked)
        settle_asked(c, has_values, c.is_derived && (has_values || has_neutral));
      else if (c.rank == Rank::refused && !has_values && !has_neutral)
        settle_refused(c);
      else
        set_aside(c);
    }
  }

  // Keeps a column of a table of our own, in which column names carry no meaning.
  void keep(ValueCandidate& c) {
    const bool is_f_r = c.named.says == Says::quantity && c.named.quantity.is_f_r();
    if (c.named.says != Says::nothing && !is_f_r) outranked_.push_back(c.column->name);
    c.named.name = c.column->name;
    c.named.quantity = {&quantity_kinds()[0]};
    c.rank = Rank::values;
    kept_.push_back(&c);
  }

  void settle_asked(ValueCandidate& c, bool has_values, bool accompanies) {
    if (accompanies) return set_aside(c);
    if (facts_.stated) return state(c);
    if (has_values || !facts_.needs_values) return set_aside(c);
    refuse_quantity(c);
  }

  void settle_refused(ValueCandidate& c) {
    if (facts_.stated) return state(c);
    if (!facts_.needs_values) return set_aside(c);
    refuse_quantity(c);
  }

  // Refuses values of this quantity. If the caller collects doubts, the column becomes a channel.
  void refuse_quantity(ValueCandidate& c) {
    refuse(c, ColumnDoubt::Of::quantity, "column " + shown(c.column->name) + " " + c.refusal);
    c.named.quantity = {&quantity_kinds()[0]};
    kept_.push_back(&c);
  }

  void set_aside(ValueCandidate& c) {
    c.column->kind = Column::Kind::aside;
    aside_.push_back(c.column->name);
  }

  // Sets the quantity of a column. A quantity stated in a comment overrides the column's name. A quantity
  // stated by a title or an option must not contradict the name.
  void state(ValueCandidate& c) {
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
    const bool has_own_scale = own.kind && (own.factor != 1 || own.scale != Quantity::Scale::linear);
    const bool has_other_scale = has_own_scale && stated.quantity != plain &&
                                 (own.factor != stated.quantity.factor || own.scale != stated.quantity.scale);
    if (has_other_scale && stated.by != StatedQuantity::By::comment) return refuse_contradiction(c);
    if (has_other_scale) outranked_.push_back(c.column->name);
    own = stated.quantity == plain ? Quantity{stated.quantity.kind, own.factor, own.scale} : stated.quantity;
    if (c.named.says == Says::contradicts) outranked_.push_back(c.column->name);
  }

  // In a road table r is the reduced luminance coefficient, and q is the luminance coefficient.
  void state_road_value(ValueCandidate& c) {
    const std::string name = lower_case(trimmed(c.column->name));
    const bool is_reduced = name.starts_with('r') && (name.size() == 1 || name.find_first_of(" _*(x") == 1);
    if (!is_reduced && name != "q")
      refuse(c, ColumnDoubt::Of::quantity,
             "column " + shown(c.column->name) +
                 " of an r-table of road lighting gives no quantity: name the column r (reduced luminance "
                 "coefficient times 10^4) or q (luminance coefficient), or give --quantity");
    c.named.quantity = is_reduced ? *quantity_named("r") : Quantity{&quantity_kinds()[0]};
  }

  void refuse_contradiction(const ValueCandidate& c) const {
    const StatedQuantity& stated = *facts_.stated;
    const bool is_title = stated.by == StatedQuantity::By::title;
    refuse(c, ColumnDoubt::Of::quantity,
           "column " + shown(c.column->name) + " is " + c.named.quantity.meaning() + ", but " +
               (is_title ? "the title in " + stated.where + " gives " : "--quantity gives ") +
               shown(stated.words) + ": if the name is wrong, write '# quantity: " + printable(stated.words) +
               "' above the header row");
  }

  // Refuses two columns of one channel: 550nm and 550 nm, 0.55um and 550nm, fr and BRF.
  void refuse_twins() const {
    std::map<std::string, const ValueCandidate*> first;
    for (const ValueCandidate* c : kept_) {
      const auto [before, is_new] = first.emplace(channel_key(c->column->name), c);
      // Two equal names have a message of their own.
      if (!is_new && before->second->column->name != c->column->name)
        refuse(*c, ColumnDoubt::Of::meaning,
               "columns " + shown(before->second->column->name) + " and " + shown(c->column->name) +
                   " are one channel in two spellings or units: remove one of them, or add the sample's name "
                   "to both");
    }
  }

  void add_channels() {
    if (!facts_.keeps_names) refuse_twins();
    std::map<std::string, int> times;
    for (const ValueCandidate* c : kept_) ++times[with_band_unit(c->named.name)];
    for (ValueCandidate* c : kept_) {
      std::string name = facts_.keeps_names ? with_band_unit(c->column->name) : with_band_unit(c->named.name);
      // The words of the quantities distinguish these columns.
      if (times[name] > 1) name = with_band_unit(c->column->name);
      c->column->index = header_.channels.size();
      header_.channels.push_back(name);
      header_.quantities.push_back(c->named.quantity);
      announce_(c->column->name, name);
    }
  }

  void place_deviation(ValueCandidate& deviation) {
    Column& column = *deviation.column;
    const std::string of = *deviation_of(column.name);
    const bool is_relative = !facts_.keeps_names && unit_of_deviation_is_percent(deviation);
    const bool is_literal = column.name.starts_with(kSigmaPrefix);
    const ValueCandidate* value = of.empty() ? nullptr : find_kept(of);
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

  static bool unit_of_deviation_is_percent(const ValueCandidate& c) {
    for (const auto& [bare, unit] : ways_to_part(c.column->name))
      if (const auto named = unit_named(unit); named && named->is_percent) return true;
    return false;
  }

  const ValueCandidate* find_kept(const std::string& text) {
    ValueCandidate* const found = find(text);
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
    for (const ValueCandidate* c : kept_) {
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
  std::vector<ValueCandidate> candidates_, deviations_;
  std::map<std::string, std::size_t> by_name_;  // indices of candidates
  std::vector<ValueCandidate*> kept_;           // candidates that become channels
  std::vector<std::string> unnamed_, by_unit_, outranked_, aside_;
};

}  // namespace

void place_values(Columns& header, const HeaderFacts& facts, const Announce& announce) {
  Values(header, facts, announce).place();
}

}  // namespace brdf::io
