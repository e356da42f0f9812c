#include <algorithm>

#include "io/numbers.h"
#include "validate/sheet_checks.h"

namespace brdf::validate {
namespace {

// The first places of a list, for people; rows of one line are one place.
std::string places(const io::SampleTable& t, const std::vector<std::size_t>& rows) {
  constexpr std::size_t kMost = 5;
  std::vector<std::string> found;
  for (std::size_t k = 0; k < rows.size() && found.size() <= kMost; ++k)
    if (std::string place = t.where(rows[k]); found.empty() || found.back() != place)
      found.push_back(std::move(place));
  const bool is_cut = found.size() > kMost;
  if (is_cut) found.resize(kMost);
  return io::joined(found, "; ") + (is_cut ? "; ..." : "");
}

}  // namespace

std::string plural(std::size_t n, const std::string& word) {
  const std::string many = word.ends_with('y') ? word.substr(0, word.size() - 1) + "ies" : word + "s";
  return std::to_string(n) + " " + (n == 1 ? word : many);
}

NamedRow named_row(const io::SampleTable& t, std::size_t k) {
  NamedRow row;
  row.row = k;
  if (k < t.lines.size()) row.line = t.lines[k];
  row.theta_i = t.theta_i[k];
  row.phi_i = t.phi_i[k];
  row.theta_o = t.theta_o[k];
  row.phi_o = t.phi_o[k];
  return row;
}

NamedRow named_row(const io::SampleTable& t, std::size_t k, std::size_t c) {
  NamedRow row = named_row(t, k);
  row.channel = t.channels[c];
  row.value = row.expected = t.values[c][k];
  return row;
}

Finding start(const io::SampleTable& t, const char* check) {
  Finding f{t.source, check};
  f.evaluations = 0;
  return f;
}

Finding counted(const io::SampleTable& t, const char* check, const std::vector<std::size_t>& rows,
                const std::string& clean, const std::string& fault) {
  Finding f = start(t, check);
  f.value = double(rows.size());
  for (const std::size_t k : rows) f.rows.push_back(named_row(t, k));
  f.conclude(rows.empty(), clean, plural(rows.size(), "row") + " " + fault + ": " + places(t, rows));
  return f;
}

Finding outliers_of(const io::SampleTable& t, std::vector<NamedRow> rows, double max_theta) {
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.row < b.row; });
  std::vector<std::size_t> inside, beyond;
  std::map<std::string, std::size_t> of_channel;
  for (NamedRow& row : rows) {
    row.apart = row.theta_i > max_theta || row.theta_o > max_theta;
    std::vector<std::size_t>& list = row.apart ? beyond : inside;
    if (list.empty() || list.back() != row.row) list.push_back(row.row);
    if (!row.apart) ++of_channel[row.channel];
  }
  Finding f =
      counted(t, "outliers", inside, "no value stands apart from its neighbours", "far from all neighbours");
  f.rows = std::move(rows);
  if (t.channels.size() > 1 && !inside.empty()) {
    f.statement += " (";
    for (auto it = of_channel.begin(); it != of_channel.end(); ++it)
      f.statement += (it == of_channel.begin() ? "" : ", ") + it->first + " " + std::to_string(it->second);
    f.statement += ")";
  }
  if (!beyond.empty())
    f.statement += "; apart from " + plural(beyond.size(), "row") + " beyond " + io::short_number(max_theta) +
                   " degrees";
  return f;
}

bool is_of_cells(const io::SampleTable& t) {
  return t.format == "merl";
}

std::map<std::pair<double, double>, std::vector<std::size_t>> by_light(const io::SampleTable& t) {
  std::map<std::pair<double, double>, std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < t.rows(); ++k) groups[{t.theta_i[k], t.phi_i[k]}].push_back(k);
  return groups;
}

}  // namespace brdf::validate
