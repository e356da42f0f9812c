#include "fit/between/explanations.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "fit/assess/derived.h"
#include "fit/assess/student.h"

namespace brdf::fit {
namespace {

constexpr double kAlmostGrazing = 89.9;  // degrees
constexpr int kSteps = 12;
constexpr double kSameSize = 1e-3;  // relative change of a size that ends the search

// The sizes with which the search begins, and their limits. An aperture acts by its square.
struct Search {
  double first, largest;
  bool by_square;
};

Search search_of(Cause cause) {
  switch (cause) {
    case Cause::scale:
      return {0.01, kLargestScale, false};
    case Cause::aperture:
      return {2, kLargestAperture, true};
    default:
      return {0.2, kLargestZeroError, false};
  }
}

// Moves a polar angle; on the other side of the normal the azimuth turns by half a turn.
void move(double& theta, double& phi, double by) {
  theta += by;
  if (theta < 0) {
    theta = -theta;
    phi += phi < 180 ? 180 : -180;
  }
  theta = std::min(theta, kAlmostGrazing);
}

// The cosines of stated angles by which an instrument divides its readings.
struct Divisors {
  bool cos_i = false, cos_o = true;
};

std::shared_ptr<const io::Budget> budget_of(const TableToFit& table) {
  return table.samples.budget ? table.samples.budget : table.options.budget;
}

Divisors divisors_of(const TableToFit& table) {
  const auto budget = budget_of(table);
  return budget ? Divisors{budget->divides_by_cos_i, budget->divides_by_cos_o} : Divisors();
}

// Moves a polar angle. Returns the factor by which the reading changes if it is divided by the cosine of the
// true angle instead of the stated one; 1 if the instrument does not divide.
double moved(double& theta, double& phi, double by, bool divides) {
  const double stated = std::cos(degrees(theta).radians());
  move(theta, phi, by);
  return divides ? stated / std::cos(degrees(theta).radians()) : 1;
}

// Gives the table the values and directions that it would have without the error.
void correct(io::SampleTable& table, Cause cause, double size, const Divisors& divisors) {
  for (std::size_t k = 0; k < table.rows(); ++k) {
    double factor = 1;
    if (cause == Cause::scale) factor = 1 / (1 + size);
    if (cause == Cause::zero_theta_i) factor = moved(table.theta_i[k], table.phi_i[k], size, divisors.cos_i);
    if (cause == Cause::zero_theta_o) factor = moved(table.theta_o[k], table.phi_o[k], size, divisors.cos_o);
    for (auto* columns : {&table.values, &table.sigma})
      for (std::vector<double>& column : *columns)
        if (!column.empty()) column[k] *= factor;
  }
}

// Removes the rows that the fit leaves out, so that a moved angle does not change the choice of the rows.
void keep_fitted_rows(TableToFit& t) {
  io::SampleTable& table = t.samples.table;
  std::vector<bool> beyond(table.rows());
  for (std::size_t k = 0; k < beyond.size(); ++k) beyond[k] = table.is_beyond(k, t.options.max_theta);
  sheet::leave_out(beyond, table);
  t.options.max_theta = 90;
}

// Returns the standard uncertainty of an error of a whole table, by its budget.
double stated_uncertainty(const TableToFit& table, Cause cause) {
  const auto budget = budget_of(table);
  if (!budget || cause == Cause::aperture) return 0;
  const io::BudgetEffect effect = cause == Cause::scale          ? io::BudgetEffect::scale
                                  : cause == Cause::zero_theta_i ? io::BudgetEffect::theta_i
                                                                 : io::BudgetEffect::theta_o;
  double variance = 0;
  for (const io::BudgetSource& source : budget->sources)
    if (source.effect == effect && source.shared_by == io::SharedBy::table)
      variance += square(source.standard_uncertainty);
  return std::sqrt(variance);
}

// The search for the size of one error in one table.
class ErrorSearch {
 public:
  ErrorSearch(const Difference& difference, const TableToFit& table, std::size_t which, Cause cause)
      : difference_(difference),
        table_(table),
        divisors_(divisors_of(table)),
        which_(which),
        cause_(cause),
        search_(search_of(cause)) {
    keep_fitted_rows(table_);
    table_.options.profiles = false;
    table_.options.budget = nullptr;  // a change of the parameters is sought, not their uncertainty
    table_.samples.budget = nullptr;
    for (const ParameterDifference& p : difference.parameters) whole_.push_back(p.difference);
    start_ = parameters_at(0);
  }

  Explanation run() {
    Explanation out{cause_, difference_.fits.tables[which_].name, 0, difference_.statistic, 0};
    if (!start_) return out;
    bool is_better = false, is_settled = false;
    double size = search_.first;
    for (int step = 0; step < kSteps && !is_settled; ++step) {
      const auto change = change_at(size);
      if (!change) break;
      if (const auto rest = rest_of(*change); rest && *rest < out.statistic) {
        out.statistic = *rest;
        out.size = size;
        is_better = true;
      }
      const double next = size_after(size, *change);
      if (!(std::abs(next) > 0)) break;
      is_settled = std::abs(next - size) < kSameSize * std::abs(size);
      size = next;
    }
    judge(out, is_better, is_settled && std::abs(size) < search_.largest);
    return out;
  }

 private:
  // Returns the size, within the limits, for which the least of the difference is left to first order.
  double size_after(double size, const std::vector<double>& change) const {
    const double factor = remainder_without(whole_, difference_.covariance, change, difference_.freedom).size;
    const double next = search_.by_square ? size * std::sqrt(std::max(factor, 0.0)) : size * factor;
    return std::clamp(next, -search_.largest, search_.largest);
  }

  // Returns the parameters of a fit to the table that is corrected for an error of this size.
  std::optional<std::vector<double>> parameters_at(double size) const {
    TableToFit changed = table_;
    if (cause_ == Cause::aperture)
      changed.options.aperture = size;
    else
      correct(changed.samples.table, cause_, size, divisors_);
    const FormFit fit = fit_table(changed, difference_.fits.model).fit;
    if (!fit.solved()) return std::nullopt;
    std::vector<double> out;
    for (const ParameterDifference& p : difference_.parameters) {
      const auto value = parameter_value(fit.material, p.name);
      if (!value || (p.logarithmic && !(value->value > 0))) return std::nullopt;
      out.push_back(p.logarithmic ? std::log(value->value) : value->value);
    }
    return out;
  }

  // Returns the part of the difference that an error of this size explains.
  std::optional<std::vector<double>> change_at(double size) const {
    const auto there = parameters_at(size);
    if (!there) return std::nullopt;
    std::vector<double> change;
    const double sign = which_ == 0 ? 1 : -1;
    for (std::size_t k = 0; k < there->size(); ++k) change.push_back(sign * ((*start_)[k] - (*there)[k]));
    return change;
  }

  std::optional<double> rest_of(const std::vector<double>& change) const {
    std::vector<double> rest = whole_;
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] -= change[k];
    return quadratic_form(rest, difference_.covariance);
  }

  // `is_least`: the size is the one that leaves the least of the difference, and not a step on the way to it.
  void judge(Explanation& out, bool is_better, bool is_least) const {
    const double dimension = double(whole_.size()) - 1;
    out.probability = dimension > 0 ? quadratic_tail(out.statistic, dimension, difference_.freedom) : 1;
    out.explains = is_better && out.probability >= kSignificance;
    out.found = out.explains || (is_better && is_least);
  }

  const Difference& difference_;
  TableToFit table_;
  Divisors divisors_;
  std::size_t which_;
  Cause cause_;
  Search search_;
  std::vector<double> whole_;
  std::optional<std::vector<double>> start_;
};

}  // namespace

std::vector<Explanation> explanations_of(const Difference& difference,
                                         const std::vector<TableToFit>& tables) {
  std::vector<Explanation> out;
  for (const Cause cause : {Cause::scale, Cause::zero_theta_i, Cause::zero_theta_o}) {
    out.push_back(ErrorSearch(difference, tables[1], 1, cause).run());
    out.back().stated =
        std::hypot(stated_uncertainty(tables[0], cause), stated_uncertainty(tables[1], cause));
  }
  std::optional<Explanation> best;
  for (std::size_t t = 0; t < tables.size(); ++t) {
    if (aperture_of(tables[t].samples.table, tables[t].options) > 0) continue;
    const Explanation e = ErrorSearch(difference, tables[t], t, Cause::aperture).run();
    if (!best || (e.found && (!best->found || e.statistic < best->statistic))) best = e;
  }
  if (best) out.push_back(*best);
  return out;
}

Comparison compare_tables(std::vector<TableToFit> tables, std::vector<std::vector<Reflectance>> models,
                          const Progress& progress) {
  if (tables.size() != 2) throw std::logic_error("compare_tables: two tables");
  FittedTables fits = fit_tables(tables, std::move(models), progress);
  Comparison out{difference_of(std::move(fits), tables), {}};
  const bool is_sought = out.difference.obstacle.empty() && out.difference.probability < kSignificance;
  if (is_sought) out.explanations = explanations_of(out.difference, tables);
  return out;
}

}  // namespace brdf::fit
