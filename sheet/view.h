// The rows of a table that the checks judge, and how the instrument scanned them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "brdf/vec3.h"
#include "io/samples/samples.h"

namespace brdf::sheet {

using Row = std::uint32_t;

// One pass of the detector under one light. A direction that was measured twice belongs to two scans.
struct Scan {
  double theta_i, phi_i;  // degrees
  std::vector<Row> rows;  // in the file's order
};

// A table without the rows that are not judged, and what several checks need of it. The table that was read
// must outlive the view.
class View {
 public:
  // The rows of `read` for which `keep` holds; every row where it is empty.
  explicit View(const io::SampleTable& read, const std::vector<bool>& keep = {});
  View(const View&) = delete;
  View& operator=(const View&) = delete;
  ~View();

  const io::SampleTable& table() const { return origin_.empty() ? read_ : kept_; }
  // The row of the file that a row of table() was.
  std::size_t origin(std::size_t row) const { return origin_.empty() ? row : origin_[row]; }
  // "FILE, line N" of a row of table(), and of a row of the file.
  std::string where(std::size_t row) const { return file_place(origin(row)); }
  std::string file_place(std::size_t row) const { return read_.where(row); }

  // The azimuth of the viewer from the light's, -180 to 180 degrees.
  double turn(std::size_t row) const { return turns_[row]; }
  // The logarithm of the geometric mean of all usable channels; NaN where one of them is not above 0. A
  // channel is usable where nine of ten values are above 0; without any, the one with most such values stands
  // for all.
  double level(std::size_t row) const { return levels_[row]; }
  // The channel whose median is least: a highlight stands out most in it.
  std::size_t darkest() const { return darkest_; }

  // Empty where the directions are scattered: no instrument has more lights than kMostLights.
  const std::vector<Scan>& scans() const { return scans_; }
  // Up to kNeighbours rows of the same scan that are nearest to a row, nearest first; none in scans of fewer
  // than kFewestRows. Found at the first call for a row; not for several threads at once.
  static constexpr std::size_t kNeighbours = 8, kFewestRows = 12, kMostLights = 2000;
  std::span<const Row> near(std::size_t row) const;

 private:
  void find_levels();
  void find_scans();

  const io::SampleTable& read_;
  io::SampleTable kept_;
  std::vector<Row> origin_;
  std::vector<double> turns_, levels_;
  std::size_t darkest_ = 0;
  std::vector<Scan> scans_;
  class Directions;  // of a scan, as a tree
  struct Place {
    std::uint32_t scan, index;  // of a row: its scan, its place there
  };
  struct Found {
    std::array<Row, kNeighbours> rows;
    std::uint8_t count = kNotYet;
    static constexpr std::uint8_t kNotYet = 255;
  };
  std::vector<Place> places_;
  mutable std::vector<std::unique_ptr<const Directions>> trees_;
  mutable std::vector<Found> near_;
};

// A row of a scan in the plane of incidence: the viewer's angle from the normal, positive on the side of the
// mirror direction.
struct InPlane {
  double angle;  // degrees
  Row row;
};
// By angle; a row along the normal stands there once.
std::vector<InPlane> in_plane(const View& view, const Scan& scan);

}  // namespace brdf::sheet
