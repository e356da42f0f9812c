#include "measured/field.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>
#include <utility>

namespace brdf::measured {
namespace {

constexpr double kKnownNoise =
    0.02;  // variance assumed for the samples in `known`: they need not agree to the last digit
constexpr double kMostNoise = 100;
// Lengths are at least the longest one divided by this. 200 rows out of a million are too far apart to
// distinguish a shorter length from no correlation.
constexpr double kShortest = 10;
constexpr std::size_t kAsked = 16;  // number of nearest samples that determine `known`

double correlation(double squared_distance) {
  const double a = std::sqrt(5 * squared_distance);
  return (1 + a + a * a / 3) * std::exp(-a);
}

Place scaled(const Place& place, const Place& lengths) {
  Place out;
  for (std::size_t k = 0; k < kDimensions; ++k) out[k] = place[k] / lengths[k];
  return out;
}

double squared_distance(const Place& a, const Place& b) {
  double sum = 0;
  for (std::size_t k = 0; k < kDimensions; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

}  // namespace

// The places in units of the lengths, with the interface that nanoflann requires.
class Field::Tree {
 public:
  explicit Tree(std::vector<Place> places) : places_(std::move(places)), index_(kDimensions, *this) {}
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  std::size_t kdtree_get_point_count() const { return places_.size(); }
  double kdtree_get_pt(std::size_t place, std::size_t axis) const { return places_[place][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
  const Place& operator[](std::size_t place) const { return places_[place]; }
  std::size_t nearest(const Place& at, std::size_t count, std::uint32_t* found, double* squared) const {
    return index_.knnSearch(at.data(), count, found, squared);
  }

 private:
  std::vector<Place> places_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Tree>, Tree, int(kDimensions)>
      index_;
};

Field::Field(const std::vector<Place>& places, std::vector<double> count, const Variation& variation)
    : variation_(variation), count_(std::move(count)) {
  std::vector<Place> scaled_places;
  for (const Place& place : places) scaled_places.push_back(scaled(place, variation.lengths));
  tree_ = std::make_unique<const Tree>(std::move(scaled_places));
}

Field::~Field() = default;

Field::Weights Field::weights_at(const Place& place, double least_known) const {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, int(kNeighbours), int(kNeighbours)>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, int(kNeighbours), 1>;
  Weights out;
  const Place at = scaled(place, variation_.lengths);
  std::array<double, kNeighbours> squared{};
  out.count = tree_->nearest(at, kNeighbours, out.sample.data(), squared.data());
  const auto n = Eigen::Index(out.count);
  Matrix between(n, n);
  Vector to(n);
  const auto correlate = [&](Eigen::Index first, Eigen::Index last) {
    for (Eigen::Index i = first; i < last; ++i) {
      const Place& a = (*tree_)[out.sample[std::size_t(i)]];
      to(i) = correlation(squared[std::size_t(i)]);
      for (Eigen::Index j = 0; j < i; ++j)
        between(i, j) = correlation(squared_distance(a, (*tree_)[out.sample[std::size_t(j)]]));
    }
  };
  const Eigen::Index asked = std::min(n, Eigen::Index(kAsked));
  correlate(0, asked);
  Matrix sure = between.topLeftCorner(asked, asked);
  sure.diagonal().setConstant(1 + kKnownNoise);
  const Vector nearest = to.head(asked);
  out.known = nearest.dot(sure.selfadjointView<Eigen::Lower>().llt().solve(nearest));
  if (out.known < least_known) {
    out.count = 0;
    return out;
  }
  correlate(asked, n);
  // The noise grows towards the farthest sample, which has noise only. Samples that enter or leave the
  // neighbourhood therefore cause no discontinuity.
  const double edge = squared[out.count - 1] * (1 + 1e-9) + 1e-12;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double inside = 1 - squared[std::size_t(i)] / edge, taper = inside * inside;
    between(i, i) =
        1 + (variation_.noise + 1e-3) / count_[out.sample[std::size_t(i)]] / std::max(taper, 1e-9);
  }
  const Vector weights = between.selfadjointView<Eigen::Lower>().llt().solve(to);
  for (Eigen::Index i = 0; i < n; ++i) out.weight[std::size_t(i)] = weights(i);
  return out;
}

std::vector<std::size_t> spread_out(const std::vector<Place>& places, const Place& lengths,
                                    std::size_t count) {
  constexpr std::size_t kLooked = 20000;
  std::vector<std::size_t> rows, chosen;
  for (std::size_t k = 0; k < places.size(); k += 1 + places.size() / kLooked) rows.push_back(k);
  std::vector<double> away(rows.size(), HUGE_VAL);
  std::size_t next = 0;
  while (chosen.size() < std::min(count / 2, rows.size())) {
    chosen.push_back(rows[next]);
    const Place last = scaled(places[chosen.back()], lengths);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      away[k] = std::min(away[k], squared_distance(last, scaled(places[rows[k]], lengths)));
      if (away[k] > away[next]) next = k;
    }
  }
  const std::size_t step = std::max<std::size_t>(1, 2 * rows.size() / count);
  for (std::size_t k = step / 2; k < rows.size(); k += step) chosen.push_back(rows[k]);
  std::ranges::sort(chosen);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

namespace {

double likelihood(const Scattered& samples, const Variation& v) {
  const auto n = Eigen::Index(samples.places.size());
  std::vector<Place> at;
  for (const Place& place : samples.places) at.push_back(scaled(place, v.lengths));
  Eigen::MatrixXd between(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j)
      between(i, j) = correlation(squared_distance(at[std::size_t(i)], at[std::size_t(j)]));
    between(i, i) = 1 + v.noise / samples.count[std::size_t(i)];
  }
  const Eigen::LLT<Eigen::MatrixXd> factors(between);
  if (factors.info() != Eigen::Success) return -HUGE_VAL;
  double logs = 0;
  for (Eigen::Index i = 0; i < n; ++i) logs += 2 * std::log(factors.matrixLLT()(i, i));
  double sum = 0;
  for (const std::vector<double>& values : samples.values) {
    const Eigen::VectorXd whitened = factors.matrixL().solve(Eigen::VectorXd::Map(values.data(), n));
    sum -= 0.5 * double(n) * std::log(whitened.squaredNorm() / double(n) + 1e-12) + 0.5 * logs;
  }
  return sum;
}

// Climbs from `start` to a maximum, one parameter at a time.
Variation likeliest(const Scattered& samples, const Variation& start, const Place& longest, double floor) {
  const auto worth = [&](const Variation& v) {
    double sum = likelihood(samples, v);
    for (std::size_t k = 0; k < kDimensions; ++k)
      sum -= 2 * std::pow(std::log(longest[k] / v.lengths[k]), 2);  // undetermined lengths stay long
    return sum;
  };
  Variation best = start;
  best.likelihood = worth(best);
  const auto stepped = [&](std::size_t number, double by) {
    Variation v = best;
    if (number < kDimensions)
      v.lengths[number] = std::clamp(v.lengths[number] * by, longest[number] / kShortest, longest[number]);
    else
      v.noise = std::clamp(v.noise * by * by, floor, kMostNoise);
    return v;
  };
  for (double factor = 2; factor > 1.2; factor = std::sqrt(factor)) {
    for (bool better = true; better;) {
      better = false;
      for (std::size_t number = 0; number <= kDimensions; ++number) {
        for (const double by : {1 / factor, factor}) {
          Variation v = stepped(number, by);
          if (v.lengths == best.lengths && v.noise == best.noise) continue;
          v.likelihood = worth(v);
          if (v.likelihood <= best.likelihood + 1e-6) continue;
          best = v;
          better = true;
        }
      }
    }
  }
  return best;
}

}  // namespace

Variation learn_variation(const Scattered& samples, const Place& longest, double least_noise) {
  double variance = 1e-12;
  for (const std::vector<double>& values : samples.values)
    for (const double y : values) variance += y * y / double(values.size() * samples.values.size());
  const double floor = std::clamp(least_noise * least_noise / variance, 1e-4, kMostNoise);
  Variation best = likeliest(samples, {longest, std::max(floor, 0.01), -HUGE_VAL}, longest, floor);
  // Also start from noise only. If the values are only noise, the lengths are undetermined and stay long.
  const Variation noisy = likeliest(samples, {longest, kMostNoise, -HUGE_VAL}, longest, floor);
  return noisy.likelihood > best.likelihood ? noisy : best;
}

}  // namespace brdf::measured
