#include "io/samples/table_rules.h"

#include <utf8.h>

#include <cmath>
#include <unordered_set>

#include "io/columns/plain_names.h"
#include "io/columns/polarisation_names.h"
#include "io/columns/wavelengths.h"
#include "io/files/error.h"
#include "io/files/limits.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/samples/fill_values.h"

namespace brdf::io {
namespace {

// Returns the rule that a name breaks, or an empty string if the name is valid in a header row.
std::string broken_rule(std::string_view name) {
  double number;
  if (name.empty()) return "must not be empty";
  if (name.size() > kLongestName) return "must have at most " + std::to_string(kLongestName) + " bytes";
  if (!utf8::is_valid(name.begin(), name.end())) return "must be UTF-8";
  if (printable(name) != name) return "must not contain control characters or direction marks";
  if (name.find(',') != name.npos) return "must not contain a comma";
  if (name.front() == '"') return "must not begin with a quotation mark";
  if (trimmed(name) != name) return "must not begin or end with a blank";
  if (parse_number(name, number)) return "must not be a number";
  if (is_plain_angle_name(name)) return "must not be an angle's name";
  if (is_wavelength_name(name)) return "must not be the name of a column of wavelengths";
  if (is_polarisation_name(name)) return "must not be the name of a column of polarisations";
  if (name.starts_with(kSigmaPrefix)) return "must not begin with " + std::string(kSigmaPrefix);
  return "";
}

void check_comments(const SampleTable& table) {
  for (const auto& [key, value] : table.metadata)
    if (key.size() + value.size() + 10 > kLongestLine)
      throw InputError(table.name() + ": the comment " + shown(key + value) + " is longer than " +
                       std::to_string(kLongestLine >> 20) + " MiB");
}

}  // namespace

void check_channel_names(const std::vector<std::string>& names, const std::string& where) {
  if (names.size() > kMostChannels)
    throw InputError(where + ": " + plural(names.size(), "channel") + " exceed the limit of " +
                     std::to_string(kMostChannels));
  std::unordered_set<std::string_view> seen;
  for (const std::string& name : names) {
    std::string rule = broken_rule(name);
    if (rule.empty() && !seen.insert(name).second) rule = "is named twice";
    if (!rule.empty()) throw InputError(where + ": channel " + shown(name) + " " + rule);
  }
}

void keep_comment(SampleTable& table, Comment comment) {
  constexpr std::size_t kMostComments = 100'000;
  if (table.metadata.size() == kMostComments)
    throw InputError(table.name() + ": has more than " + std::to_string(kMostComments) + " comments");
  table.metadata.push_back(std::move(comment));
}

void check_table(const SampleTable& table, Origin origin) {
  check_channel_names(table.channels, table.name());
  check_comments(table);
  if (origin == Origin::measured) refuse_fill_values(table);
  const auto refuse = [&](std::size_t row, std::string_view column, double value, const std::string& rule) {
    throw InputError(table.where(row) + ": " + std::string(column) + " " + to_text(value) + " " + rule);
  };
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double angles[] = {table.theta_i[k], table.phi_i[k], table.theta_o[k], table.phi_o[k]};
    for (const std::size_t a : {0, 2})
      if (!(angles[a] >= 0 && angles[a] <= 90))
        refuse(k, kAngleNames[a], angles[a], "must be between 0 and 90 degrees");
    for (const std::size_t a : {1, 3})
      if (!(std::abs(angles[a]) <= kLargestAzimuth))
        refuse(k, kAngleNames[a], angles[a], "must be between -1e6 and 1e6 degrees");
    for (std::size_t c = 0; c < table.channels.size(); ++c) {
      if (origin == Origin::measured && !std::isfinite(table.values[c][k]))
        refuse(k, table.channels[c], table.values[c][k], "must be finite");
      if (table.has_sigma(c) && !(table.sigma[c][k] > 0 && std::isfinite(table.sigma[c][k])))
        refuse(k, std::string(kSigmaPrefix) + table.channels[c], table.sigma[c][k],
               "must be above 0 and finite");
    }
  }
}

}  // namespace brdf::io
