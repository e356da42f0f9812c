#include "io/csv/dialect.h"

#include <algorithm>

#include "io/columns/plain_names.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// Returns the characters outside quotes and brackets.
std::string bare_text(std::string_view line) {
  std::string bare;
  bool is_quoted = false;
  int depth = 0;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (is_quoted) continue;
    depth += (c == '(' || c == '[') - ((c == ')' || c == ']') && depth > 0);
    if (depth == 0) bare += c;
  }
  return bare;
}

}  // namespace

bool Dialect::is_separator_line(std::string_view line) {
  if (separator_ != 0 || line.size() > 5) return false;
  const std::string text = lower_case(line);
  if (!text.starts_with("sep=")) return false;
  // A tab at the end of the line has been trimmed as a blank.
  separator_ = line.size() == 5 ? line[4] : '\t';
  is_stated_ = true;
  return true;
}

void Dialect::state_separator(char separator) {
  separator_ = separator;
  is_stated_ = true;
}

// Blanks also separate a name from its unit: "theta_i (deg)" becomes one name again. Joined names are
// stored in unquoted_.
void Dialect::join_units(std::vector<std::string_view>& names) {
  std::vector<std::string_view> joined;
  std::string* text = nullptr;  // the last name, if joined
  bool is_opened = false, is_closed = false;
  for (const std::string_view name : names) {
    const bool goes_on = (is_opened && !is_closed) || name.starts_with('(') || name.starts_with('[');
    if (!joined.empty() && goes_on) {
      if (!text) text = &unquoted_.emplace_back(joined.back());
      (*text += ' ') += name;
      joined.back() = *text;
    } else {
      joined.push_back(name);
      text = nullptr;
      is_opened = is_closed = false;
    }
    is_opened = is_opened || name.find_first_of("([") != name.npos;
    is_closed = is_closed || name.find_first_of(")]") != name.npos;
  }
  names = std::move(joined);
}

bool Dialect::split_header(std::string_view line, std::vector<std::string_view>& names) {
  if (!is_stated_) separator_ = separator_of(line);
  if (!split(line, names)) return false;
  if (separator_ == ' ') join_units(names);
  for (; names.size() > 1 && names.back().empty(); names.pop_back()) ++surplus_;
  return true;
}

char Dialect::separator_of(std::string_view line) {
  // The plain format comes first, because its channels' names may contain semicolons and brackets.
  std::vector<std::string_view> names;
  separator_ = ',';
  if (split(line, names) && has_plain_angle_names(names)) return ',';
  constexpr int kFewest = 2;  // few tables have fewer than three columns
  const std::string bare = bare_text(line);
  for (const char c : {'\t', ';', ','})
    if (std::ranges::count(bare, c) >= kFewest) return c;
  separator_ = ' ';
  names.clear();
  if (split(line, names)) join_units(names);
  for (const char c : {'\t', ';', ','})
    if (names.size() < 3 && bare.find(c) != bare.npos) return c;
  return ' ';
}

bool Dialect::split_row(std::string_view line, std::vector<std::string_view>& fields) {
  if (!split(line, fields)) return false;
  for (std::size_t k = 0; k < surplus_ && fields.size() > 1 && fields.back().empty(); ++k) fields.pop_back();
  return true;
}

bool Dialect::split(std::string_view line, std::vector<std::string_view>& fields) {
  if (line.find('"') != line.npos) return split_quoted(line, fields);
  if (separator_ == ' ')
    split_blanks(line, fields);
  else
    io::split(line, separator_, fields);
  return true;
}

bool Dialect::split_quoted(std::string_view line, std::vector<std::string_view>& fields) {
  has_quotes_ = true;
  unquoted_.clear();
  fields.clear();
  for (;;) {
    skip_blanks(line);
    if (line.starts_with('"')) {
      if (!take_quotation(line, fields)) return false;
    } else {
      const auto end = std::ranges::find_if(line, [&](char c) { return separates(c); });
      const auto size = static_cast<std::size_t>(end - line.begin());
      fields.push_back(trimmed(line.substr(0, size)));
      line.remove_prefix(size);
    }
    if (line.empty()) return true;
    line.remove_prefix(1);
  }
}

bool Dialect::take_quotation(std::string_view& line, std::vector<std::string_view>& fields) {
  std::string& text = unquoted_.emplace_back();
  for (line.remove_prefix(1);; line.remove_prefix(1)) {
    if (line.empty()) return false;
    if (line.front() == '"') {
      line.remove_prefix(1);
      if (!line.starts_with('"')) break;  // a doubled mark is one mark
    }
    text += line.front();
  }
  fields.push_back(trimmed(text));
  if (separator_ != ' ') skip_blanks(line);
  return line.empty() || separates(line.front());
}

bool Dialect::separates(char c) const {
  return c == separator_ || (separator_ == ' ' && c == '\t');
}

// A tab that is the separator is not skipped.
void Dialect::skip_blanks(std::string_view& line) const {
  line.remove_prefix(std::min(line.size(), line.find_first_not_of(separator_ == '\t' ? " " : " \t")));
}

bool Dialect::parse(std::string_view field, double& value) {
  // A field cannot contain a comma here.
  if (separator_ == ',' && !has_quotes_) return parse_number(field, value);
  const std::size_t comma = field.find(',');
  const char mark = comma != field.npos ? ',' : field.find('.') != field.npos ? '.' : '\0';
  if (mark == 0) return parse_number(field, value);
  std::string text(field);
  if (mark == ',') {
    if (text.find('.') != text.npos) return false;
    text[comma] = '.';
  }
  if (!parse_number(text, value)) return false;
  is_mixed_ = mark_ != 0 && mark != mark_;
  mark_ = mark;
  return !is_mixed_;
}

std::string Dialect::separator_in_words() const {
  if (separator_ == '\t') return "a tab";
  if (separator_ == ' ') return "blanks";
  return "'" + printable(std::string(1, separator_)) + "'";
}

std::string Dialect::differences() const {
  std::string text;
  if (separator_ != ',') text = "columns separated by " + separator_in_words();
  if (mark_ == ',') text += (text.empty() ? "" : ", ") + std::string("decimal commas");
  return text;
}

}  // namespace brdf::io
