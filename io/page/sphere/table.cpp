#include "io/page/sphere/table.h"

#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "io/files/parallel.h"

namespace brdf::io::sphere {
namespace {

constexpr double kMost = 16;       // ratios beyond this are clamped
constexpr double kHorizon = 1e-9;  // cosine: rounding may lift a direction on the horizon

// Returns the pair of directions at a node. The direction of incidence is rotated from the frame of the
// half vector to that of the surface; the viewing direction is its mirror image about the half vector.
Pair pair_of(const TableSize& n, double i, double j, double k, double l) {
  const auto part = [](double at, int count) { return std::clamp(at / (count - 1), 0.0, 1.0); };
  const double theta_h = kPi / 2 * part(i, n.theta_h) * part(i, n.theta_h),
               theta_d = kPi / 2 * part(j, n.theta_d), phi_d = kPi * k / n.phi_d,
               phi_h = 2 * kPi * l / n.phi_h;
  const Vec3<double> h = direction(radians(theta_h), radians(phi_h)),
                     along = direction(radians(theta_h + kPi / 2), radians(phi_h)),
                     across = direction(radians(kPi / 2), radians(phi_h + kPi / 2));
  const Vec3<double> d = direction(radians(theta_d), radians(phi_d));
  const Vec3<double> side = along * d.x + across * d.y;
  return {h * d.z + side, h * d.z - side};
}

struct Node {
  Colour fitted, measured;
  double known = 0;  // the share of the node's neighbourhood that was measured
};

// All nodes of a table, in its order.
class Nodes {
 public:
  Nodes(const FittedPairs& fitted, const MeasuredPairs& measured, const TableSize& n)
      : fitted_(fitted), measured_(measured), n_(n) {
    nodes_.resize(std::size_t(n.theta_h) * std::size_t(n.theta_d) * std::size_t(n.phi_d + 1) *
                  std::size_t(n.phi_h));
    each([&](Node& node, int i, int j, int k, int l) { node = at(i, j, k, l); });
    const std::vector<Node> whole = nodes_;
    each([&](Node& node, int i, int j, int k, int l) {
      if (at_the_edge(whole, i, j, k, l)) refine(node, i, j, k, l);
    });
  }
  const std::vector<Node>& all() const { return nodes_; }

 private:
  // Calls visit(node, i, j, k, l) for all nodes in parallel.
  template <class Visit>
  void each(Visit&& visit) {
    parallel_for(nodes_.size(), [&](std::size_t number) {
      int rest = int(number);
      const auto next = [&rest](int count) {
        const int index = rest % count;
        rest /= count;
        return index;
      };
      const int i = next(n_.theta_h), j = next(n_.theta_d), k = next(n_.phi_d + 1);
      visit(nodes_[number], i, j, k, rest);
    });
  }

  Node at(double i, double j, double k, double l) const {
    const Pair pair = pair_of(n_, i, j, k, l);
    if (!(std::fmin(pair.wi.z, pair.wo.z) > kHorizon)) return {};
    const std::optional<Colour> f = measured_(pair.wi, pair.wo);
    return f ? Node{fitted_(pair.wi, pair.wo), *f, 1} : Node{};
  }

  // Returns whether the node and at least one of its neighbours differ in being known.
  bool at_the_edge(const std::vector<Node>& whole, int i, int j, int k, int l) const {
    const auto known = [&](int a, int b, int c, int d) {
      a = std::clamp(a, 0, n_.theta_h - 1), b = std::clamp(b, 0, n_.theta_d - 1);
      c = (c + n_.phi_d) % n_.phi_d, d = (d + n_.phi_h) % n_.phi_h;
      return whole[std::size_t(((d * (n_.phi_d + 1) + c) * n_.theta_d + b) * n_.theta_h + a)].known > 0;
    };
    const bool own = known(i, j, k, l);
    return known(i - 1, j, k, l) != own || known(i + 1, j, k, l) != own || known(i, j - 1, k, l) != own ||
           known(i, j + 1, k, l) != own || known(i, j, k - 1, l) != own || known(i, j, k + 1, l) != own ||
           known(i, j, k, l - 1) != own || known(i, j, k, l + 1) != own;
  }

  // Determines the known share from pairs of directions a quarter of a step around the node. If the node
  // itself has no value, the node takes the value of one of these pairs. The shader hatches a point if half
  // of its neighbourhood is unknown, which gives a straight edge instead of steps.
  void refine(Node& node, int i, int j, int k, int l) const {
    double count = 0, pairs = 0;
    for (const double d : {-0.25, 0.25})
      for (const double a : {-0.25, 0.25})
        for (const double b : {-0.25, 0.25})
          for (const double c : {-0.25, 0.25}) {
            if (n_.phi_h == 1 && d > 0) continue;
            const Node near = at(i + a, j + b, k + c, n_.phi_h == 1 ? l : l + d);
            ++pairs;
            count += near.known;
            if (near.known > 0 && node.known == 0) node = near;
          }
    if (node.known > 0) node.known = count / pairs;
  }

  const FittedPairs& fitted_;
  const MeasuredPairs& measured_;
  const TableSize& n_;
  std::vector<Node> nodes_;
};

// Returns a floor far below the measured values. Without it the ratio would be unbounded if the fitted
// value is nearly 0.
double floor_of(const std::vector<Node>& nodes) {
  std::vector<double> values;
  for (const Node& node : nodes)
    if (node.known > 0) values.insert(values.end(), node.measured.begin(), node.measured.end());
  return values.empty() ? 0 : 1e-3 * std::fmax(median(std::move(values)), 0.0);
}

}  // namespace

Table table_of(const FittedPairs& fitted, const MeasuredPairs& measured, const TableSize& n) {
  const std::vector<Node> nodes = Nodes(fitted, measured, n).all();
  Table table{.size = n, .floor = floor_of(nodes)};
  std::vector<double> logarithms;
  for (const Node& node : nodes)
    for (std::size_t c = 0; c < 3; ++c) {
      const double ratio = node.measured[c] / (node.fitted[c] + table.floor);
      const double x = std::log(std::isfinite(ratio) ? std::clamp(ratio, 1 / kMost, kMost) : 1.0);
      logarithms.push_back(x);
      if (node.known == 0) continue;
      table.low = std::fmin(table.low, x);
      table.high = std::fmax(table.high, x);
    }
  const double step = std::fmax(table.high - table.low, 1e-6) / 255;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double known = nodes[k].known;
    for (std::size_t c = 0; c < 3; ++c)
      table.bytes += char(std::lround(known * (logarithms[3 * k + c] - table.low) / step));
    table.bytes += char(std::lround(255 * known));
  }
  table.high = table.low + 255 * step;
  return table;
}

}  // namespace brdf::io::sphere
