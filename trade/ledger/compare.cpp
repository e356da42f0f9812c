#include "trade/ledger/compare.h"

#include <algorithm>
#include <cstdio>
#include <functional>

#include "io/files/error.h"

namespace brdf::trade {
namespace {

constexpr std::size_t kShown = 10;  // rows printed on the terminal

std::string row_name(const LedgerRow& row) {
  return row.question + ": " + row.choice;
}

}  // namespace

double CostPair::difference() const {
  return std::max(before, after) / std::min(before, after) - 1;
}

std::size_t Comparison::apart() const {
  return std::size_t(std::ranges::count_if(
      compared, [](const CostPair& pair) { return !(pair.difference() <= kLargestDifference); }));
}

Comparison compare(const Ledger& before, const Ledger& after) {
  if (before.quick != after.quick)
    throw InputError(
        "one ledger is of a quick run, the other of a full run: the sizes of frames and fits differ");
  Comparison c;
  for (const LedgerRow& row : before.rows) {
    const LedgerRow* const other = after.find(row.question, row.choice);
    if (!other)
      c.missing.push_back(row_name(row));
    else if (std::min(row.cost.seconds, other->cost.seconds) < kLeastCompared)
      ++c.shorter;
    else
      c.compared.push_back({row.question, row.choice, row.unit, row.cost_ratio, other->cost_ratio});
  }
  for (const LedgerRow& row : after.rows)
    if (!before.find(row.question, row.choice)) c.missing.push_back(row_name(row));
  std::ranges::stable_sort(c.compared, std::greater(), &CostPair::difference);
  return c;
}

io::Json to_json(const Comparison& c) {
  io::Json rows = io::Json::array();
  for (const CostPair& pair : c.compared)
    rows.push_back({{"question", pair.question},
                    {"choice", pair.choice},
                    {"unit", name_of(pair.unit)},
                    {"before", pair.before},
                    {"after", pair.after},
                    {"difference", pair.difference()}});
  return {{"rows", std::move(rows)},
          {"apart", c.apart()},
          {"missing", c.missing},
          {"below_1_ns", c.shorter},
          {"largest_difference", kLargestDifference}};
}

std::string to_terminal(const Comparison& c) {
  std::string text;
  char line[256];
  std::snprintf(line, sizeof line, "%-42s %-44s %9s %9s %7s\n", "question", "choice", "before", "after",
                "apart");
  text += line;
  for (std::size_t k = 0; k < std::min(kShown, c.compared.size()); ++k) {
    const CostPair& pair = c.compared[k];
    std::snprintf(line, sizeof line, "%-42.42s %-44.44s %9.4g %9.4g %5.0f %%\n", pair.question.c_str(),
                  pair.choice.c_str(), pair.before, pair.after, 100 * pair.difference());
    text += line;
  }
  for (std::size_t unit = 0; unit < kNames<Unit>.size(); ++unit) {
    std::size_t rows = 0, apart = 0;
    for (const CostPair& pair : c.compared)
      if (pair.unit == Unit(unit)) {
        ++rows;
        apart += !(pair.difference() <= kLargestDifference);
      }
    if (rows == 0) continue;
    std::snprintf(line, sizeof line, "%s: %zu of %zu rows above 1 ns agree in cost ratio within %.0f %%\n",
                  std::string(kNames<Unit>[unit]).c_str(), rows - apart, rows, 100 * kLargestDifference);
    text += line;
  }
  std::snprintf(line, sizeof line, "%zu rows below 1 ns are not compared; %zu are in one ledger only\n",
                c.shorter, c.missing.size());
  return text + line;
}

}  // namespace brdf::trade
