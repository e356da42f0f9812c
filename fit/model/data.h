// The samples in the layout of the solver: unit directions and values, structure of arrays.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fit/model/lobe_columns.h"
#include "fit/model/options.h"
#include "fit/model/row_groups.h"
#include "io/samples/samples.h"

namespace brdf::fit {

// The samples of a fit. Rows are sorted by group, direction and value, so no result depends on their order
// in the table.
struct FitData {
  std::vector<std::string> channels;
  std::vector<double> wi_x, wi_y, wi_z, wo_x, wo_y, wo_z;
  std::vector<std::vector<double>> values;  // [channel][row], 1/sr
  std::vector<std::vector<double>> sigma;   // [channel][row]; empty if residuals are not weighted by it
  // [channel][row], the slope of a logarithmic residual at the value; if empty, recomputed in every pass.
  std::vector<std::vector<double>> value_slope;
  std::vector<double> weight;            // [row] weight of the squared residual; empty means 1
  std::vector<std::uint32_t> row;        // index of the row in the table
  std::vector<std::uint32_t> incidence;  // [row] number of the direction of incidence
  RowGroups groups;                      // the groups that are held out together; empty in a subset
  bool grouped = false;                  // incidence counts whole degrees of theta_i instead
  // The budget of the instrument, or null, with the azimuths of the rows' directions in radians, which a
  // direction along the normal does not have. Not in a subset.
  std::shared_ptr<const io::Budget> budget;
  std::vector<double> phi_i, phi_o;
  std::size_t beyond_max_theta = 0;  // number of rows excluded by max_theta
  std::size_t outside_domain = 0;    // number of rows with a value that has no residual (far below zero)

  std::size_t rows() const { return wi_x.size(); }
  // Appends a pair of directions.
  void add_directions(const Vec3<double>& wi, const Vec3<double>& wo);
  // Returns a view of the directions of `rows` rows, beginning with `first`.
  Directions<double> directions(std::size_t first, std::size_t rows) const;
};

// Prepares the rows of the table for the solver. Throws InputError if no rows remain to be fitted.
FitData prepare(const io::SampleTable& table, const FitOptions& options);

// Returns the rows in which every value has a residual under the metric. Returns no rows if this holds for
// all rows, so that nothing needs to be removed.
FitData within_domain(const FitData& data, Metric metric);

// Returns the rows for which `keep` is true, in order.
FitData subset(const FitData& data, const std::vector<bool>& keep);
// Returns at most about `rows` rows, spread over the whole set. The choice is deterministic.
FitData thinned(const FitData& data, std::size_t rows);

}  // namespace brdf::fit
