#include "io/samples/repeats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "io/files/numbers.h"
#include "io/samples/degrees.h"

namespace brdf::io {
namespace {

constexpr double kPrior = 4;             // weight of the neighbours' variance, in degrees of freedom
constexpr double kPooled = 20;           // degrees of freedom to pool for a variance
using Group = std::vector<std::size_t>;  // rows

// Returns groups of rows with the same directions, in the order of their first rows.
std::vector<Group> groups_of(const SampleTable& table) {
  std::map<std::array<double, 4>, std::size_t> seen;
  std::vector<Group> groups;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const auto [at, is_new] = seen.try_emplace(
        {table.theta_i[k], within_turn(table.phi_i[k]), table.theta_o[k], within_turn(table.phi_o[k])},
        groups.size());
    if (is_new) groups.emplace_back();
    groups[at->second].push_back(k);
  }
  return groups;
}

// Returns the mean of a group. The mean of equal values is exactly that value.
double mean_of(const std::vector<double>& values, const Group& group) {
  const double first = values[group.front()];
  double sum = 0;
  for (const std::size_t k : group) sum += values[k] - first;
  return first + sum / double(group.size());
}

// Returns the sum of squared differences from the mean.
double squares_of(const std::vector<double>& values, const Group& group, double mean) {
  double sum = 0;
  for (const std::size_t k : group) sum += (values[k] - mean) * (values[k] - mean);
  return sum;
}

// The scatter of repeated values of one channel as a function of their size.
class Scatter {
 public:
  Scatter(const std::vector<double>& values, const std::vector<Group>& groups) {
    for (const Group& group : groups) {
      const double mean = mean_of(values, group), squares = squares_of(values, group, mean);
      if (squares > 0) repeated_.push_back({std::abs(mean), squares, double(group.size() - 1)});
    }
    std::ranges::sort(repeated_, {}, &Repeated::size);
  }

  bool is_known() const { return !repeated_.empty(); }

  // Returns the variance of a single value of about this size.
  double variance(double size) const {
    auto first = std::ranges::lower_bound(repeated_, size, {}, &Repeated::size);
    auto last = first;
    double freedom = 0, squares = 0, sizes = 0;
    while (freedom < kPooled && (first != repeated_.begin() || last != repeated_.end())) {
      const bool is_below = last == repeated_.end() ||
                            (first != repeated_.begin() && size - std::prev(first)->size < last->size - size);
      const Repeated& next = is_below ? *--first : *last++;
      freedom += next.freedom;
      squares += next.squares;
      sizes += next.freedom * next.size * next.size;
    }
    const bool is_beyond = last == repeated_.end() && size > repeated_.back().size && sizes > 0;
    return squares / freedom * (is_beyond ? size * size / (sizes / freedom) : 1.0);
  }

 private:
  struct Repeated {
    double size, squares, freedom;
  };
  std::vector<Repeated> repeated_;
};

// Returns the standard deviations of the means, estimated from the scatter of the values; empty if the
// scatter is unknown.
std::vector<double> scatter_of_means(const std::vector<double>& values, const std::vector<Group>& groups) {
  const Scatter scatter(values, groups);
  std::vector<double> sigma;
  if (!scatter.is_known()) return sigma;
  for (const Group& group : groups) {
    const double mean = mean_of(values, group), freedom = double(group.size() - 1);
    const double variance =
        (squares_of(values, group, mean) + kPrior * scatter.variance(std::abs(mean))) / (freedom + kPrior);
    sigma.push_back(std::sqrt(variance / double(group.size())));
  }
  return sigma;
}

std::vector<double> propagated(const std::vector<double>& stated, const std::vector<Group>& groups) {
  std::vector<double> sigma;
  for (const Group& group : groups) {
    double all = 0;
    for (const std::size_t k : group) all = std::hypot(all, stated[k]);
    sigma.push_back(all / double(group.size()));
  }
  return sigma;
}

}  // namespace

void average_repeats(SampleTable& table) {
  const std::vector<Group> groups = groups_of(table);
  if (groups.size() == table.rows()) {
    table.warnings.push_back("no directions are repeated");
    return;
  }
  bool is_known = true;
  for (std::size_t c = 0; c < table.channels.size(); ++c) {
    if (table.sigma.size() <= c) table.sigma.resize(c + 1);
    std::vector<double>& values = table.values[c];
    table.sigma[c] =
        table.has_sigma(c) ? propagated(table.sigma[c], groups) : scatter_of_means(values, groups);
    is_known = is_known && table.has_sigma(c);
    std::vector<double> means;
    for (const Group& group : groups) means.push_back(mean_of(values, group));
    values = std::move(means);
  }
  table.warnings.push_back(
      "repeats: " + plural(table.rows(), "row") + " are " + std::to_string(groups.size()) +
      " pairs of directions, averaged" +
      (is_known ? "" : "; the repeated rows are copies, which give no measurement noise"));
  SampleTable kept;
  for (const Group& group : groups) {
    const std::size_t k = group.front();
    kept.add_directions(table.theta_i[k], table.phi_i[k], table.theta_o[k], table.phi_o[k]);
    if (!table.lines.empty()) kept.lines.push_back(table.lines[k]);
  }
  table.theta_i = std::move(kept.theta_i);
  table.phi_i = std::move(kept.phi_i);
  table.theta_o = std::move(kept.theta_o);
  table.phi_o = std::move(kept.phi_o);
  table.lines = std::move(kept.lines);
}

}  // namespace brdf::io
