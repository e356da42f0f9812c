#include "io/formats/table_scan.h"

#include <algorithm>
#include <cmath>

#include "io/columns/layout.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/samples/fill_values.h"

namespace brdf::io {
namespace {

using Fields = std::vector<std::string_view>;

}  // namespace

void ColumnFacts::add(double number) {
  least = numbers ? std::min(least, number) : number;
  largest = numbers ? std::max(largest, number) : number;
  ++numbers;
  if (times.size() < kMostDistinct || times.contains(number) || is_fill_value(number)) ++times[number];
}

void ColumnFacts::add(std::string_view word) {
  ++words;
  if (word_list.size() < kMostWords) word_list.emplace(word);
}

double ColumnFacts::largest_size() const {
  return std::max(std::abs(least), std::abs(largest));
}

std::string ColumnFacts::in_words() const {
  if (numbers == 0) return words > 0 ? "holds no numbers" : "is empty";
  if (least == largest) return "holds the number " + short_number(least, 6) + " only";
  const std::string many = times.size() >= kMostDistinct ? "at least " : "";
  return "holds " + many + std::to_string(times.size()) + " different numbers from " +
         short_number(least, 6) + " to " + short_number(largest, 6);
}

TableScan::TableScan(const Content& text)
    : text_(text), reader_(text), header_(reader_, dialect_, table_, true, Supplied{}) {}

void TableScan::find_comment_sign() {
  LineReader ahead = reader_;
  std::string_view line;
  if (!ahead.next(line)) return;
  for (const char* sign : {"%", "//", "!", "*", ";"})
    if (trimmed(line).starts_with(sign)) comment_ = sign;
  if (!comment_.empty()) header_.set_comment_sign(comment_);
}

void TableScan::read() {
  std::string_view whole;
  while (reader_.next(whole)) {
    const std::string_view line = trimmed(whole);
    if (line.empty()) continue;
    if (line.starts_with(header_.comment_sign())) {
      if (!has_header_) header_.read_comment(line);
    } else if (has_header_) {
      read_row(line);
    } else if (!dialect_.is_separator_line(line)) {
      read_header(line);
    }
  }
  if (!has_header_ || facts_.empty() ||
      std::ranges::none_of(facts_, [](const ColumnFacts& f) { return f.numbers > 0; }))
    throw InputError(text_.name + ": is not a table of columns of numbers");
}

void TableScan::read_header(std::string_view line) {
  has_header_ = true;
  const bool is_row = header_.read_for_proposal(line, doubts_);
  if (header_.matrix())
    throw InputError(text_.name +
                     ": is a matrix of two angles, which is read without a layout; a layout describes "
                     "tables with a row for each pair of directions");
  if (found().is_road)
    throw InputError(text_.name +
                     ": is an r-table of road lighting, which is read without a layout; a layout has no "
                     "entry for the tangent of an angle");
  Fields fields;
  is_without_header_ = columns().empty();
  if (is_without_header_) dialect_.split_header(line, fields);
  const std::size_t width = std::max(columns().size(), fields.size());
  if (width > kMostLayoutEntries)
    throw InputError(text_.name + ": " + std::to_string(width) + " columns exceed the limit of " +
                     std::to_string(kMostLayoutEntries) + " entries of a layout");
  facts_.resize(is_without_header_ ? fields.size() : columns().size());
  if (is_row) read_row(line);
}

void TableScan::read_row(std::string_view line) {
  Fields fields;
  if (!dialect_.split_row(line, fields) || fields.size() != facts_.size()) return;
  const bool is_fill = lines_of_fill_.contains(std::uint32_t(reader_.line()));
  for (std::size_t k = 0; k < fields.size(); ++k) {
    double number;
    if (!dialect_.parse(fields[k], number)) {
      facts_[k].add(fields[k]);
      continue;
    }
    facts_[k].add(number);
    if (is_fill && columns()[k].kind == Column::Kind::value) ++fill_[number];
  }
}

std::vector<double> TableScan::read_numbers_in(const std::vector<std::uint32_t>& lines) {
  constexpr std::size_t kFewest = 3;
  lines_of_fill_.insert(lines.begin(), lines.end());
  read();
  std::vector<double> numbers;
  for (const auto& [number, times] : fill_)
    if (times >= kFewest) numbers.push_back(number);
  return numbers;
}

const ColumnDoubt* TableScan::doubt(std::size_t column, ColumnDoubt::Of of) const {
  const auto match =
      std::ranges::find_if(doubts_, [&](const ColumnDoubt& d) { return d.column == column && d.of == of; });
  return match == doubts_.end() ? nullptr : &*match;
}

}  // namespace brdf::io
