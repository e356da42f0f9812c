// The rows of a table that the checks judge, and the scans in which the instrument measured them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "io/samples/samples.h"

namespace brdf::sheet {

using Row = std::uint32_t;

// One pass of the detector under one light. The rows of a direction that was measured twice belong to two
// scans.
struct Scan {
  double theta_i, phi_i;  // degrees
  std::vector<Row> rows;  // in the order of the file
};

// A table without the rows that are not judged, with derived data that several checks need. The table that
// was read must outlive the view.
class View {
 public:
  // Takes the rows of `read` for which `keep` holds; all rows if `keep` is empty.
  explicit View(const io::SampleTable& read, const std::vector<bool>& keep = {});
  View(const View&) = delete;
  View& operator=(const View&) = delete;
  ~View();

  const io::SampleTable& table() const { return origin_.empty() ? read_ : kept_; }
  // Returns the row of the file for a row of table().
  std::size_t origin(std::size_t row) const { return origin_.empty() ? row : origin_[row]; }
  // Returns "FILE, line N" for a row of table(), or for a row of the file.
  std::string where(std::size_t row) const { return file_place(origin(row)); }
  std::string file_place(std::size_t row) const { return read_.where(row); }

  // Returns the azimuth of the viewer relative to the light, -180 to 180 degrees.
  double turn(std::size_t row) const { return turns_[row]; }
  // Returns the logarithm of the geometric mean of all usable channels; NaN if one of them is not above 0.
  // A channel is usable if nine of ten values are above 0. If no channel is usable, the channel with the
  // most such values is used alone.
  double level(std::size_t row) const { return levels_[row]; }
  // Returns the channel with the least median: a highlight has the most contrast in that channel.
  std::size_t darkest() const { return darkest_; }

  // Empty if the directions are scattered: no instrument has more lights than kMostLights.
  const std::vector<Scan>& scans() const { return scans_; }
  // Returns up to kNeighbours rows of the same scan that are nearest to a row, nearest first; empty in
  // scans of fewer than kFewestRows rows. The rows are found at the first call for a row. Not safe for
  // calls from several threads.
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
    std::uint32_t scan, index;  // of a row: its scan and its position in the scan
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

// A row of a scan in the plane of incidence: the viewer's angle from the normal, positive on the side of
// the mirror direction.
struct InPlane {
  double angle;  // degrees
  Row row;
};
// Returns the rows in the plane of incidence by rising angle. A direction along the normal is listed once.
std::vector<InPlane> in_plane(const View& view, const Scan& scan);

}  // namespace brdf::sheet
