#include "fit/assess/paired.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "fit/assess/student.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kExact = 25;

// Returns P(sum of ranks of the positive differences >= found). Twice the ranks are whole numbers, even
// with ties.
double exact_ranks(const std::vector<int>& twice, int found) {
  int all = 0;
  for (int r : twice) all += r;
  std::vector<double> ways(std::size_t(all) + 1, 0);
  ways[0] = 1;
  for (int r : twice)
    for (std::size_t s = ways.size(); s-- > std::size_t(r);) ways[s] += ways[s - std::size_t(r)];
  double above = 0, total = 0;
  for (std::size_t s = 0; s < ways.size(); ++s) {
    total += ways[s];
    if (int(s) >= found) above += ways[s];
  }
  return above / total;
}

double signed_ranks(std::vector<double> d) {
  std::erase(d, 0.0);
  if (d.size() < 2) return 1;
  std::ranges::sort(d, [](double x, double y) { return std::abs(x) < std::abs(y); });
  std::vector<int> twice(d.size());
  int found = 0;
  double square = 0;
  for (std::size_t first = 0; first < d.size();) {
    std::size_t last = first + 1;
    while (last < d.size() && std::abs(d[last]) == std::abs(d[first])) ++last;
    for (std::size_t k = first; k < last; ++k) {
      twice[k] = int(first + last + 1);
      if (d[k] > 0) found += twice[k];
      square += double(twice[k]) * twice[k];
    }
    first = last;
  }
  if (d.size() <= kExact) return exact_ranks(twice, found);
  const double n = double(d.size()), mean = n * (n + 1) / 2;
  return boost::math::cdf(
      boost::math::complement(boost::math::normal(), (found - 1 - mean) / std::sqrt(square / 4)));
}

}  // namespace

PairedTest paired_test(const std::vector<RowGroup>& groups, const std::vector<double>& a,
                       const std::vector<double>& b) {
  PairedTest out;
  std::vector<double> d(groups.size());
  double rows = 0, sum = 0;
  for (std::size_t g = 0; g < d.size(); ++g) {
    d[g] = a[g] - b[g];
    rows += double(groups[g].range.rows);
    sum += double(groups[g].range.rows) * d[g];
  }
  const double n = double(d.size()), mean = sum / rows;
  double square = 0;
  for (std::size_t g = 0; g < d.size(); ++g)
    square += std::pow(double(groups[g].range.rows) * (d[g] - mean), 2);
  const double error = std::sqrt(square * n / (n - 1)) / rows;
  if (n >= 2) out.standard_error = error;
  if (n >= 2 && error > 0) out.t = t_tail(n - 1, mean / error);
  out.ranks = signed_ranks(std::move(d));
  return out;
}

double paired_ratio_test(const std::vector<double>& a, const std::vector<double>& b, double rounding) {
  const double n = double(a.size());
  std::vector<double> d(a.size());
  double mean = 0, square = 0;
  for (std::size_t g = 0; g < d.size(); ++g)
    mean += (d[g] = std::log(std::max(a[g], rounding) / std::max(b[g], rounding))) / n;
  for (const double x : d) square += (x - mean) * (x - mean);
  const double error = std::sqrt(square / (n * (n - 1)));
  if (!(n >= 2) || !(error > 0)) return 1;
  return t_tail(n - 1, mean / error);
}

}  // namespace brdf::fit
