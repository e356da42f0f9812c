#include "io/samples/fill_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/columns/plain_names.h"
#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

void refuse(const SampleTable& table, std::size_t row, double number, const std::string& column) {
  const std::string text = to_text(number);
  throw InputError(table.where(row) + ": " + text + " (" + printable(column) +
                   ") usually means 'not measured': omit such " +
                   (table.format == "csv" ? "rows, or give a layout with \"fill\": [" + text + "]"
                                          : std::string("entries from the file")));
}

}  // namespace

bool is_fill_value(double number) {
  if (number > -999 && number < 9e36) return false;
  for (const double nines : {999., 9999., 99999., 999999., 9999999.})
    if (number == -nines || number == -nines - 0.9 || number == -nines - 0.99) return true;
  constexpr double kOthers[] = {-32768, -1e30, -1e31, -1e34, 9.96921e36, 9.969209968386869e36};
  constexpr float kLargest = std::numeric_limits<float>::max();
  return std::ranges::find(kOthers, number) != std::end(kOthers) ||
         std::abs(static_cast<float>(number)) == kLargest;
}

bool may_be_fill_value(double number) {
  constexpr double kLeast = 90;
  const std::string text = to_text(std::abs(number));
  return std::abs(number) > kLeast && text.find_first_not_of("9.") == text.npos;
}

void refuse_fill_values(const SampleTable& table) {
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    for (std::size_t k = 0; k < table.rows(); ++k) {
      if (is_fill_value(table.values[c][k])) refuse(table, k, table.values[c][k], table.channels[c]);
      if (table.has_sigma(c) && is_fill_value(table.sigma[c][k]))
        refuse(table, k, table.sigma[c][k], std::string(kSigmaPrefix) + table.channels[c]);
    }
}

}  // namespace brdf::io
