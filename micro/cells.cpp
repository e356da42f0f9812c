#include "micro/cells.h"

#include <algorithm>
#include <cmath>

namespace brdf::micro {

double Cell::projected_solid_angle() const {
  return (phi_high - phi_low) * (square(std::sin(theta_high)) - square(std::sin(theta_low))) / 2;
}

Vec Cell::point(double u, double v) const {
  const double low = square(std::sin(theta_low)), high = square(std::sin(theta_high));
  const double sine_squared = low + u * (high - low);
  const double theta = std::asin(std::sqrt(std::clamp(sine_squared, 0.0, 1.0)));
  return direction(radians(theta), radians(phi_low + v * (phi_high - phi_low)));
}

Cells::Cells(Angle width) {
  const int rows = std::max(1, static_cast<int>(std::lround(kPi / 2 / width.radians())));
  height_ = kPi / 2 / rows;
  for (int row = 0; row < rows; ++row) {
    row_begin_.push_back(size());
    const double low = row * height_, high = (row + 1) * height_;
    const int count =
        2 * std::max(3, static_cast<int>(std::lround(kPi * std::sin((low + high) / 2) / height_)));
    for (int k = 0; k < count; ++k)
      cells_.push_back({low, high, (k - 0.5) * 2 * kPi / count, (k + 0.5) * 2 * kPi / count});
  }
  row_begin_.push_back(size());
}

int Cells::find(const Vec& w, Angle phi_zero) const {
  const double theta = std::atan2(std::hypot(w.x, w.y), w.z);
  const int rows = static_cast<int>(row_begin_.size()) - 1;
  const int row = std::clamp(static_cast<int>(theta / height_), 0, rows - 1);
  const int count = row_begin_[row + 1] - row_begin_[row];
  const double share = (std::atan2(w.y, w.x) - phi_zero.radians()) / (2 * kPi) * count + 0.5;
  const int column = static_cast<int>(std::floor(share)) % count;
  return row_begin_[row] + (column < 0 ? column + count : column);
}

}  // namespace brdf::micro
