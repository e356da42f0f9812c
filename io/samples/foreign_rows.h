// Adds the rows of another program's table and counts the rows that the table leaves out.
#pragma once

#include <cstddef>
#include <string>

#include "io/samples/samples.h"

namespace brdf::io {

class ForeignRows {
 public:
  // The treatment of viewers at 90 degrees. Incident light at 90 degrees is always left out.
  enum class GrazingViewer { left_out, kept };
  // The table must outlive this object.
  explicit ForeignRows(SampleTable& table, GrazingViewer viewer = GrazingViewer::left_out)
      : table_(table), viewer_(viewer) {}

  // Adds the directions of a row, in degrees. A negative polar angle denotes the opposite azimuth. Returns
  // false, and counts the row, if a polar angle is 90 degrees (no light is received) or larger (a
  // transmission). The caller adds the values of rows that are taken. Throws InputError if the table is full.
  bool add(double theta_i, double phi_i, double theta_o, double phi_o);
  // Counts a row that is left out for another reason, for example "holds null".
  void leave_out(const std::string& reason, std::size_t count = 1);
  // Adds a warning for each reason and the sum to `skipped`. Throws InputError if the table has no rows.
  void finish();

 private:
  struct Reason {
    std::string text;
    std::size_t count;
  };
  SampleTable& table_;
  GrazingViewer viewer_;
  std::vector<Reason> reasons_;
};

}  // namespace brdf::io
