// Recovers the angles of a grid from rows that match the grid within rounding.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

namespace brdf::io {

class DistinctAngles {
 public:
  // `turn`: the angle in degrees that equals 0, for example 360; 0 if the angles are not periodic.
  explicit DistinctAngles(double turn = 0) : turn_(turn) {}

  // Adds an angle in degrees unless the list has an angle within `tolerance`. An angle within 1e-7 degrees
  // of a number of six decimals is stored as that number.
  void add(double angle, double tolerance);
  // Numbers the angles from 0 in ascending order. Call before index().
  void number();
  // Returns the number of the nearest angle. The list must not be empty.
  std::size_t index(double angle) const;
  std::size_t size() const { return angles_.size(); }
  // Returns the angles in ascending order.
  std::vector<double> list() const;

 private:
  using Entry = std::map<double, std::size_t>::value_type;

  // Returns the nearest entry within the tolerance, or null.
  const Entry* find(double angle, double tolerance) const;

  std::map<double, std::size_t> angles_;
  double turn_;
};

}  // namespace brdf::io
