// The ledger: every choice between an exact and a cheaper way, with its cost and its error, both measured.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "brdf/names.h"
#include "io/files/json.h"

namespace brdf::trade {

// What a row's cost is paid for.
enum class Unit { evaluation, albedo, fit, frame };

// absolute: |a - e|; relative: |a - e|/|e|; of_peak: |a - e| over the exact value's maximum over the lobe.
enum class Measure { absolute, relative, of_peak };

// What the figures leave of a claim.
enum class Standing { holds, on_condition, fails };

}  // namespace brdf::trade

namespace brdf {
template <>
inline constexpr std::array<std::string_view, 4> kNames<trade::Unit>{"a BRDF evaluation", "an albedo",
                                                                     "a fit", "a frame"};
template <>
inline constexpr std::array<std::string_view, 3> kNames<trade::Measure>{"absolute", "relative",
                                                                        "of the peak"};
template <>
inline constexpr std::array<std::string_view, 3> kNames<trade::Standing>{"holds", "on_condition", "fails"};
}  // namespace brdf

namespace brdf::trade {

struct Error {
  double max = 0, mean = 0, p99 = 0;
  Measure measure = Measure::absolute;
  std::string where;  // the point of the largest
};

struct Cost {
  double seconds = 0;       // lower quartile, per unit
  double spread = 0;        // interquartile range over the lower quartile
  int rounds = 0;           // 0: not measured
  double ratio_spread = 0;  // of the ratio to the exact choice, from pair to pair of neighbouring runs
};

struct Extreme {
  std::string domain;
  double max = 0;
};

struct LedgerRow {
  std::string question, choice, exact;
  Unit unit = Unit::evaluation;
  Cost cost;
  double cost_ratio = 0;  // to the exact choice: median over pairs of neighbouring runs
  Error error;
  std::string quantity;               // what the error is of
  std::optional<double> image_error;  // mean |dL| / mean L over the lit pixels of the material ball
  std::string domain;
  std::vector<Extreme> extremes;
  std::string dominated_by;  // empty: on the front
  std::string note;
};

// A statement of the source documents with the figure that judges it.
struct Claim {
  std::string source, claim;
  Standing standing = Standing::fails;
  std::string verdict, evidence;  // the same in words, and why
  std::string question, choice;   // the row
};

struct Machine {
  std::string processor, compiler, flags;
  unsigned threads = 0;
};

struct Ledger {
  bool quick = false;
  Machine machine;
  std::vector<LedgerRow> rows;
  std::vector<Claim> claims;
  std::string left_out;  // what the machine lacked; empty: nothing

  const LedgerRow* find(std::string_view question, std::string_view choice) const;
};

// The machine and build that this runs on.
Machine this_machine();

// A dominates B where it is not measurably dearer (within 5 %), no error of it is larger, and one of the two
// is clearly better. Sets every row's `dominated_by` to the cheapest that dominates it in its question.
void mark_dominated(std::vector<LedgerRow>& rows);

io::Json to_json(const Ledger& ledger);
Ledger ledger_from_json(const io::JsonPlace& place);
void write_ledger(const std::filesystem::path& path, const Ledger& ledger);
Ledger read_ledger(const std::filesystem::path& path);
// The same, but nothing for a ledger of another version.
std::optional<Ledger> read_current_ledger(const std::filesystem::path& path);

// One line per row, header first; texts are quoted.
std::string to_csv(const Ledger& ledger);

}  // namespace brdf::trade
