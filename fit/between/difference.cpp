#include "fit/between/difference.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "fit/algebra/eigen_view.h"
#include "fit/assess/derived.h"
#include "fit/assess/reported.h"
#include "fit/assess/student.h"
#include "io/files/evenly.h"
#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kLights = 5;
constexpr double kViewStep = 5;      // degrees
constexpr double kSingular = 1e-12;  // least eigenvalue of the correlations over the largest

// Returns C^-1, or std::nullopt if C is not positive definite. The variances may differ by many orders, so
// that the correlations are inverted.
std::optional<RowMatrix> inverse_of(const Matrix& covariance) {
  const RowMatrix c = view_of(covariance);
  const Eigen::VectorXd variances = c.diagonal();
  if (c.rows() == 0 || !(variances.minCoeff() > 0) || !variances.allFinite()) return std::nullopt;
  const Eigen::VectorXd scale = variances.cwiseSqrt().cwiseInverse();
  const RowMatrix correlation = scale.asDiagonal() * c * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<RowMatrix> eigen(correlation);
  if (!(eigen.eigenvalues().minCoeff() > kSingular * eigen.eigenvalues().maxCoeff())) return std::nullopt;
  const RowMatrix inverse = eigen.eigenvectors() * eigen.eigenvalues().cwiseInverse().asDiagonal() *
                            eigen.eigenvectors().transpose();
  return RowMatrix(scale.asDiagonal() * inverse * scale.asDiagonal());
}

Eigen::Map<const Eigen::VectorXd> vector_of(const std::vector<double>& v) {
  return {v.data(), Eigen::Index(v.size())};
}

// Adds the variance along `v` and its part that is uncertain (fit/assess/derived.h).
void add_variance(const ComparedParameters& p, const Eigen::VectorXd& v, double& variance,
                  double& uncertain) {
  for (std::size_t k = 0; k < p.components.rows; ++k) {
    double along = 0;
    for (std::size_t a = 0; a < p.names.size(); ++a) along += p.components(k, a) * v(Eigen::Index(a));
    variance += square(along);
    uncertain += square(along) / std::sqrt(p.freedom[k]);
  }
}

// Returns the reason why the parameters of the two fits cannot be compared; empty if they can.
std::string obstacle_to(const FittedTables& fits) {
  for (const FittedTable& table : fits.tables)
    if (!table.obstacle.empty()) return table.obstacle;
  const FittedTable &a = fits.tables[0], &b = fits.tables[1];
  for (const auto& [one, other] : {std::pair{&a, &b}, std::pair{&b, &a}})
    for (const std::string& name : one->fit.covariance->names) {
      if (const std::string reason = obstacle_of(one->fit, name); !reason.empty())
        return reason + " for " + one->name + "; hold it by --fix, or choose another form";
      if (const std::string reason = obstacle_of(other->fit, name); !reason.empty())
        return reason + " for " + other->name + " and free for " + one->name +
               "; hold it by --fix, or choose another form";
    }
  return {};
}

// Returns directions of the plane of incidence within the angles that both tables contain.
std::vector<AskedDirections> directions_of(const std::vector<TableToFit>& tables) {
  std::set<double> lights;
  double steepest = 90, flattest = 90;
  for (const TableToFit& t : tables) {
    const io::SampleTable& table = t.samples.table;
    double most_i = 0, most_o = 0;
    for (std::size_t k = 0; k < table.rows(); ++k) {
      if (table.is_beyond(k, t.options.max_theta)) continue;
      lights.insert(table.theta_i[k]);
      most_i = std::max(most_i, table.theta_i[k]);
      most_o = std::max(most_o, table.theta_o[k]);
    }
    steepest = std::min(steepest, most_i);
    flattest = std::min(flattest, most_o);
  }
  std::vector<double> within;
  for (const double theta : lights)
    if (theta <= steepest) within.push_back(theta);
  std::vector<AskedDirections> out;
  for (const double light : io::evenly(std::move(within), kLights)) {
    for (double view = kViewStep * std::floor(flattest / kViewStep); view > 0; view -= kViewStep)
      out.push_back({light, view, 0});
    for (double view = 0; view <= flattest; view += kViewStep) out.push_back({light, view, 180});
  }
  return out;
}

// Compares ln f at directions. Directions at which a fit is not above 0 are left out.
void compare_directions(const std::vector<TableToFit>& tables, Difference& out) {
  const std::vector<AskedDirections> at = directions_of(tables);
  const std::size_t channels = out.fits.channels.size();
  std::vector<std::vector<double>> values;
  std::vector<std::vector<StandardError>> errors;
  for (const FittedTable& table : out.fits.tables) {
    const auto f = [&](const Material& m) { return values_at(m, at); };
    values.push_back(f(table.fit.material));
    const auto found = standard_errors(table.fit.material, *table.fit.covariance, values.back().size(), f);
    if (!found) return;
    errors.push_back(*found);
  }
  for (std::size_t k = 0; k < values[0].size(); ++k) {
    const double a = values[0][k], b = values[1][k];
    if (!(a > 0 && b > 0)) continue;
    DirectionDifference d{at[k / channels], out.fits.channels[k % channels], std::log(a / b),
                          std::hypot(errors[0][k].value / a, errors[1][k].value / b)};
    d.beyond = std::abs(d.difference) > out.band * d.uncertainty;
    out.directions.push_back(std::move(d));
  }
}

// Judges each parameter. The level is divided among the parameters (Bonferroni).
void judge_parameters(Difference& out) {
  const double level = kSignificance / double(out.parameters.size());
  for (ParameterDifference& p : out.parameters)
    p.beyond = 2 * t_tail(out.freedom, std::abs(p.difference) / p.uncertainty) < level;
}

}  // namespace

std::optional<double> quadratic_form(const std::vector<double>& difference, const Matrix& covariance) {
  const auto inverse = inverse_of(covariance);
  if (!inverse) return std::nullopt;
  const auto d = vector_of(difference);
  return d.dot(*inverse * d);
}

Remainder remainder_without(const std::vector<double>& difference, const Matrix& covariance,
                            const std::vector<double>& change, double freedom) {
  const auto inverse = inverse_of(covariance);
  if (!inverse) return {0, kUnknown, kUnknown};
  const auto d = vector_of(difference), v = vector_of(change);
  const double all = d.dot(*inverse * d), along = v.dot(*inverse * d), own = v.dot(*inverse * v);
  if (!(own > 0)) return {0, all, 0};
  Remainder out{along / own, std::max(all - square(along) / own, 0.0)};
  const double dimension = double(difference.size()) - 1;
  out.probability = dimension > 0 ? quadratic_tail(out.statistic, dimension, freedom) : 1;
  return out;
}

std::vector<std::string> Difference::differing() const {
  std::vector<std::string> names;
  if (sameness != Sameness::different || !(probability < kSignificance)) return names;
  for (const ParameterDifference& p : parameters)
    if (p.beyond) names.push_back(p.name);
  if (!names.empty()) return names;
  std::vector<double> d;
  for (const ParameterDifference& p : parameters) d.push_back(p.difference);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    std::vector<double> change(parameters.size());
    change[k] = 1;
    const double rest = remainder_without(d, covariance, change, freedom).statistic;
    if (rest < least) least = rest, names = {parameters[k].name};
  }
  return names;
}

namespace {

// Returns the parameters in the order of `names`, all of which it has.
ComparedParameters reordered(const ComparedParameters& p, const std::vector<std::string>& names) {
  ComparedParameters out{names, {}, {}, {}, Matrix(p.components.rows, names.size()), p.freedom};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::size_t from = p.find(names[k]);
    out.logarithmic.push_back(p.logarithmic[from]);
    out.natural.push_back(p.natural[from]);
    out.values.push_back(p.values[from]);
    for (std::size_t row = 0; row < p.components.rows; ++row)
      out.components(row, k) = p.components(row, from);
  }
  return out;
}

// Sets the parameters, the statistic and the obstacle of a difference of parameters in the same order.
void compare_parameters(const ComparedParameters& a, const ComparedParameters& b, Difference& out) {
  const RowMatrix own = view_of(a.components), other = view_of(b.components);
  out.covariance = matrix_of(own.transpose() * own + other.transpose() * other);
  const std::size_t n = a.names.size();
  Eigen::VectorXd d(n);
  for (std::size_t k = 0; k < n; ++k) {
    d(Eigen::Index(k)) = a.values[k] - b.values[k];
    out.parameters.push_back({a.names[k], a.logarithmic[k], a.natural[k], b.natural[k], d(Eigen::Index(k)),
                              std::sqrt(out.covariance(k, k))});
  }
  const auto inverse = inverse_of(out.covariance);
  if (!inverse) {
    out.obstacle =
        "the covariance of the parameters is singular: the values have no scatter, or the samples do "
        "not tell the parameters apart";
    return;
  }
  const Eigen::VectorXd along = *inverse * d;
  out.statistic = d.dot(along);
  double variance = 0, uncertain = 0;
  add_variance(a, along, variance, uncertain);
  add_variance(b, along, variance, uncertain);
  out.freedom = variance > 0 ? square(variance / uncertain) : std::numeric_limits<double>::max();
  out.probability = quadratic_tail(out.statistic, double(n), out.freedom);
  out.band = std::sqrt(quadratic_quantile(double(n), out.freedom));
  judge_parameters(out);
}

// Returns why the form could hide a difference; empty if it describes both tables.
std::string misfit_of(const FittedTables& fits) {
  for (const FittedTable& t : fits.tables)
    if (const double ratio = t.fit.lack_of_fit.residual_over_scatter.value_or(0); ratio > kGrossMisfit)
      return fits.form + " describes " + t.name + " only roughly: its residuals are " +
             io::short_number(ratio, 2) +
             " times the noise, and a difference that the form cannot describe is not seen; measure the same "
             "directions with both instruments, or choose another form";
  return {};
}

void judge(const std::vector<TableToFit>& tables, Difference& out) {
  out.common = common_values(out.fits.tables, tables);
  out.sameness = Sameness::different;
  if (out.probability < kSignificance || (out.common && out.common->differ())) return;
  if (!out.common) out.doubt = misfit_of(out.fits);
  out.sameness = out.doubt.empty() ? Sameness::no_difference : Sameness::undecided;
}

}  // namespace

Difference difference_of(FittedTables fits, const std::vector<TableToFit>& tables) {
  Difference out{.fits = std::move(fits)};
  out.obstacle = obstacle_to(out.fits);
  if (!out.obstacle.empty()) return out;
  const std::vector<const FormFit*> each{&out.fits.tables[0].fit, &out.fits.tables[1].fit};
  const std::vector<ComparedParameters> p = compared_parameters(each);
  compare_parameters(p[0], reordered(p[1], p[0].names), out);
  if (!out.obstacle.empty()) return out;
  compare_directions(tables, out);
  if (out.fits.have_budgets()) judge(tables, out);
  return out;
}

}  // namespace brdf::fit
