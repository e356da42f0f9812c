// The data sheet of a MERL file. A million cells have no common lights, so that the checks of scans do not
// apply. But every cell has known neighbours, and integrals look values up.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/files/numbers.h"
#include "io/formats/merl.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();

}  // namespace

struct CellEvidence {
  class Cells;
  const View& view;
  const Cells& cells;
  double max_theta;                    // degrees
  std::vector<MeasuredAlbedo> albedo;  // for some angles of the light
};

// The row of each cell.
class CellEvidence::Cells {
 public:
  explicit Cells(const io::SampleTable& t) : rows_(io::merl::kCells, kNone) {
    for (std::size_t k = 0; k < t.rows(); ++k)
      rows_[io::merl::find_cell(t.theta_i[k], t.phi_i[k], t.theta_o[k], t.phi_o[k])] = std::uint32_t(k);
  }
  std::uint32_t operator[](std::size_t cell) const { return rows_[cell]; }
  std::uint32_t at(double theta_i, double theta_o, double phi) const {
    return rows_[io::merl::find_cell(theta_i, 0, theta_o, phi)];
  }

  // Finds the rows of the cells on either side of a cell along the three angles. The azimuth is periodic.
  // Returns their number.
  std::size_t around(std::size_t cell, std::array<std::uint32_t, 6>& found) const {
    using namespace io::merl;
    const int k = int(cell % kPhiDifference), j = int(cell / kPhiDifference % kThetaDifference),
              i = int(cell / kPhiDifference / kThetaDifference);
    std::size_t count = 0;
    const auto add = [&](int a, int b, int c) {
      if (a < 0 || a >= kThetaHalf || b < 0 || b >= kThetaDifference) return;
      c = (c + kPhiDifference) % kPhiDifference;
      const auto row =
          rows_[(std::size_t(a) * kThetaDifference + std::size_t(b)) * kPhiDifference + std::size_t(c)];
      if (row != kNone) found[count++] = row;
    };
    for (const int step : {-1, 1}) {
      add(i + step, j, k);
      add(i, j + step, k);
      add(i, j, k + step);
    }
    return count;
  }

 private:
  std::vector<std::uint32_t> rows_;
};

// Finds values that lie outside the range of their neighbours (without the two extreme ones) by more than a
// factor of two times the cube of that range's ratio.
Finding outliers(const CellEvidence& e) {
  const io::SampleTable& t = e.view.table();
  constexpr std::size_t kFewest = 4;
  std::vector<NamedRow> found;
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    const std::vector<double>& values = t.values[c];
    for (std::size_t cell = 0; cell < io::merl::kCells; ++cell) {
      std::array<std::uint32_t, 6> near{};
      const std::uint32_t row = e.cells[cell];
      if (row == kNone) continue;
      const std::size_t count = e.cells.around(cell, near);
      if (count < kFewest) continue;
      std::array<double, 6> around{};
      for (std::size_t n = 0; n < count; ++n) around[n] = values[near[n]];
      std::sort(around.begin(), around.begin() + std::ptrdiff_t(count));
      const double low = around[1], high = around[count - 2], v = values[row];
      const double spread = low > 0 ? std::pow(high / low, 3) : HUGE_VAL;
      if (v <= 2 * high * spread && 2 * v * spread >= low) continue;
      found.push_back(named_row(e.view, row, c));
      found.back().expected = around[count / 2];
    }
  }
  return outliers_of(e.view, std::move(found), e.max_theta);
}

Finding coverage(const CellEvidence& e) {
  const io::SampleTable& t = e.view.table();
  std::size_t above = 0;
  for (std::size_t cell = 0; cell < io::merl::kCells; ++cell) {
    const io::merl::CellDirections d = io::merl::cell_directions(cell);
    above += d.theta_i <= 90 && d.theta_o <= 90;
  }
  Finding f = start(t, "coverage");
  f.value = double(t.rows()) / double(above);
  f.bound = 1;
  f.outcome = f.value < kEnoughCoverage ? Outcome::undecided : Outcome::pass;
  f.statement = io::percent_to_tenths(f.value) + " of the format's " + std::to_string(above) +
                " cells above the horizon hold a value";
  return f;
}

namespace {

// Integrates by the midpoints of rings and sectors of equal projected solid angle.
MeasuredAlbedo integrate_cells(const io::SampleTable& t, const CellEvidence::Cells& cells, double theta_i,
                               int rings) {
  const int sectors = 2 * rings;  // of one half, which the mirror image doubles
  const std::vector<double> zero(t.channels.size());
  MeasuredAlbedo m{theta_i, 0, 0, zero, zero, zero, {}};
  const double weight = kPi / (double(rings) * sectors);
  for (int ring = 0; ring < rings; ++ring) {
    const double theta_o = radians(std::asin(std::sqrt((ring + 0.5) / rings))).degrees();
    for (int sector = 0; sector < sectors; ++sector) {
      const std::uint32_t row = cells.at(theta_i, theta_o, 180 * (sector + 0.5) / sectors);
      if (row == kNone) continue;
      m.coverage += 1 / (double(rings) * sectors);
      for (std::size_t c = 0; c < zero.size(); ++c) m.value[c] += weight * t.values[c][row];
    }
  }
  return m;
}

// Integrates the cells. The bound is the difference from a rule with half as many rings and sectors, plus
// the value for the share of the hemisphere that no cell covers.
MeasuredAlbedo albedo_of_cells(const io::SampleTable& t, const CellEvidence::Cells& cells, double theta_i) {
  const MeasuredAlbedo coarse = integrate_cells(t, cells, theta_i, 60);
  MeasuredAlbedo fine = integrate_cells(t, cells, theta_i, 120);
  for (std::size_t c = 0; c < fine.value.size(); ++c) {
    const double seen = fine.value[c], missing = 1 - fine.coverage;
    fine.value[c] = fine.coverage > 0 ? seen / fine.coverage : 0;
    const double error = std::abs(seen - coarse.value[c]);
    fine.bound[c] = error + missing * fine.value[c];
    fine.least[c] = seen - error;
  }
  return fine;
}

}  // namespace

io::Series cells_in_plane(const io::SampleTable& t, double theta_i) {
  const CellEvidence::Cells cells(t);
  io::Series s;
  for (double theta = -85; theta <= 85; theta += 1) {
    const std::uint32_t row = cells.at(theta_i, std::abs(theta), theta < 0 ? 0 : 180);
    if (row == kNone) continue;
    s.x.push_back(theta);
    s.y.push_back(t.values.front()[row]);
  }
  return s;
}

Finding negative(const CellEvidence& e) {
  return negative_of(e.view);
}

Finding missing(const CellEvidence& e) {
  return missing_of(e.view.table());
}

Finding saturation(const CellEvidence& e) {
  return saturation_of(e.view, 0);
}

Finding quantity(const CellEvidence& e) {
  return quantity_of(e.view, e.albedo);
}

Finding energy(const CellEvidence& e) {
  return energy_of(e.view.table(), e.albedo);
}

DataSheet sheet_of_cells(const io::SampleTable& t, double max_theta) {
  const View view(t);
  const CellEvidence::Cells cells(t);
  CellEvidence evidence{view, cells, max_theta, {}};
  for (double theta_i = 0; theta_i <= 75; theta_i += 15)
    evidence.albedo.push_back(albedo_of_cells(t, cells, theta_i));
  DataSheet sheet;
  for (const Check& check : checks())
    sheet.findings.push_back(
        check.run_cells ? check.run_cells(evidence)
                        : not_applicable(t.source, std::string(check.name), std::string(check.not_of_cells)));
  sheet.albedo = std::move(evidence.albedo);
  return sheet;
}

}  // namespace brdf::sheet
