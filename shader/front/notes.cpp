#include "shader/front/notes.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/text.h"
#include "shader/front/definitions.h"

namespace brdf::shader {
namespace {

double number_of(std::string_view word, const std::string& where) {
  double value;
  if (!io::parse_number(word, value) || !std::isfinite(value))
    throw InputError(where + io::shown(word) + " is not a finite number");
  return value;
}

std::optional<Role> role_of(std::string_view word) {
  return find_named<Role>(std::string(word));
}

// The words after a parameter's name: numbers, then "log" and "role ROLE".
struct NoteWords {
  std::vector<double> numbers;
  bool log_scale = false;
  Role role = Role::other;
};
NoteWords read_words(std::span<const std::string_view> words, const std::string& where) {
  NoteWords out;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] == "log") {
      out.log_scale = true;
    } else if (words[k] == "role") {
      const auto role = k + 1 < words.size() ? role_of(words[k + 1]) : std::nullopt;
      if (!role) throw InputError(where + "role must be one of " + known_names<Role>());
      out.role = *role;
      ++k;
    } else {
      out.numbers.push_back(number_of(words[k], where));
    }
  }
  return out;
}

void check(const Declared& p, const std::string& where) {
  if (p.min && p.max && !(*p.min <= *p.max))
    throw InputError(where + p.name + ": the minimum is above the maximum");
  for (const double value : p.initial)
    if ((p.min && value < *p.min) || (p.max && value > *p.max))
      throw InputError(where + p.name + ": the default is outside the range");
  if (p.log_scale && p.max && !(*p.max > 0))
    throw InputError(where + p.name + ": a log scale needs values above 0");
}

// Reads "CHECK [up to VALUE] [at THETA] STATEMENT".
KnownViolation read_violation(std::span<const std::string_view> words, std::uint32_t line,
                              const std::string& where) {
  if (words.empty())
    throw InputError(where +
                     "violates must be followed by the name of a check, such as energy or reciprocity");
  KnownViolation v{std::string(words[0]), "", 0, 0, line};
  words = words.subspan(1);
  if (words.size() > 2 && words[0] == "up" && words[1] == "to") {
    v.most = number_of(words[2], where);
    words = words.subspan(3);
  }
  if (words.size() > 1 && words[0] == "at") {
    v.theta = number_of(words[1], where);
    words = words.subspan(2);
  }
  for (const std::string_view word : words)
    v.statement += (v.statement.empty() ? "" : " ") + std::string(word);
  return v;
}

}  // namespace

// Reads "param NAME MIN MAX DEFAULT [log] [role R]", "bool NAME 0|1", "color NAME r g b" (the last two also
// as "param NAME bool 0|1" and "param NAME color r g b"), and BRDF Explorer's "float NAME MIN MAX DEFAULT".
Declared read_declared(std::string_view kind, std::span<const std::string_view> words, std::uint32_t line,
                       const std::string& where) {
  if (words.empty()) throw InputError(where + "the name of the parameter is missing");
  if (kind == "param" && words.size() > 1 && (words[1] == "color" || words[1] == "bool")) {
    std::vector<std::string_view> rest(words.begin(), words.end());
    rest.erase(rest.begin() + 1);
    return read_declared(words[1], rest, line, where);
  }
  const NoteWords w = read_words(words.subspan(1), where);
  Declared p{std::string(words[0])};
  p.line = line;
  p.log_scale = w.log_scale;
  p.role = w.role;
  const std::size_t count = w.numbers.size();
  if (kind == "bool") {
    if (count > 1) throw InputError(where + "a bool has one default, 0 or 1");
    p.min = 0, p.max = 1;
    p.boolean = true;
    p.initial = {count == 1 && w.numbers[0] != 0 ? 1.0 : 0.0};
  } else if (kind == "color") {
    if (count != 3 && count != 1) throw InputError(where + "a color has three numbers");
    p.min = 0, p.max = std::max(1.0, *std::ranges::max_element(w.numbers));
    p.initial = w.numbers;
  } else {
    if (count != 2 && count != 3) throw InputError(where + "must be NAME MIN MAX DEFAULT [log]");
    p.min = w.numbers[0], p.max = w.numbers[1];
    if (count == 3) p.initial = {w.numbers[2]};
  }
  check(p, where);
  return p;
}

namespace {

// Sets what one line of a file states. Throws InputError for a second line, which would contradict the first.
template <class Stated, class Parse>
void state_once(std::optional<Stated>& stated, std::string_view key, const std::string& where, Parse parse) {
  if (stated)
    throw InputError(where + "//: " + std::string(key) + " is there twice: remove one of the lines");
  try {
    stated = parse();
  } catch (const InputError& error) {
    throw InputError(where + error.what());
  }
}

void add_parameter(Source& source, Declared p, const std::string& where) {
  if (std::ranges::find(source.parameters, p.name, &Declared::name) != source.parameters.end())
    throw InputError(where + "the parameter " + p.name + " is there twice: remove one of the lines");
  source.parameters.push_back(std::move(p));
}

}  // namespace

// Reads a line that begins with //: and is meant for this program.
void read_note(Source& source, std::string_view line, std::uint32_t number) {
  const std::string where = source.name + ":" + std::to_string(number) + ": ";
  std::vector<std::string_view> words;
  io::split_blanks(io::trimmed(line), words);
  if (words.empty()) return;
  const std::string rest(io::trimmed(io::trimmed(line).substr(words[0].size())));
  const auto second = [&] { return std::string(io::trimmed(rest.substr(words[1].size()))); };
  if (words[0] == "param" || words[0] == "bool" || words[0] == "color")
    add_parameter(source,
                  read_declared(words[0], std::span<const std::string_view>(words).subspan(1), number, where),
                  where);
  else if (words[0] == "entry")
    state_once(source.entry, "entry", where, [&] { return parse_entry(rest); });
  else if (words[0] == "returns")
    state_once(source.returns, "returns", where, [&] { return parse_returns(rest); });
  else if (words[0] == "sample" && words.size() > 1 && words[1] == "returns")
    state_once(source.sample_returns, "sample returns", where, [&] { return parse_sample_value(second()); });
  else if (words[0] == "pdf" && words.size() > 1 && words[1] == "per")
    state_once(source.density_of, "pdf per", where, [&] { return parse_density_of(second()); });
  else if (words[0] == "sample")
    state_once(source.sample, "sample", where, [&] { return parse_entry(rest); });
  else if (words[0] == "pdf")
    state_once(source.pdf, "pdf", where, [&] { return parse_entry(rest); });
  else if (words[0] == "violates")
    source.violations.push_back(
        read_violation(std::span<const std::string_view>(words).subspan(1), number, where));
  else
    throw InputError(where + "//: " + std::string(words[0]) +
                     ": must be param, bool, color, entry, returns, sample, pdf or violates");
}

Declared parse_parameter(const std::string& text) {
  const std::string where = "--param '" + text + "': ";
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0)
    throw InputError(where + "must be NAME=MIN:MAX or NAME=MIN:MAX:DEFAULT, with :log for a log scale");
  std::vector<std::string_view> fields;
  io::split(std::string_view(text).substr(equals + 1), ':', fields);
  Declared p{std::string(io::trimmed(std::string_view(text).substr(0, equals)))};
  if (!fields.empty() && fields.back() == "log") {
    p.log_scale = true;
    fields.pop_back();
  }
  if (fields.size() < 2 || fields.size() > 3)
    throw InputError(where + "must be NAME=MIN:MAX or NAME=MIN:MAX:DEFAULT, with :log for a log scale");
  p.min = number_of(fields[0], where), p.max = number_of(fields[1], where);
  if (fields.size() == 3) p.initial = {number_of(fields[2], where)};
  check(p, where);
  return p;
}

EntryLine parse_entry(const std::string& text) {
  EntryLine entry{std::string(io::trimmed(text))};
  const std::size_t open = text.find('(');
  if (open != text.npos) {
    const std::size_t close = text.find(')', open);
    if (close == text.npos) throw InputError("entry '" + text + "': must be NAME or NAME(L, V, N, ...)");
    entry.name = io::trimmed(std::string_view(text).substr(0, open));
    std::vector<std::string_view> fields;
    io::split(std::string_view(text).substr(open + 1, close - open - 1), ',', fields);
    entry.arguments.emplace();
    for (const std::string_view field : fields)
      if (!field.empty()) entry.arguments->emplace_back(field.substr(field.find_last_of(" \t") + 1));
  }
  // SPIR-V without names numbers its functions: %16.
  const std::string_view name = std::string_view(entry.name).substr(entry.name.starts_with('%') ? 1 : 0);
  if (name.empty() || !std::ranges::all_of(name, is_word))
    throw InputError("entry '" + text + "': must be NAME or NAME(L, V, N, ...)");
  return entry;
}

Returns parse_returns(const std::string& text) {
  std::string word;
  for (const char c : text)
    if (c != ' ') word += c;
  const auto found = find_named<Returns>(word);
  if (!found) throw InputError("returns '" + text + "': must be one of " + known_names<Returns>());
  return *found;
}

SampleValue parse_sample_value(const std::string& text) {
  std::string word;
  for (const char c : text)
    if (c != ' ') word += c;
  const auto found = find_named<SampleValue>(word);
  if (!found) throw InputError("sample returns '" + text + "': must be one of " + known_names<SampleValue>());
  return *found;
}

DensityOf parse_density_of(const std::string& text) {
  const auto found = find_named<DensityOf>(text);
  if (!found) throw InputError("pdf per '" + text + "': must be one of " + known_names<DensityOf>());
  return *found;
}

}  // namespace brdf::shader
