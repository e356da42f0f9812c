#include <algorithm>

#include "validate/sheet_checks.h"

namespace brdf::validate {
namespace {

// The first places of a list, for people.
std::string places(const io::SampleTable& t, const std::vector<std::size_t>& rows) {
  std::string text;
  for (std::size_t k = 0; k < std::min<std::size_t>(rows.size(), 5); ++k)
    text += (k ? "; " : "") + t.where(rows[k]);
  return text + (rows.size() > 5 ? "; ..." : "");
}

}  // namespace

std::string plural(std::size_t n, const std::string& word) {
  const std::string many = word.ends_with('y') ? word.substr(0, word.size() - 1) + "ies" : word + "s";
  return std::to_string(n) + " " + (n == 1 ? word : many);
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
  f.conclude(rows.empty(), clean, plural(rows.size(), "row") + " " + fault + ": " + places(t, rows));
  return f;
}

std::map<std::pair<double, double>, std::vector<std::size_t>> by_light(const io::SampleTable& t) {
  std::map<std::pair<double, double>, std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < t.rows(); ++k) groups[{t.theta_i[k], t.phi_i[k]}].push_back(k);
  return groups;
}

}  // namespace brdf::validate
