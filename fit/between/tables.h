// Tables of one surface from several instruments, fitted with the same form and the same metric.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/fit.h"

namespace brdf::fit {

// A table with the options of its own fit: its uncertainty budget and its aperture may be its own.
struct TableToFit {
  Samples samples;
  FitOptions options;
};

struct FittedTable {
  std::string name;  // of the file
  std::size_t rows = 0;
  FormFit fit;
  bool has_budget = false;
  // The reason why nothing follows from the covariance of the parameters, as a clause: "the form does not
  // describe paint.csv". Empty if there is no such reason.
  std::string obstacle;
};

struct FittedTables {
  std::string form;                // "cook_torrance"
  std::vector<Reflectance> model;  // of this name
  Metric metric = Metric::log;
  std::string form_reason, metric_reason;  // how both were chosen; empty if they were given
  std::vector<std::string> channels;
  std::vector<FittedTable> tables;

  // Returns whether the tables have budgets: all of them have one, or no table has.
  bool have_budgets() const { return !tables.empty() && tables.front().has_budget; }
};

// Fits all tables with one model. If `models` has several (or is empty, for the steps of --form auto), the
// model is the one that is recommended for the rows of all tables together. If the metric is left open, it is
// the metric that most tables choose, and it becomes the metric of their options. Fits have no
// cross-validation. Throws InputError for fewer than two
// tables, for tables with different channels, or if some tables have a budget and others do not.
FittedTables fit_tables(std::span<TableToFit> tables, std::vector<std::vector<Reflectance>> models,
                        const Progress& progress = {});

// Fits one table with the model of the others. Its options name the metric.
FittedTable fit_table(const TableToFit& table, const std::vector<Reflectance>& model,
                      const Progress& progress = {});

}  // namespace brdf::fit
