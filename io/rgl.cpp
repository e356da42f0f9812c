#include "io/rgl.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "io/error.h"
#include "io/tensor_file.h"

namespace brdf::io::rgl {
namespace {

constexpr double kPi = std::numbers::pi;

// A slice of a stack and its upper neighbour, with their weights.
struct Between {
  std::size_t index;
  double low, high;
};

Between find_between(const std::vector<float>& nodes, double x) {
  if (nodes.size() == 1) return {0, 1, 0};
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x);
  const auto k = static_cast<std::size_t>(above - nodes.begin()) - 1;
  const double t = std::clamp((x - nodes[k]) / (nodes[k + 1] - nodes[k]), 0.0, 1.0);
  return {k, 1 - t, t};
}

// Functions on the unit square, one per slice, bilinear between nodes; x is the fast dimension.
class Stack {
 public:
  Stack() = default;
  Stack(std::vector<float> values, std::size_t width, std::size_t height)
      : width_(width), height_(height), values_(std::move(values)) {}

  double eval(double x, double y, const Between& slice) const {
    const Cell cell = find_cell(x, y);
    const auto at = [&](std::size_t k) { return mix(values_, cell.offset + k, width_ * height_, slice); };
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
  // An index of at most `last`; 0 for what is no number.
  static std::size_t clamped(double x, std::size_t last) {
    return static_cast<std::size_t>(std::min(std::max(0.0, x), static_cast<double>(last)));
  }
  static double mix(const std::vector<float>& values, std::size_t k, std::size_t stride,
                    const Between& slice) {
    const std::size_t low = slice.index * stride + k;
    return slice.high == 0 ? values[low] : slice.low * values[low] + slice.high * values[low + stride];
  }

  std::size_t width_ = 0, height_ = 0;
  std::vector<float> values_;
};

// A density on the unit square per slice, with the map that makes it uniform: rows by their marginal
// distribution, then columns by the conditional one, both piecewise linear densities.
class Warp : public Stack {
 public:
  Warp() = default;
  Warp(std::vector<float> density, std::size_t slices, std::size_t width, std::size_t height)
      : Stack(std::move(density), width, height), conditional_(values_.size()), marginal_(slices * height) {
    for (std::size_t s = 0; s < slices; ++s) integrate(s);
  }

  // The uniform coordinates of a point.
  void invert(double x, double y, const Between& slice, double& uniform_x, double& uniform_y) const {
    const Cell cell = find_cell(x, y);
    const std::size_t area = width_ * height_;
    const auto density = [&](std::size_t k) { return mix(values_, cell.offset + k, area, slice); };
    const auto sum = [&](std::size_t k) { return mix(conditional_, k, area, slice); };
    const double left = (1 - cell.v) * density(0) + cell.v * density(width_);
    const double right = (1 - cell.v) * density(1) + cell.v * density(width_ + 1);
    const double before = (1 - cell.v) * sum(cell.offset) + cell.v * sum(cell.offset + width_);
    const std::size_t row_end = cell.row * width_ + width_ - 1;
    const double below = sum(row_end), above = sum(row_end + width_);
    const double whole_row = (1 - cell.v) * below + cell.v * above;
    uniform_x = (before + cell.u * (left + 0.5 * cell.u * (right - left))) / whole_row;
    uniform_y = mix(marginal_, cell.row, height_, slice) + cell.v * (below + 0.5 * cell.v * (above - below));
  }

 private:
  // Cumulative trapezia of every row, then of the rows' totals, all scaled to a total of 1.
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

// Polar angles are stored on a scale that is dense near the normal.
double theta_to_unit(double theta) {
  return std::sqrt(theta * (2 / kPi));
}
double phi_to_unit(double phi) {
  return (phi + kPi) / (2 * kPi);
}

double polar_angle(const Vec3<double>& w) {
  return std::atan2(std::sqrt(w.x * w.x + w.y * w.y), w.z);
}

}  // namespace

struct Measurement::Data {
  std::string description;
  std::vector<float> theta_i;
  Stack sigma, ndf, rgb;
  Warp vndf;
};

Measurement::~Measurement() = default;

const std::string& Measurement::description() const {
  return data_->description;
}

Measurement::Measurement(const Content& content) : data_(std::make_unique<Data>()) {
  const TensorFile file(content);
  const auto refuse = [&](const std::string& why) { throw InputError(content.name + ": RGL file: " + why); };
  if (!file.has("rgb")) refuse("spectral files are not read, only RGB ones");
  if (file.shape("phi_i") != std::vector<std::size_t>{1}) refuse("anisotropic files are not read");
  data_->description = file.bytes("description");
  data_->theta_i = file.floats("theta_i");
  const std::size_t angles = data_->theta_i.size();
  const auto &ndf = file.shape("ndf"), &sigma = file.shape("sigma"), &vndf = file.shape("vndf"),
             &rgb = file.shape("rgb");
  const auto at_least_two = [](std::size_t a, std::size_t b) { return a >= 2 && b >= 2; };
  const auto not_above =
      std::adjacent_find(data_->theta_i.begin(), data_->theta_i.end(), std::greater_equal<>());
  if (angles < 1 || not_above != data_->theta_i.end() || ndf.size() != 2 || sigma.size() != 2 ||
      vndf.size() != 4 || rgb.size() != 5 || vndf[0] != 1 || vndf[1] != angles || rgb[0] != 1 ||
      rgb[1] != angles || rgb[2] != 3 || !at_least_two(ndf[0], ndf[1]) || !at_least_two(sigma[0], sigma[1]) ||
      !at_least_two(vndf[2], vndf[3]) || !at_least_two(rgb[3], rgb[4]))
    refuse("the fields' sizes do not belong together");
  data_->ndf = Stack(file.floats("ndf"), ndf[1], ndf[0]);
  data_->sigma = Stack(file.floats("sigma"), sigma[1], sigma[0]);
  data_->vndf = Warp(file.floats("vndf"), angles, vndf[3], vndf[2]);
  data_->rgb = Stack(file.floats("rgb"), rgb[4], rgb[3]);
}

void Measurement::eval_cos_o(const Vec3<double>& wi, const Vec3<double>& wo, double rgb[3]) const {
  const Vec3<double> sum = wi + wo;
  const double theta_i = polar_angle(wi), phi_i = std::atan2(wi.y, wi.x);
  const double phi_m = std::atan2(sum.y, sum.x);
  const double mx = theta_to_unit(polar_angle(sum));
  double my = phi_to_unit(phi_m - phi_i);
  my -= std::floor(my);
  const Between slice = find_between(data_->theta_i, theta_i);
  const Between none{0, 1, 0};
  double x, y;
  data_->vndf.invert(mx, my, slice, x, y);
  const double scale = data_->ndf.eval(mx, my, none) /
                       (4 * data_->sigma.eval(theta_to_unit(theta_i), phi_to_unit(phi_i), none));
  for (std::size_t c = 0; c < 3; ++c) {
    // Slices in the file: theta_i, then channel.
    const double low = data_->rgb.eval(x, y, {3 * slice.index + c, 1, 0});
    const double high = slice.high == 0 ? 0 : data_->rgb.eval(x, y, {3 * (slice.index + 1) + c, 1, 0});
    const double value = (slice.low * low + slice.high * high) * scale;
    rgb[c] = value < 0 ? 0 : value;  // no number stays none
  }
}

bool recognises(const Content& content) {
  return content.bytes.starts_with(std::string_view("tensor_file\0", 12));
}

SampleTable read(const Content& content) {
  const Measurement measurement(content);
  SampleTable table;
  table.source = content.name;
  table.format = "rgl";
  table.channels = {"r", "g", "b"};
  table.values.resize(3);
  table.sigma.resize(3);
  table.add_comment("sample", measurement.description());
  table.add_comment("instrument", "RGL gonio-photometer, adaptive tensor file");
  const auto add = [&](double theta_i, double theta_o, double phi_o) {
    const Vec3<double> wi = unit_vector(theta_i, 180), wo = unit_vector(theta_o, phi_o);
    double rgb[3];
    measurement.eval_cos_o(wi, wo, rgb);
    if (!std::all_of(rgb, rgb + 3, [&](double value) { return std::isfinite(value / wo.z); })) {
      ++table.skipped;
      return;
    }
    table.add_directions(theta_i, 180, theta_o, phi_o);
    for (std::size_t c = 0; c < 3; ++c) table.values[c].push_back(rgb[c] / wo.z);
  };
  for (const double theta_i : {5, 15, 30, 45, 60, 75}) {
    add(theta_i, 0, 0);
    for (int theta_o = 4; theta_o <= 80; theta_o += 4)
      for (int phi_o = 0; phi_o <= 180; phi_o += 10) add(theta_i, theta_o, phi_o);
  }
  if (table.rows() == 0) throw InputError(table.source + ": RGL file: holds no finite value");
  table.warnings.push_back("the tensor was sampled at " + std::to_string(table.rows()) + " directions");
  if (table.skipped > 0)
    table.warnings.push_back(std::to_string(table.skipped) +
                             " directions left out: their value is undefined");
  return table;
}

}  // namespace brdf::io::rgl
