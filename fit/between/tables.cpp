#include "fit/between/tables.h"

#include <algorithm>
#include <array>

#include "fit/choice.h"
#include "io/files/error.h"
#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

// Throws unless the tables can be compared channel by channel.
void require_same_channels(std::span<const TableToFit> tables) {
  const io::SampleTable& first = tables.front().samples.table;
  for (const TableToFit& t : tables) {
    const io::SampleTable& table = t.samples.table;
    if (table.channels != first.channels)
      throw InputError(table.name() + ": the channels are " + io::joined(table.channels) + ", but " +
                       first.name() + " has " + io::joined(first.channels) +
                       ": tables of one surface must have the same channels; convert one of them, or select "
                       "columns with --layout");
  }
}

// Returns the rows of all tables as one table.
io::SampleTable joined(std::span<const TableToFit> tables) {
  io::SampleTable out;
  out.set_channels(tables.front().samples.table.channels);
  for (const TableToFit& t : tables) {
    const io::SampleTable& table = t.samples.table;
    for (std::size_t k = 0; k < table.rows(); ++k)
      out.add_directions(table.theta_i[k], table.phi_i[k], table.theta_o[k], table.phi_o[k]);
    for (std::size_t c = 0; c < table.channels.size(); ++c)
      out.values[c].insert(out.values[c].end(), table.values[c].begin(), table.values[c].end());
  }
  out.source = "all tables";
  return out;
}

// Chooses the metric that most tables choose.
void choose_metric(std::span<TableToFit> tables, FittedTables& out) {
  std::array<std::size_t, kResiduals.size()> votes{};
  for (const TableToFit& t : tables) ++votes[std::size_t(prepared(t.samples.table, t.options).metric.metric)];
  const auto most = std::ranges::max_element(votes);
  out.metric = Metric(most - votes.begin());
  if (tables.front().options.metric == Metric::automatic)
    out.metric_reason = "chosen by " + std::to_string(*most) + " of " + io::plural(tables.size(), "table");
  for (TableToFit& t : tables) t.options.metric = out.metric;
}

// Chooses the model that is recommended for the rows of all tables together.
void choose_model(std::span<const TableToFit> tables, const std::vector<std::vector<Reflectance>>& models,
                  const Progress& progress, FittedTables& out) {
  FitOptions options = tables.front().options;
  options.budget = nullptr;  // of one table
  const FitResult all = fit(joined(tables), models, options, progress);
  out.form = all.ranking[all.recommended].form;
  out.model = models_of(out.form).front();
  out.form_reason = "recommended for the rows of all tables together";
}

bool is_obstacle(Verdict verdict) {
  return verdict == Verdict::misfit || verdict == Verdict::not_identifiable || verdict == Verdict::diverged ||
         verdict == Verdict::interrupted;
}

std::string obstacle_to_use(const FormFit& fit, const std::string& table, bool has_budget) {
  const std::string reason = fit.findings.empty() ? "" : ": " + fit.findings.front();
  if (fit.verdict == Verdict::misfit) return fit.form + " does not describe " + table + reason;
  if (is_obstacle(fit.verdict))
    return "the fit to " + table + " has the verdict " + std::string(name_of(fit.verdict)) + reason;
  if (fit.lack_of_fit.exact && !has_budget)
    return "the values of " + table + " have no scatter, so that no uncertainty is known";
  if (!fit.covariance) return "the uncertainty of the parameters for " + table + " is not known" + reason;
  return {};
}

void require_all_budgets(const FittedTables& fits) {
  const auto with = std::ranges::find(fits.tables, true, &FittedTable::has_budget);
  const auto without = std::ranges::find(fits.tables, false, &FittedTable::has_budget);
  if (with == fits.tables.end() || without == fits.tables.end()) return;
  throw InputError(without->name + " has no uncertainty budget, but " + with->name +
                   " has one: a table with an uncertainty of scatter alone would outweigh the others; give "
                   "every table a budget (--budget once for all, or once for each), or remove all budgets");
}

}  // namespace

FittedTable fit_table(const TableToFit& table, const std::vector<Reflectance>& model,
                      const Progress& progress) {
  FitResult result = fit(table.samples, {model}, table.options, progress);
  FittedTable out{table.samples.table.name(),
                  result.rows,
                  std::move(result.ranking.front()),
                  table.samples.budget || table.options.budget,
                  {}};
  out.obstacle = obstacle_to_use(out.fit, out.name, out.has_budget);
  return out;
}

FittedTables fit_tables(std::span<TableToFit> tables, std::vector<std::vector<Reflectance>> models,
                        const Progress& progress) {
  if (tables.size() < 2) throw InputError("SAMPLES: at least two tables are needed");
  require_same_channels(tables);
  FittedTables out;
  out.channels = tables.front().samples.table.channels;
  choose_metric(tables, out);
  if (models.size() == 1) {
    out.model = models.front();
  } else {
    choose_model(tables, models, progress, out);
  }
  for (TableToFit& t : tables) {
    t.options.cross_validation = false;
    out.tables.push_back(fit_table(t, out.model, progress));
  }
  out.form = out.tables.front().fit.form;
  require_all_budgets(out);
  return out;
}

}  // namespace brdf::fit
