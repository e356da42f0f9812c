// The angles of a grid, told by rows that hit it to rounding.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

namespace brdf::io {

class DistinctAngles {
 public:
  // `turn`: the angle that is the same as 0, or 0 where there is none.
  explicit DistinctAngles(double turn = 0) : turn_(turn) {}

  // Adds an angle in degrees unless one within the tolerance is there. What is within 1e-7 degrees of a
  // number of six decimals is meant to be that.
  void add(double angle, double tolerance);
  // Numbers them, ascending, from 0: index() is asked after this.
  void number();
  // Of the nearest one; there must be one.
  std::size_t index(double angle) const;
  std::size_t size() const { return angles_.size(); }
  std::vector<double> list() const;

 private:
  using Entry = std::map<double, std::size_t>::value_type;

  // The nearest within the tolerance; null where there is none.
  const Entry* find(double angle, double tolerance) const;

  std::map<double, std::size_t> angles_;
  double turn_;
};

}  // namespace brdf::io
