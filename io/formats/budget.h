// The uncertainty budget of an instrument: the sources of error that the scatter of its rows does not show.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "brdf/names.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io {

// The unit of a standard uncertainty. per_steradian is that of a constant added to every value.
// relative_per_factor_e is the relative error per factor of e between a signal and the largest signal.
enum class BudgetUnit { relative, degree, per_steradian, relative_per_factor_e };
// The rows that one error of a source moves together: all rows, the rows of a direction of incidence, or a
// single row.
enum class SharedBy { table, light, row };
// The reading that an error of the source changes: its scale, one of its polar angles, its linearity, or a
// constant that is added to it.
enum class BudgetEffect { scale, theta_i, theta_o, linearity, stray_light };

}  // namespace brdf::io

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 4> kNames<io::BudgetUnit>{"relative", "degree", "1/sr",
                                                                        "relative_per_factor_e"};
template <>
inline constexpr std::array<std::string_view, 3> kNames<io::SharedBy>{"table", "light", "row"};

}  // namespace brdf

namespace brdf::io {

struct BudgetSource {
  std::string name;
  double standard_uncertainty = 0;  // in `unit`, at least 0
  BudgetUnit unit = BudgetUnit::relative;
  SharedBy shared_by = SharedBy::table;
  BudgetEffect effect = BudgetEffect::scale;
};

// Sources of error that are independent of each other.
struct Budget {
  std::string file;
  std::string text;  // the content of the file, for fingerprints
  std::vector<BudgetSource> sources;
  // Whether the instrument divides its reading by the nominal cosine of the angle of incidence, and of the
  // viewing angle. An error of the angle is then an error of the cosine too.
  bool divides_by_cos_i = false, divides_by_cos_o = true;
};

// Reads a table with the columns source, standard_uncertainty, unit and shared_by. Sources with a meaning of
// their own are reference_standard, repeatability (relative), zero_theta_i, zero_theta_o, reading_theta_i,
// reading_theta_o (degree), linearity (relative_per_factor_e) and stray_light (1/sr). Any other source must
// be relative, and is an error of the scale. A comment `# divided_by: cos_theta_i cos_theta_o` names the
// cosines by which the instrument divides; without it, it is cos_theta_o. Throws InputError with the file and
// the line if the table cannot be read, a source or a column is listed twice, a number is negative or above
// 1000 (degrees: 90), all numbers are 0, or a unit is unknown or is not that of the source.
Budget read_budget(Content content);
Budget read_budget(const std::filesystem::path& path);

// Reads the budget that a comment of a table names, a path relative to the folder of the table. Returns
// std::nullopt if no comment names one. Throws InputError as read_budget() does, with the name of the table.
std::optional<Budget> stated_budget(const SampleTable& table);
// Returns the content of that file for a table that is not yet parsed, for fingerprints. Empty if the
// comments at the top name no budget, or if the file cannot be read.
std::string stated_budget_text(const Content& table);

}  // namespace brdf::io
