#include "io/csv/csv_layout.h"

#include <algorithm>
#include <cmath>

#include "io/columns/plain_names.h"
#include "io/columns/wavelengths.h"
#include "io/csv/csv_header.h"
#include "io/files/error.h"
#include "io/files/near_name.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/samples/table_rules.h"

namespace brdf::io {
namespace {

constexpr std::size_t kMostLinesAbove = 100;  // most lines in which the header row is searched

Column::Kind kind_of(Meaning is) {
  switch (is) {
    case Meaning::theta_i:
    case Meaning::phi_i:
    case Meaning::theta_o:
    case Meaning::phi_o:
      return Column::Kind::angle;
    case Meaning::phase:
      return Column::Kind::phase;
    case Meaning::value:
      return Column::Kind::value;
    case Meaning::sigma:
      return Column::Kind::sigma;
    case Meaning::wavelength:
      return Column::Kind::wavelength;
    case Meaning::polarisation:
      return Column::Kind::polarisation;
    case Meaning::rotation:
      return Column::Kind::rotation;
    case Meaning::ignored:
      break;
  }
  return Column::Kind::aside;
}

std::string list_of(const std::vector<std::string_view>& names) {
  constexpr std::size_t kMost = 20;
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), kMost); ++k) text += (k ? ", " : "") + shown(names[k]);
  return text + (names.size() > kMost ? ", ... (" + std::to_string(names.size()) + ")" : "");
}

class ByLayout {
 public:
  ByLayout(const Layout& layout, const std::vector<std::string_view>& names,
           const std::optional<StatedQuantity>& stated, const std::string& where)
      : layout_(layout), names_(names), places_(names), stated_(stated), where_(where) {}

  Columns result() {
    for (const std::string_view name : names_) {
      out_.columns.emplace_back();
      out_.columns.back().kind = Column::Kind::aside;
      out_.columns.back().name = name;
    }
    taken_.resize(names_.size());
    for (const LayoutColumn& entry : layout_.columns)
      if (entry.is == Meaning::value) add_channel(entry);
    for (const LayoutColumn& entry : layout_.columns) entry.constant ? add_constant(entry) : place(entry);
    out_.in_plane = !layout_.find(Meaning::phi_i) && !layout_.find(Meaning::phase);
    add_notes();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const LayoutColumn& entry, const std::string& rule) const {
    throw InputError(layout_.file + ": " + entry.path + rule);
  }

  void add_channel(const LayoutColumn& entry) {
    const std::optional<Quantity> quantity = entry.quantity     ? entry.quantity
                                             : layout_.quantity ? layout_.quantity
                                             : stated_          ? std::optional(stated_->quantity)
                                                                : std::nullopt;
    if (!quantity)
      throw InputError(layout_.file + ": $: key \"quantity\" is missing, and " + where_ +
                       " and the lines above give no quantity: write one (known: " + known_quantities() +
                       ")");
    out_.channels.push_back(entry.channel);
    out_.quantities.push_back(*quantity);
  }

  std::size_t channel_of(const LayoutColumn& entry) const {
    return std::size_t(std::ranges::find(out_.channels, entry.channel) - out_.channels.begin());
  }

  // Sets the column's interpretation. Its name stays as in the file.
  void describe(const LayoutColumn& entry, Column& column) const {
    column.kind = kind_of(entry.is);
    column.unit = entry.unit;
    column.is_elevation = entry.from == From::surface;
    column.coverage = entry.coverage;
    column.is_relative = entry.is_relative;
    if (column.kind == Column::Kind::angle) column.index = find_angle(entry.is);
    if (entry.is != Meaning::value && entry.is != Meaning::sigma) return;
    column.index = channel_of(entry);
    if (entry.is_relative && out_.quantities[column.index].scale != Quantity::Scale::linear)
      fail(entry, ".relative: has no meaning for a logarithm of f_r: state the uncertainty in the same unit");
  }

  static std::size_t find_angle(Meaning is) {
    return std::size_t(std::ranges::find(kAngleNames, name_of(is)) - std::begin(kAngleNames));
  }

  void add_constant(const LayoutColumn& entry) {
    Column column;
    column.name = entry.path;
    describe(entry, column);
    const bool is_polar = column.kind == Column::Kind::angle && column.index % 2 == 0;
    if (is_polar && !(std::abs(column.converted(*entry.constant)) <= 90))
      fail(entry, ".constant: " + to_text(*entry.constant) + " is beyond 90 degrees from the normal");
    out_.constants.emplace_back(std::move(column), *entry.constant);
  }

  void place(const LayoutColumn& entry) {
    const auto at = places_.find(entry);
    if (!at) fail(entry, lack_of(entry));
    if (taken_[*at])
      fail(entry, ": is column " + std::to_string(*at + 1) + ", as " + taken_[*at]->path +
                      " is: remove one of the two");
    taken_[*at] = &entry;
    describe(entry, out_.columns[*at]);
  }

  // Returns the end of the message for a column that the table lacks.
  std::string lack_of(const LayoutColumn& entry) const {
    const std::string columns = "; " + where_ + " has the columns: " + list_of(names_);
    if (entry.position)
      return ".position: " + std::to_string(*entry.position) + " must be at most " +
             plural(names_.size(), "column") + columns;
    const std::size_t times = places_.count(entry.name);
    if (times > 1)
      return ".name: " + shown(entry.name) + " is the name of " + std::to_string(times) +
             " columns: give the \"position\"" + columns;
    return ".name: the table has no column " + shown(entry.name) + ": " +
           did_you_mean(entry.name, {names_.begin(), names_.end()}) + "correct the name" + columns;
  }

  void add_notes() {
    std::string read_as, unread;
    for (std::size_t k = 0; k < names_.size(); ++k) {
      const Column& column = out_.columns[k];
      if (!taken_[k]) {
        (unread += unread.empty() ? "" : ", ") += shown(names_[k]);
        continue;
      }
      const Meaning is = taken_[k]->is;
      if (is == Meaning::ignored) continue;
      std::string ours(name_of(is));
      if (is == Meaning::value) ours = out_.channels[column.index];
      if (is == Meaning::sigma) ours = std::string(kSigmaPrefix) + out_.channels[column.index];
      if (ours != names_[k]) (read_as += read_as.empty() ? "" : ", ") += shown(names_[k]) + " " + ours;
    }
    if (!read_as.empty()) out_.notes.push_back("read by the layout: " + read_as);
    if (!unread.empty()) out_.notes.push_back("not in the layout, and ignored: " + unread);
    for (std::size_t c = 0; c < out_.channels.size(); ++c)
      if (!out_.quantities[c].is_f_r())
        out_.assume("channel " + shown(out_.channels[c]) + " is " + out_.quantities[c].meaning() + ": " +
                    out_.quantities[c].operation());
    for (const std::string& guess : layout_.guesses) out_.assume(guess);
  }

  const Layout& layout_;
  const std::vector<std::string_view>& names_;
  const ColumnPlaces places_;
  const std::optional<StatedQuantity>& stated_;
  const std::string& where_;
  Columns out_;
  std::vector<const LayoutColumn*> taken_;  // [column] the entry that denotes the column
};

}  // namespace

ColumnPlaces::ColumnPlaces(const std::vector<std::string_view>& names) : width_(names.size()) {
  for (std::size_t k = 0; k < names.size(); ++k)
    if (const auto [at, is_new] = by_name_.emplace(names[k], Place{k, 1}); !is_new) ++at->second.count;
}

std::optional<std::size_t> ColumnPlaces::find(const LayoutColumn& entry) const {
  if (entry.position) return *entry.position <= width_ ? std::optional(*entry.position - 1) : std::nullopt;
  const auto at = by_name_.find(entry.name);
  return at == by_name_.end() || at->second.count > 1 ? std::nullopt : std::optional(at->second.first);
}

std::size_t ColumnPlaces::count(std::string_view name) const {
  const auto at = by_name_.find(name);
  return at == by_name_.end() ? 0 : at->second.count;
}

std::size_t ColumnPlaces::count(const Layout& layout) const {
  return std::size_t(std::ranges::count_if(
      layout.columns, [&](const LayoutColumn& entry) { return !entry.constant && find(entry).has_value(); }));
}

Columns columns_by_layout(const Layout& layout, const std::vector<std::string_view>& names,
                          const std::optional<StatedQuantity>& stated, const std::string& where) {
  return ByLayout(layout, names, stated, where).result();
}

std::optional<Layout> layout_for(const std::string& name, const Supplied& supplied) {
  if (supplied.layout.empty()) return std::nullopt;
  Layout layout = read_layout(supplied.layout);
  if (layout.quantity && !supplied.quantity.empty())
    throw InputError(name + ": --quantity " + supplied.quantity + ": " + layout.file +
                     " states the quantity, too ($.quantity): give one of the two");
  if (layout.mirror_side != MirrorSide::automatic && supplied.mirror_side != MirrorSide::automatic)
    throw InputError(name + ": --mirror-side: " + layout.file +
                     " states the side, too ($.mirror_side): give one of the two");
  return layout;
}

// Finds the header row. Lines above it are titles and comments.
bool CsvHeader::read_by_layout(std::string_view line) {
  const Layout& layout = *layout_;
  if (layout.separator) dialect_.state_separator(*layout.separator);
  if (layout.decimal) dialect_.state_mark(*layout.decimal);
  if (layout.header == 0u) {
    use_layout({}, line);
    return true;
  }
  if (last_comment_line_ > 0 && is_header_by_layout(last_comment_, last_comment_line_)) {
    if (!table_.metadata.empty()) table_.metadata.pop_back();
    use_layout(last_comment_, {});
    return true;
  }
  const std::size_t wanted = line_of_header(line);
  while (reader_.line() < wanted) {
    if (!line.empty()) line.starts_with(layout.comment) ? read_comment(line) : add_title(line);
    if (!reader_.next(line)) break;
    line = trimmed(line);
  }
  use_layout(line, {});
  return false;
}

bool CsvHeader::is_header_by_layout(std::string_view line, std::size_t number) const {
  if (layout_->header) return *layout_->header == number;
  Dialect dialect = dialect_;
  std::vector<std::string_view> names;
  if (!dialect.split_header(line, names)) return false;
  const auto columns = std::size_t(std::ranges::count_if(
      layout_->columns, [](const LayoutColumn& entry) { return !entry.constant.has_value(); }));
  return ColumnPlaces(names).count(*layout_) == columns;
}

// Returns the number of the line with the header row: the first line that has all columns of the layout,
// otherwise the first line that has most of them. `line`: the current line.
std::size_t CsvHeader::line_of_header(std::string_view line) const {
  LineReader ahead = reader_;
  std::size_t best = ahead.line(), most = 0;
  for (std::size_t lines = 0; lines < kMostLinesAbove; ++lines) {
    const bool is_line = !line.empty() && !line.starts_with(layout_->comment);
    if (is_line && is_header_by_layout(line, ahead.line())) return ahead.line();
    Dialect dialect = dialect_;
    std::vector<std::string_view> names;
    if (is_line && !layout_->header && dialect.split_header(line, names))
      if (const std::size_t count = ColumnPlaces(names).count(*layout_); count > most) {
        most = count;
        best = ahead.line();
      }
    if (!ahead.next(line)) break;
    line = trimmed(line);
  }
  if (layout_->header)
    throw InputError(layout_->file + ": $.header: line " + std::to_string(*layout_->header) + " of " +
                     reader_.content().name +
                     " is not the header row: the line must have text, and no rows may precede it");
  return best;
}

// Refuses a quantity of the file that differs from the layout's. Words that are unknown decide nothing.
void CsvHeader::compare_with_layout(std::string_view words) {
  const auto stated = quantity_named(words);
  if (stated && *stated != *layout_->quantity)
    fail("the quantity " + shown(words) + " contradicts $.quantity of " + layout_->file + ", " +
         layout_->quantity->meaning() + ": correct one of the two");
}

// `names`: the header row. If the table has no header row, `row` is the first row, whose columns get numbers.
void CsvHeader::use_layout(std::string_view names, std::string_view row) {
  std::vector<std::string_view> fields;
  if (!dialect_.split_header(row.empty() ? names : row, fields)) fail(std::string(kBadQuotation));
  check_width(fields.size());
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < fields.size(); ++k)
    texts.push_back(row.empty() ? std::string(fields[k]) : "column " + std::to_string(k + 1));
  const std::string where = row.empty() ? "the header row (" + reader_.where() + ")" : reader_.where();
  columns_ = columns_by_layout(*layout_, {texts.begin(), texts.end()}, stated_.result(), where);
  HeaderFacts facts{where, std::nullopt, true, {}};
  if (row.empty()) look_ahead(texts, facts);  // skips a row of units
  is_long_ = layout_->find(Meaning::wavelength) || layout_->find(Meaning::polarisation);
  table_.channels = columns_.channels;
  check_channel_names(table_.channels, layout_->file);
}

}  // namespace brdf::io
