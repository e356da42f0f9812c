#include "fit/between/round_robin.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/albedo.h"
#include "fit/assess/derived.h"
#include "fit/assess/reported.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

// Computes the consensus, unless an obstacle is known.
void conclude(RoundRobinQuantity& q) {
  for (const LaboratoryValue& v : q.values)
    if (q.obstacle.empty() && !(v.uncertainty > 0 && std::isfinite(v.value) && std::isfinite(v.uncertainty)))
      q.obstacle = "a standard uncertainty of 0, or one that is not a number, gives no weight";
  if (q.obstacle.empty()) q.consensus = consensus_of(q.values);
}

// Returns the reason why nothing follows from the fits of some table; empty if there is no reason.
std::string first_obstacle(const FittedTables& fits) {
  for (const FittedTable& table : fits.tables)
    if (!table.obstacle.empty()) return table.obstacle;
  return {};
}

// Takes ln of a quantity if every laboratory's value allows it.
void use_logarithms(RoundRobinQuantity& q) {
  q.logarithmic = std::ranges::all_of(
      q.values, [](const LaboratoryValue& v) { return v.value > kLeastForLogarithm * v.uncertainty; });
  if (!q.logarithmic) return;
  for (LaboratoryValue& v : q.values) v = {std::log(v.value), v.uncertainty / v.value};
}

// Returns quantities that follow from the parameters: `f` gives every channel of the first name, then every
// channel of the next one.
std::vector<RoundRobinQuantity> derived_quantities(const FittedTables& fits,
                                                   const std::vector<std::string>& names, const Derived& f,
                                                   const std::string& obstacle) {
  std::vector<RoundRobinQuantity> out;
  for (const std::string& name : names)
    for (const std::string& channel : fits.channels)
      out.push_back({.name = label(name, fits.channels.size() > 1 ? channel : ""),
                     .natural = {},
                     .values = {},
                     .consensus = {},
                     .obstacle = obstacle});
  for (const FittedTable& table : fits.tables) {
    const std::vector<double> values = f(table.fit.material);
    const auto errors = table.fit.covariance
                            ? standard_errors(table.fit.material, *table.fit.covariance, values.size(), f)
                            : std::nullopt;
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k].natural.push_back(values[k]);
      out[k].values.push_back({values[k], errors ? (*errors)[k].value : 0});
    }
  }
  for (RoundRobinQuantity& q : out) use_logarithms(q);
  return out;
}

// Returns f at the asked directions, then the albedo at the asked angles.
std::vector<RoundRobinQuantity> asked_quantities(const FittedTables& fits, const AskedQuantities& asked,
                                                 const std::string& obstacle) {
  std::vector<std::string> values, albedos;
  for (const AskedDirections& at : asked.at) values.push_back("f(" + to_text(at) + ")");
  for (const double theta : asked.albedo) albedos.push_back("albedo(" + io::to_text(theta) + ")");
  auto out = derived_quantities(
      fits, values, [&](const Material& m) { return values_at(m, asked.at); }, obstacle);
  for (RoundRobinQuantity& q : derived_quantities(
           fits, albedos, [&](const Material& m) { return albedos_at(m, asked.albedo); }, obstacle))
    out.push_back(std::move(q));
  return out;
}

// Returns the names of all parameters that some fit determines, in the order of the fits.
std::vector<std::string> parameter_names(const std::vector<ComparedParameters>& all) {
  std::vector<std::string> names;
  for (const ComparedParameters& p : all)
    for (const std::string& name : p.names)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

RoundRobinQuantity parameter(const FittedTables& fits, const std::vector<ComparedParameters>& all,
                             const std::string& name) {
  RoundRobinQuantity q{.name = name, .natural = {}, .values = {}, .consensus = {}, .obstacle = {}};
  for (std::size_t t = 0; t < all.size(); ++t) {
    const FittedTable& table = fits.tables[t];
    if (const std::string obstacle = obstacle_of(table.fit, name); !obstacle.empty() && q.obstacle.empty())
      q.obstacle = obstacle + " for " + table.name;
    const std::size_t k = all[t].find(name);
    if (k == all[t].names.size()) {
      const auto value = parameter_value(table.fit.material, name);
      q.natural.push_back(value ? value->value : kUnknown);
      q.values.push_back({kUnknown, 0});
      q.logarithmic = false;
      continue;
    }
    q.logarithmic = all[t].logarithmic[k];
    q.natural.push_back(all[t].natural[k]);
    q.values.push_back({all[t].values[k], all[t].uncertainty(k)});
  }
  return q;
}

}  // namespace

double RoundRobinQuantity::consensus_value(int side) const {
  const double value = consensus->value + side * consensus->half_width;
  return logarithmic ? std::exp(value) : value;
}

bool RoundRobin::is_decided() const {
  return std::ranges::all_of(quantities, [](const RoundRobinQuantity& q) { return q.consensus.has_value(); });
}

RoundRobin round_robin(FittedTables fits, const AskedQuantities& asked) {
  RoundRobin out{std::move(fits), {}};
  const std::string obstacle = first_obstacle(out.fits);
  out.quantities = asked_quantities(out.fits, asked, obstacle);
  if (obstacle.empty()) {
    std::vector<const FormFit*> each;
    for (const FittedTable& table : out.fits.tables) each.push_back(&table.fit);
    const std::vector<ComparedParameters> all = compared_parameters(each);
    for (const std::string& name : parameter_names(all))
      out.quantities.push_back(parameter(out.fits, all, name));
  }
  for (RoundRobinQuantity& q : out.quantities) conclude(q);
  return out;
}

}  // namespace brdf::fit
