// The samples as the solver reads them: unit directions and values, structure of arrays.
#pragma once

#include <string>
#include <vector>

#include "fit/model/lobe_columns.h"
#include "fit/model/options.h"
#include "fit/model/row_groups.h"
#include "io/samples/samples.h"

namespace brdf::fit {

// Rows are sorted by group, direction and value, so that no result depends on their order in the table.
struct FitData {
  std::vector<std::string> channels;
  std::vector<double> wi_x, wi_y, wi_z, wo_x, wo_y, wo_z;
  std::vector<std::vector<double>> values;  // [channel][row], 1/sr
  std::vector<std::vector<double>> sigma;   // [channel][row]; empty where residuals are not weighted by it
  // [channel][row], the slope of a logarithmic residual at the value; empty: found again in every pass.
  std::vector<std::vector<double>> value_slope;
  std::vector<double> weight;            // [row] of the squared residual; empty: 1
  std::vector<std::uint32_t> row;        // in the table
  std::vector<std::uint32_t> incidence;  // [row] which direction of incidence
  RowGroups groups;                      // what is left out together; none in a subset
  bool grouped = false;                  // incidence is theta_i in whole degrees instead
  std::size_t beyond_max_theta = 0;      // rows left out
  std::size_t outside_domain = 0;        // rows whose value has no residual (far below zero)

  std::size_t rows() const { return wi_x.size(); }
  void add_directions(const Vec3<double>& wi, const Vec3<double>& wo);
  Directions<double> directions(std::size_t first, std::size_t rows) const;
};

// Throws InputError where nothing is left to fit.
FitData prepare(const io::SampleTable& table, const FitOptions& options);

// The rows whose values all have a residual under the metric; none where that is all of them.
FitData within_domain(const FitData& data, Metric metric);

// The rows that `keep` says, in order.
FitData subset(const FitData& data, const std::vector<bool>& keep);
// At most about `rows` rows, spread over the whole set, always the same ones.
FitData thinned(const FitData& data, std::size_t rows);

}  // namespace brdf::fit
