#include <algorithm>
#include <cmath>

#include "io/text.h"
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

std::string percent(double x) {
  return io::to_text(std::round(1000 * x) / 10) + " %";
}

std::string plural(std::size_t n, const std::string& word) {
  const std::string many = word.ends_with('y') ? word.substr(0, word.size() - 1) + "ies" : word + "s";
  return std::to_string(n) + " " + (n == 1 ? word : many);
}

Finding start(const io::SampleTable& t, const char* check) {
  Finding f{t.source, check};
  f.evaluations = 0;
  return f;
}

Finding not_applicable(const io::SampleTable& t, const char* check, std::string why) {
  Finding f = start(t, check);
  f.verdict = Verdict::not_applicable;
  f.statement = std::move(why);
  return f;
}

Finding counted(const io::SampleTable& t, const char* check, const std::vector<std::size_t>& rows,
                const std::string& clean, const std::string& fault) {
  Finding f = start(t, check);
  f.value = double(rows.size());
  f.verdict = rows.empty() ? Verdict::pass : Verdict::fail;
  f.statement = rows.empty() ? clean : plural(rows.size(), "row") + " " + fault + ": " + places(t, rows);
  return f;
}

Direction unit(double theta, double phi) {
  constexpr double kRadians = kPi / 180;
  return {std::sin(theta * kRadians) * std::cos(phi * kRadians),
          std::sin(theta * kRadians) * std::sin(phi * kRadians), std::cos(theta * kRadians)};
}

double cosine(const Direction& a, const Direction& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

std::map<std::pair<double, double>, std::vector<std::size_t>> by_light(const io::SampleTable& t) {
  std::map<std::pair<double, double>, std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < t.rows(); ++k) groups[{t.theta_i[k], t.phi_i[k]}].push_back(k);
  return groups;
}

}  // namespace brdf::validate
