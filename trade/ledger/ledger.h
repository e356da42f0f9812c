// The ledger: every choice between an exact and a cheaper method, with its measured cost and error.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "brdf/names.h"
#include "io/files/json.h"

namespace brdf::trade {

// The unit to which a row's cost refers.
enum class Unit { evaluation, albedo, fit, frame };

// absolute: |a - e|; relative: |a - e|/|e|; of_peak: |a - e| divided by the maximum of the exact value over
// the lobe.
enum class Measure { absolute, relative, of_peak };

// The outcome of a claim when judged by the figures.
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

// The error of a choice.
struct Error {
  double max = 0, mean = 0, p99 = 0;
  Measure measure = Measure::absolute;
  std::string where;  // the point of the largest error
};

// The measured cost of a choice.
struct Cost {
  double seconds = 0;  // lower quartile, per unit
  double spread = 0;   // interquartile range divided by the lower quartile
  int rounds = 0;      // 0: not measured
  // Spread of the ratio to the exact choice, between pairs of neighbouring runs.
  double ratio_spread = 0;
};

// The largest error over a domain of extreme values.
struct Extreme {
  std::string domain;
  double max = 0;
};

// One choice of a question.
struct LedgerRow {
  std::string question, choice, exact;
  Unit unit = Unit::evaluation;
  Cost cost;
  double cost_ratio = 0;  // cost relative to the exact choice: median over pairs of neighbouring runs
  Error error;
  std::string quantity;               // quantity to which the error refers
  std::optional<double> image_error;  // mean |dL| / mean L over the lit pixels of the material ball
  std::string domain;
  std::vector<Extreme> extremes;
  std::string dominated_by;  // empty: on the front
  std::string note;
};

// A statement of the source documents, with the figure that judges it.
struct Claim {
  std::string source, claim;
  Standing standing = Standing::fails;
  std::string verdict, evidence;  // `standing` as text, and its reason
  std::string question, choice;   // the row with the figure
};

struct Machine {
  std::string processor, compiler, flags;
  unsigned threads = 0;
};

// All rows and claims of a run.
struct Ledger {
  bool quick = false;
  Machine machine;
  std::vector<LedgerRow> rows;
  std::vector<Claim> claims;
  std::string left_out;  // parts that the machine does not support; empty: the ledger is complete

  const LedgerRow* find(std::string_view question, std::string_view choice) const;
};

// Returns the machine and build of this program.
Machine this_machine();

// Row A dominates row B if A is not measurably more expensive (within 5 %), no error of A is larger, and A
// is cheaper by more than 5 % or has a smaller error. Sets `dominated_by` of every row to the cheapest row
// that dominates it in its question.
void mark_dominated(std::vector<LedgerRow>& rows);

// Convert, write and read a ledger. Reading throws InputError for an invalid file.
io::Json to_json(const Ledger& ledger);
Ledger ledger_from_json(const io::JsonPlace& place);
void write_ledger(const std::filesystem::path& path, const Ledger& ledger);
Ledger read_ledger(const std::filesystem::path& path);
// Reads a ledger, but returns std::nullopt for a ledger of another version.
std::optional<Ledger> read_current_ledger(const std::filesystem::path& path);

// Returns one line per row, header first. Texts are quoted.
std::string to_csv(const Ledger& ledger);

}  // namespace brdf::trade
