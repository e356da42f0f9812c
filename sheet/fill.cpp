#include "sheet/fill.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "io/files/numbers.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

constexpr std::size_t kFewestFilled = 3;  // the fewest rows that hold a fill value
constexpr double kFar = 10;               // such a number is so much larger than all values

// Returns the candidates for a fill value: 0, the least and the largest value, and frequent values.
std::vector<double> candidates(const std::vector<double>& values) {
  constexpr std::size_t kLooked = 20000, kMost = 8;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  std::vector<double> found{0, *low, *high};
  std::vector<double> looked;
  for (std::size_t k = 0; k < values.size(); k += values.size() / kLooked + 1) looked.push_back(values[k]);
  std::ranges::sort(looked);
  std::vector<std::pair<std::size_t, double>> often;
  for (std::size_t k = 0; k < looked.size();) {
    std::size_t end = k;
    while (end < looked.size() && looked[end] == looked[k]) ++end;
    if (end - k >= kFewestFilled) often.emplace_back(end - k, looked[k]);
    k = end;
  }
  std::sort(often.rbegin(), often.rend());
  for (std::size_t k = 0; k < std::min(often.size(), kMost); ++k) found.push_back(often[k].second);
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Returns whether no other value is close to this one. A flat curve, or the last digit, repeats a value
// among others of its size, and a saturated detector repeats its largest value.
bool is_alone(const std::vector<double>& values, double value) {
  constexpr double kNear = 1.25, kBeyondSaturation = 20;
  const double largest = *std::ranges::max_element(values);
  const double near = value == largest ? kBeyondSaturation : kNear;
  return std::ranges::none_of(values,
                              [&](double v) { return v != value && v < value * near && v * near > value; });
}

// Returns whether the rows share one half vector, or one angle between light and viewer: a peak of the same
// height under every light.
bool are_one_feature(const View& view, const std::vector<Row>& rows) {
  constexpr double kSame = 0.02;
  const io::SampleTable& t = view.table();
  double half_low = HUGE_VAL, half_high = -HUGE_VAL, phase_low = HUGE_VAL, phase_high = -HUGE_VAL;
  for (const Row k : rows) {
    const Vec3<double> wi = direction(degrees(t.theta_i[k]), degrees(0)),
                       wo = direction(degrees(t.theta_o[k]), degrees(view.turn(k))), sum = wi + wo;
    const double half = std::atan2(std::hypot(sum.x, sum.y), sum.z),
                 phase = std::acos(std::min(dot(wi, wo), 1.0));
    half_low = std::min(half_low, half);
    half_high = std::max(half_high, half);
    phase_low = std::min(phase_low, phase);
    phase_high = std::max(phase_high, phase);
  }
  return half_high - half_low < kSame || phase_high - phase_low < kSame;
}

// The values in the rows around the rows of one value.
class Surroundings {
 public:
  Surroundings(const View& view, const std::vector<double>& values, double resolution, double value)
      : view_(view), values_(values), value_(value) {
    // A vanishing lobe reaches 0, and a number below the last digit is written as 0.
    constexpr double kDynamicRange = 1e-7, kDigits = 5;
    least_ = std::max(kDynamicRange * *std::ranges::max_element(values), kDigits * resolution);
  }

  void look_at(Row k) {
    constexpr std::size_t kFewestAround = 2;
    std::vector<double> around;
    for (const Row n : view_.near(k))
      if (values_[n] != value_) around.push_back(values_[n]);
    if (around.size() < kFewestAround) return;
    const double middle = io::median(around);
    ++judged_;
    contradicted_ += middle > least_ && (value_ <= 0 || value_ < middle / 2 || value_ > middle * 2);
    for (const double v : around) far_below_ += v < middle / 3;
    all_.insert(all_.end(), around.begin(), around.end());
  }

  bool contradict() const {
    constexpr double kNearlyAll = 0.8;
    return judged_ >= kFewestFilled && double(contradicted_) >= kNearlyAll * double(judged_) &&
           (value_ > 0 || !are_noise_about_0());
  }

 private:
  // Noise about 0 that was cut at 0 leaves arbitrarily small values next to the zeros. If values were
  // replaced, there is a gap.
  bool are_noise_about_0() const {
    constexpr double kFarBelow = 0.12, kGap = 0.25;
    if (double(far_below_) <= kFarBelow * double(all_.size())) return false;
    return io::quantile(all_, 0.02) < kGap * io::quantile(all_, 0.2);
  }

  const View& view_;
  const std::vector<double>& values_;
  double value_, least_;
  std::size_t judged_ = 0, contradicted_ = 0, far_below_ = 0;
  std::vector<double> all_;  // around the rows examined
};

// Returns whether programs write this number for a missing measurement: three or more nines (9.99, 999,
// 99999) or a power of ten from 1e6 on (1e20). The last digits of a converted number are not compared.
bool is_written_for_nothing(double value) {
  constexpr double kLeastPower = 1e6;
  constexpr std::ptrdiff_t kFewestNines = 3;
  const double ten = std::log10(value);
  if (value >= kLeastPower && std::abs(ten - std::round(ten)) < 1e-9) return true;
  const std::string text = io::short_number(value, 9), digits = text.substr(0, text.find('e'));
  return digits.find_first_not_of("9.") == digits.npos && std::ranges::count(digits, '9') >= kFewestNines;
}

std::vector<Row> rows_of(const std::vector<double>& values, double value) {
  std::vector<Row> rows;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (values[k] == value) rows.push_back(Row(k));
  return rows;
}

// Returns whether the value is such a number, as f_r or before a division by pi or 100 pi.
bool may_be_mark(double value) {
  return is_written_for_nothing(value) || is_written_for_nothing(kPi * value) ||
         is_written_for_nothing(100 * kPi * value);
}

// Returns whether a positive value is a mark and no measurement: such a number, far above all others.
bool is_mark(const std::vector<double>& values, double value) {
  return value > 0 && may_be_mark(value) && std::ranges::none_of(values, [&](double v) {
           return v != value && kFar * v > value && !may_be_mark(v);
         });
}

// Returns the marks that several rows hold, by rising value.
std::set<double> marks_of(const std::vector<double>& values) {
  const double least = kFar * io::median(values);  // few values are looked at
  std::set<double> once, often;
  for (const double v : values)
    if (v > least && may_be_mark(v) && !once.insert(v).second) often.insert(v);
  std::erase_if(often, [&](double v) { return !is_mark(values, v); });
  return often;
}

}  // namespace

std::vector<FillValue> fill_values(const View& view) {
  const io::SampleTable& t = view.table();
  std::vector<FillValue> found;
  if (t.rows() == 0) return found;
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    const std::vector<double>& values = t.values[c];
    const double digits = resolution(values);
    const std::set<double> marks = marks_of(values);
    for (const double mark : marks) found.push_back({c, mark, rows_of(values, mark)});
    for (const double value : candidates(values)) {
      if (marks.contains(value)) continue;
      std::vector<Row> rows = rows_of(values, value);
      if (view.scans().empty() || rows.size() < kFewestFilled || 10 * rows.size() > 9 * values.size())
        continue;
      if (value > 0 && (!is_alone(values, value) || are_one_feature(view, rows))) continue;
      Surroundings around(view, values, digits, value);
      for (const Row k : rows) around.look_at(k);
      if (around.contradict()) found.push_back({c, value, std::move(rows)});
    }
  }
  return found;
}

Finding fill(const Evidence& e) {
  const View& view = e.all;
  const std::vector<FillValue>& found = e.fill;
  const io::SampleTable& t = view.table();
  if (view.scans().empty() && found.empty())
    return not_applicable(t.source, "fill",
                          "the directions are irregular: no row has neighbours at its incidence");
  std::map<Row, double> rows;
  for (const FillValue& f : found)
    for (const Row k : f.rows) rows.emplace(k, f.value);
  Finding f = start(t, "fill");
  f.value = double(rows.size());
  for (const FillValue& fill : found)
    for (const Row k : fill.rows) f.rows.push_back(named_row(view, k, fill.channel));
  std::vector<Row> all;
  for (const auto& [k, value] : rows) all.push_back(k);
  f.conclude(found.empty(), "no fill values",
             found.empty() ? ""
                           : "fill value " + io::short_number(found.front().value, 6) + " in " +
                                 plural(rows.size(), "row") +
                                 ", although neighbouring rows differ: these directions were not measured, "
                                 "and fits leave the rows out (--keep-fill keeps them): " +
                                 places(view, all));
  return f;
}

}  // namespace brdf::sheet
