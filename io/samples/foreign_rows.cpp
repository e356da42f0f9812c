#include "io/samples/foreign_rows.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/limits.h"
#include "io/files/numbers.h"
#include "io/samples/degrees.h"

namespace brdf::io {
namespace {

constexpr const char* kAtTheHorizon = "a polar angle is 90 degrees";
constexpr const char* kBelowTheHorizon = "a polar angle is above 90 degrees (transmission)";

}  // namespace

bool ForeignRows::add(double theta_i, double phi_i, double theta_o, double phi_o) {
  constexpr double kRounding = 1e-9;  // of a conversion from radians
  const double steepest = std::max(std::abs(theta_i), std::abs(theta_o));
  const bool is_below = steepest > 90 + kRounding;
  const bool is_grazing = std::abs(theta_i) >= 90 - kRounding ||
                          (viewer_ == GrazingViewer::left_out && std::abs(theta_o) >= 90 - kRounding);
  if (is_below || is_grazing) {
    leave_out(is_below ? kBelowTheHorizon : kAtTheHorizon);
    return false;
  }
  if (table_.rows() == kMostRows)
    throw InputError(table_.name() + ": has more than " + std::to_string(kMostRows) + " rows");
  table_.add_directions(std::abs(theta_i), theta_i < 0 ? within_turn(phi_i + 180) : phi_i,
                        std::min(std::abs(theta_o), 90.0), theta_o < 0 ? within_turn(phi_o + 180) : phi_o);
  return true;
}

void ForeignRows::leave_out(const std::string& reason, std::size_t count) {
  if (count == 0) return;
  const auto found = std::find_if(reasons_.begin(), reasons_.end(),
                                  [&](const Reason& known) { return known.text == reason; });
  if (found == reasons_.end())
    reasons_.push_back({reason, count});
  else
    found->count += count;
}

void ForeignRows::finish() {
  std::string all;
  for (const Reason& reason : reasons_) {
    const std::string sentence = plural(reason.count, "row") + " left out: " + reason.text;
    table_.warnings.push_back(sentence);
    table_.skipped += reason.count;
    all += (all.empty() ? " (" : "; ") + sentence;
  }
  if (table_.rows() == 0)
    throw InputError(table_.name() + ": holds no rows of reflected light" + (all.empty() ? "" : all + ")"));
}

}  // namespace brdf::io
