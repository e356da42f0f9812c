#include "io/formats/budget.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/csv/dialect.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/near_name.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// A source with a meaning of its own.
struct KnownSource {
  std::string_view name;
  BudgetUnit unit;
  BudgetEffect effect;
};
constexpr std::array kKnownSources{
    KnownSource{"reference_standard", BudgetUnit::relative, BudgetEffect::scale},
    KnownSource{"repeatability", BudgetUnit::relative, BudgetEffect::scale},
    KnownSource{"zero_theta_i", BudgetUnit::degree, BudgetEffect::theta_i},
    KnownSource{"zero_theta_o", BudgetUnit::degree, BudgetEffect::theta_o},
    KnownSource{"reading_theta_i", BudgetUnit::degree, BudgetEffect::theta_i},
    KnownSource{"reading_theta_o", BudgetUnit::degree, BudgetEffect::theta_o},
    KnownSource{"linearity", BudgetUnit::relative_per_factor_e, BudgetEffect::linearity},
    KnownSource{"stray_light", BudgetUnit::per_steradian, BudgetEffect::stray_light},
};

constexpr std::array<std::string_view, 4> kColumns{"source", "standard_uncertainty", "unit", "shared_by"};
constexpr std::string_view kDividedBy = "divided_by";  // the key of the comment with a meaning
// The largest standard uncertainties: beyond them no value is known.
constexpr double kMostDegrees = 90, kMostUncertainty = 1000;
constexpr std::string_view kExample = "reference_standard,0.005,relative,table";

class BudgetReader {
 public:
  explicit BudgetReader(const Content& content) : lines_(content) {
    budget_.file = content.name;
    budget_.text = content.bytes;
  }

  Budget read() {
    for (std::string_view line; lines_.next(line);) {
      line = trimmed(line);
      if (line.empty()) continue;
      if (line.front() == '#')
        read_comment(parse_comment(line.substr(1)));
      else if (!has_header_)
        read_header(line);
      else
        read_source(line);
    }
    if (!has_header_) fail_file("holds no header row; it must be " + header_text());
    if (budget_.sources.empty())
      fail_file("holds no source of uncertainty; a line is, for example, " + std::string(kExample));
    if (std::ranges::all_of(budget_.sources, [](const auto& s) { return s.standard_uncertainty == 0; }))
      fail_file(
          "states no uncertainty, because every standard_uncertainty is 0: give a source a number above "
          "0, or leave the budget out");
    return std::move(budget_);
  }

 private:
  [[noreturn]] void fail(const std::string& rule) const { throw InputError(lines_.where() + ": " + rule); }
  [[noreturn]] void fail_file(const std::string& rule) const {
    throw InputError(budget_.file + ": the budget " + rule);
  }
  static std::string header_text() { return joined({kColumns.begin(), kColumns.end()}); }

  void read_comment(const Comment& comment) {
    if (comment.first != kDividedBy) return refuse_misspelt(comment);
    budget_.divides_by_cos_i = budget_.divides_by_cos_o = false;
    std::vector<std::string_view> words;
    split_blanks(comment.second, words);
    for (const std::string_view word : words) {
      if (word == "cos_theta_i")
        budget_.divides_by_cos_i = true;
      else if (word == "cos_theta_o")
        budget_.divides_by_cos_o = true;
      else if (word != "nothing" || words.size() > 1)
        fail("divided_by: " + shown(word) +
             " must be cos_theta_i, cos_theta_o, both with a blank between them, or nothing");
    }
  }

  // Refuses a comment that seems to be the one with a meaning. Other comments are free text.
  void refuse_misspelt(const Comment& comment) const {
    const std::string_view text = comment.first.empty() ? comment.second : comment.first;
    std::string key = lower_case(text.substr(0, text.find('=')));
    std::ranges::replace_if(
        key, [](char c) { return c == ' ' || c == '-'; }, '_');
    const std::vector<std::string> known{std::string(kDividedBy)};
    if (!key.starts_with("divid") && did_you_mean(key, known).empty()) return;
    fail("the comment " + shown(std::string(text)) + " is not read; the cosines are stated as '# " +
         std::string(kDividedBy) + ": cos_theta_i cos_theta_o'");
  }

  // Refuses a column that is neither one of a budget nor one of remarks.
  void refuse_unknown(const std::vector<std::string_view>& names) const {
    constexpr std::array<std::string_view, 8> kRemarks{"comment", "comments",    "remark",    "remarks",
                                                       "note",    "description", "reference", "notes"};
    for (const std::string_view name : names)
      if (std::ranges::find(kColumns, name) == kColumns.end() &&
          std::ranges::find(kRemarks, lower_case(trimmed(name))) == kRemarks.end())
        fail("the column " + shown(std::string(name)) + " is not one of a budget (" + header_text() +
             "): remove it, or name it 'note' if it is a remark");
  }

  void read_header(std::string_view line) {
    std::vector<std::string_view> names;
    if (!dialect_.split_header(line, names)) fail(std::string(kBadQuotation));
    for (std::size_t k = 0; k < kColumns.size(); ++k) {
      const auto found = std::ranges::find(names, kColumns[k]);
      if (found == names.end())
        fail("a budget needs the column " + std::string(kColumns[k]) + "; its header row must be " +
             header_text());
      if (std::ranges::count(names, kColumns[k]) > 1)
        fail("the column " + std::string(kColumns[k]) + " is there twice: remove one of them");
      column_[k] = std::size_t(found - names.begin());
    }
    refuse_unknown(names);
    width_ = names.size();
    has_header_ = true;
  }

  void read_source(std::string_view line) {
    std::vector<std::string_view> fields;
    if (!dialect_.split_row(line, fields)) fail(std::string(kBadQuotation));
    if (fields.size() != width_)
      fail(std::to_string(fields.size()) + " columns, but " + std::to_string(width_) + " are expected");
    BudgetSource source;
    source.name = std::string(trimmed(fields[column_[0]]));
    if (source.name.empty()) fail("the source has no name");
    if (std::ranges::find(budget_.sources, source.name, &BudgetSource::name) != budget_.sources.end())
      fail("the source " + shown(source.name) +
           " is listed twice: give each source once, with one standard uncertainty");
    source.unit = member<BudgetUnit>(fields[column_[2]], "unit");
    const std::string_view number = fields[column_[1]];
    const double most = source.unit == BudgetUnit::degree ? kMostDegrees : kMostUncertainty;
    if (!dialect_.parse(number, source.standard_uncertainty) ||
        !(source.standard_uncertainty >= 0 && source.standard_uncertainty <= most))
      fail("standard_uncertainty " + shown(number) + " of " + shown(source.name) +
           " must be a number from 0 to " + to_text(most));
    source.shared_by = member<SharedBy>(fields[column_[3]], "shared_by");
    source.effect = effect_of(source);
    budget_.sources.push_back(std::move(source));
  }

  template <class Enum>
  Enum member(std::string_view field, const char* column) const {
    const std::string_view word = trimmed(field);
    if (const std::optional<Enum> found = find_named<Enum>(word)) return *found;
    fail(std::string(column) + " " + shown(word) + " must be one of " + known_names<Enum>());
  }

  BudgetEffect effect_of(const BudgetSource& source) const {
    const auto known = std::ranges::find(kKnownSources, source.name, &KnownSource::name);
    if (known != kKnownSources.end()) {
      if (source.unit != known->unit)
        fail("the unit of " + source.name + " must be " + std::string(name_of(known->unit)));
      return known->effect;
    }
    if (source.unit == BudgetUnit::relative) return BudgetEffect::scale;
    std::vector<std::string> names;
    for (const KnownSource& k : kKnownSources)
      if (k.unit == source.unit) names.emplace_back(k.name);
    fail("the source " + shown(source.name) + " is not known in the unit " +
         std::string(name_of(source.unit)) + ": " + did_you_mean(source.name, names) +
         "a source of this unit is one of " + joined(names) + "; any other source must be relative");
  }

  LineReader lines_;
  Dialect dialect_;
  Budget budget_;
  bool has_header_ = false;
  std::array<std::size_t, kColumns.size()> column_{};
  std::size_t width_ = 0;
};

}  // namespace

Budget read_budget(Content content) {
  make_utf8(content);
  return BudgetReader(content).read();
}

Budget read_budget(const std::filesystem::path& path) {
  constexpr std::size_t kLargestBudget = std::size_t(1) << 20;
  return read_budget(read_content(path, kLargestBudget));
}

std::optional<Budget> stated_budget(const SampleTable& table) {
  const std::optional<std::string> named = table.find_metadata(kBudgetKey);
  if (!named) return std::nullopt;
  const std::string asks = table.name() + ": the comment # budget: ";
  if (trimmed(*named).empty()) throw InputError(asks + "names no file: name one, or remove the comment");
  try {
    return read_budget(path_beside(table.source, *named));
  } catch (const InputError& error) {
    throw InputError(asks + *named + ": " + error.what());
  }
}

std::string stated_budget_text(const Content& table) {
  LineReader lines(table);
  for (std::string_view line; lines.next(line) && line.starts_with('#');) {
    const Comment comment = parse_comment(line.substr(1));
    if (comment.first != kBudgetKey) continue;
    try {
      return read_content(path_beside(table.name, comment.second)).bytes;
    } catch (const std::exception&) {
      return {};  // the table itself is then refused
    }
  }
  return {};
}

}  // namespace brdf::io
