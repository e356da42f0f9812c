// Stacks of functions on the unit square, as RGL's files store them (Dupuy and Jakob 2018, supplement).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace brdf::io::rgl {

// A node, and the weights of this node (low) and of its upper neighbour (high).
struct Between {
  std::size_t index;
  double low, high;
};

// Returns the nodes on both sides of x, with the weights of linear interpolation. Outside the nodes x is
// clamped.
inline Between find_between(const std::vector<float>& nodes, double x) {
  if (nodes.size() == 1) return {0, 1, 0};
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x);
  const auto k = static_cast<std::size_t>(above - nodes.begin()) - 1;
  const double t = std::clamp((x - nodes[k]) / (nodes[k + 1] - nodes[k]), 0.0, 1.0);
  return {k, 1 - t, t};
}

// Slices of a stack that are interpolated, with their weights.
struct Slices {
  std::array<std::size_t, 4> index{};
  std::array<double, 4> weight{1};
  std::size_t count = 1;
};

// Returns the slices next to an azimuth and a polar angle of incidence. The polar angle is the fast
// dimension.
inline Slices find_slices(const std::vector<float>& phi_nodes, double phi,
                          const std::vector<float>& theta_nodes, double theta) {
  const Between across = find_between(phi_nodes, phi), along = find_between(theta_nodes, theta);
  Slices slices{{}, {}, 0};
  for (const auto& [p, of_phi] :
       {std::pair(across.index, across.low), std::pair(across.index + 1, across.high)})
    for (const auto& [k, of_theta] :
         {std::pair(along.index, along.low), std::pair(along.index + 1, along.high)}) {
      const bool is_above = p > across.index || k > along.index;
      if (is_above && of_phi * of_theta == 0) continue;
      slices.index[slices.count] = p * theta_nodes.size() + k;
      slices.weight[slices.count++] = of_phi * of_theta;
    }
  return slices;
}

// Functions on the unit square, one per slice, bilinear between nodes. x is the fast dimension.
class Stack {
 public:
  Stack() = default;
  Stack(std::vector<float> values, std::size_t width, std::size_t height)
      : width_(width), height_(height), values_(std::move(values)) {}

  // Evaluates the function at (x, y) in [0, 1]^2, interpolated between the slices.
  double eval(double x, double y, const Slices& slices) const {
    const Cell cell = find_cell(x, y);
    const auto at = [&](std::size_t k) { return mix(values_, cell.offset + k, width_ * height_, slices); };
    return (1 - cell.v) * ((1 - cell.u) * at(0) + cell.u * at(1)) +
           cell.v * ((1 - cell.u) * at(width_) + cell.u * at(width_ + 1));
  }

 protected:
  struct Cell {
    std::size_t column, row, offset;
    double u, v;  // position in the cell
  };
  Cell find_cell(double x, double y) const {
    x *= static_cast<double>(width_ - 1);
    y *= static_cast<double>(height_ - 1);
    const std::size_t column = clamped(x, width_ - 2), row = clamped(y, height_ - 2);
    return {column, row, column + row * width_, x - static_cast<double>(column),
            y - static_cast<double>(row)};
  }
  // Returns an index of at most `last`; 0 for NaN.
  static std::size_t clamped(double x, std::size_t last) {
    return static_cast<std::size_t>(std::min(std::max(0.0, x), static_cast<double>(last)));
  }
  static double mix(const std::vector<float>& values, std::size_t k, std::size_t stride,
                    const Slices& slices) {
    const auto value = [&](std::size_t s) {
      return static_cast<double>(values[slices.index[s] * stride + k]);
    };
    if (slices.count == 1) return value(0);
    double sum = slices.weight[0] * value(0);
    for (std::size_t s = 1; s < slices.count; ++s) sum += slices.weight[s] * value(s);
    return sum;
  }

  std::size_t width_ = 0, height_ = 0;
  std::vector<float> values_;
};

// A density on the unit square per slice, with the map that makes the density uniform. The map treats rows
// by their marginal distribution and then columns by the conditional distribution; both densities are
// piecewise linear.
class Warp : public Stack {
 public:
  Warp() = default;
  Warp(std::vector<float> density, std::size_t slices, std::size_t width, std::size_t height)
      : Stack(std::move(density), width, height), conditional_(values_.size()), marginal_(slices * height) {
    for (std::size_t s = 0; s < slices; ++s) integrate(s);
  }

  // Computes the uniform coordinates of a point.
  void invert(double x, double y, const Slices& slices, double& uniform_x, double& uniform_y) const {
    const Cell cell = find_cell(x, y);
    const std::size_t area = width_ * height_;
    const auto density = [&](std::size_t k) { return mix(values_, cell.offset + k, area, slices); };
    const auto sum = [&](std::size_t k) { return mix(conditional_, k, area, slices); };
    const double left = (1 - cell.v) * density(0) + cell.v * density(width_);
    const double right = (1 - cell.v) * density(1) + cell.v * density(width_ + 1);
    const double before = (1 - cell.v) * sum(cell.offset) + cell.v * sum(cell.offset + width_);
    const std::size_t row_end = cell.row * width_ + width_ - 1;
    const double below = sum(row_end), above = sum(row_end + width_);
    const double whole_row = (1 - cell.v) * below + cell.v * above;
    uniform_x = (before + cell.u * (left + 0.5 * cell.u * (right - left))) / whole_row;
    uniform_y = mix(marginal_, cell.row, height_, slices) + cell.v * (below + 0.5 * cell.v * (above - below));
  }

 private:
  // Sums the trapezia of every row cumulatively, then the totals of the rows, and scales both to a total of
  // 1.
  void integrate(std::size_t slice) {
    float* const density = values_.data() + slice * width_ * height_;
    float* const conditional = conditional_.data() + slice * width_ * height_;
    float* const marginal = marginal_.data() + slice * height_;
    for (std::size_t row = 0; row < height_; ++row) {
      double sum = 0;
      for (std::size_t k = row * width_; k + 1 < (row + 1) * width_; ++k) {
        sum += 0.5 * (static_cast<double>(density[k]) + density[k + 1]);
        conditional[k + 1] = static_cast<float>(sum);
      }
    }
    double sum = 0;
    for (std::size_t row = 0; row + 1 < height_; ++row) {
      const std::size_t end = (row + 1) * width_ - 1;
      sum += 0.5 * (static_cast<double>(conditional[end]) + conditional[end + width_]);
      marginal[row + 1] = static_cast<float>(sum);
    }
    const auto scale = static_cast<float>(1.0 / sum);
    for (std::size_t k = 0; k < width_ * height_; ++k) {
      density[k] *= scale;
      conditional[k] *= scale;
    }
    for (std::size_t k = 0; k < height_; ++k) marginal[k] *= scale;
  }

  std::vector<float> conditional_, marginal_;
};

}  // namespace brdf::io::rgl
