#include "fit/assess/profiles.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/profile_search.h"
#include "fit/assess/student.h"
#include "io/files/parallel.h"

namespace brdf::fit {
namespace {

constexpr double kLogMove = 0.5, kRangeMove = 0.25;  // of a shape along a valley, on the solver's scale

// Returns whether the upper limit of a weight is the default rather than the user's choice.
bool is_boundless(const Reported& r) {
  return r.weight && !r.divided && r.max >= kWeightMax;
}

// Sets the interval from the two ends of a profile, and the status: whether the profile identifies the
// parameter.
void take_profile(const ProfileSides& sides, std::size_t index, const Grounds& on, Reported& r) {
  Estimate& e = r.estimate;
  const auto value = [&](const ProfileEnd& end) {
    return reported_parameters(on.model, end.at.p)[index].estimate.value;
  };
  e.low_open = sides.low.open;
  e.high_open = sides.high.open;
  e.low = e.low_open ? r.min : std::min(value(sides.low), e.value);
  e.high = e.high_open ? r.max : std::max(value(sides.high), e.value);
  const auto on_scale = [&](double x) {
    return r.scale == kNoSlot ? x : on.model.slots()[r.scale].to_solver(x);
  };
  const double below = on_scale(e.value) - on_scale(e.low), above = on_scale(e.high) - on_scale(e.value);
  const bool one_sided = e.low_open || e.high_open;
  const double half = one_sided ? std::max(below, above) : (below + above) / 2;
  const bool unknown = (e.low_open && e.high_open) || (e.high_open && is_boundless(r)) ||
                       says_nothing(r, on.model, half / t_quantile(on.freedom));
  e.status = unknown ? Status::unidentified : at_bound(r, on.minimum) ? Status::at_bound : Status::free;
  if (e.status != Status::free) e.standard_error = e.freedom = 0;
}

// Returns whether a parameter has a profile. Held parameters have no profile, nor have parameters that are
// unknown for another reason.
bool has_profile(const Reported& r, const Grounds& on) {
  if (r.gradient.empty() || r.without_lobe || on.few || (on.unturned && asks_for_turn(r, on.model)))
    return false;
  return std::ranges::any_of(r.gradient,
                             [&](const auto& g) { return on.curvature.scale(Eigen::Index(g.first)) > 0; });
}

// Returns the variance of a parameter relative to its variance under noise of variance 1. The larger the
// ratio, the higher the level of the profile at which the interval ends.
double noise_ratio(const Reported& r, const Grounds& on) {
  const Eigen::VectorXd g = gradient_vector(r, on.curvature.inverse.rows());
  const double own = g.dot(on.curvature.inverse * g);
  return own > 0 ? square(on.error_of(g, r.estimate.deciding)) / own : 0;
}

// Returns the first parameter with the same slot: tied widths share one slot.
std::size_t first_of_slot(const std::vector<Reported>& all, std::size_t k) {
  for (std::size_t before = 0; before < k && all[k].slot != kNoSlot; ++before)
    if (all[before].slot == all[k].slot) return before;
  return k;
}

bool is_of_lobe(const Reported& r) {
  return !r.weight || r.info->role == Role::specular;
}

// The largest noise ratio of all parameters, and of the parameters of lobes.
struct Ratios {
  double all = 0, of_lobes = 0;
};

ProfileLevel level_of(const Reported& r, const Grounds& on, const Ratios& largest) {
  const double t = t_quantile(on.freedom);
  const Eigen::VectorXd g = gradient_vector(r, on.curvature.inverse.rows());
  const double of_lobes = is_of_lobe(r) ? 0.5 * t * t * largest.of_lobes : 0;
  if (on.curvature.without_effect(g)) return {0.5 * t * t * largest.all, 0, of_lobes};
  const double error = t * error_on_scale(r, on.model, on.error_of(g, r.estimate.deciding));
  // For a tangent, the search is in radians.
  const bool own_unit = r.slot != kNoSlot && r.scale == kNoSlot;
  return {0.5 * t * t * noise_ratio(r, on), own_unit ? error / r.gradient[0].second : error, of_lobes};
}

// Returns whether a shape moves so far along a profile that different values of the parameter go with
// different values of the shape.
bool shapes_move(const ProfileSides& sides, const Grounds& on) {
  for (const ProfileEnd* end : {&sides.low, &sides.high})
    for (std::size_t k = 0; k < on.model.shape_slots(); ++k) {
      const Slot& slot = on.model.slots()[k];
      const bool logarithmic = slot.scale == Scale::log || slot.scale == Scale::log1p;
      const double most = logarithmic ? kLogMove : kRangeMove * (slot.high - slot.low);
      if (std::abs(end->at.p[k] - on.minimum.p[k]) > most) return true;
    }
  return false;
}

// Returns whether a weight of the material at an end could just as well have any larger value.
bool is_unbounded(const std::vector<double>& p, const std::vector<Reported>& all, const Grounds& on) {
  const std::vector<Reported> there = reported_parameters(on.model, p);
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].estimate.high_open && is_boundless(all[k]) && there[k].estimate.value > all[k].max / 2)
      return true;
  return false;
}

// Returns the other minima with a cost low enough for an interval to reach them.
std::vector<std::vector<double>> minima_within_reach(const SampleStream& stream, const Grounds& on,
                                                     double ratio, const ProfileOptions& options) {
  constexpr double kReach = 5;  // times the highest level
  const double level = 0.5 * square(t_quantile(on.freedom)) * ratio;
  std::vector<std::vector<double>> out;
  for (const std::vector<double>& p : options.other_minima)
    if (stream.normal_equations(p).cost < on.minimum.cost + kReach * level) out.push_back(p);
  return out;
}

// Adds the profile of ks f0 for each pair in which neither factor is identifiable.
void add_products(const ProfileStart& start, const std::vector<Reported>& all, const Grounds& on,
                  const Ratios& largest, Uncertainty& out) {
  for (std::size_t f0 = 0; f0 < all.size(); ++f0) {
    const Reported& r = all[f0];
    if (!r.divided || r.estimate.status != Status::unidentified || !has_profile(r, on)) continue;
    const auto is_weight = [&](const Reported& other) {
      return other.info == r.divided && other.estimate.channel == r.estimate.channel &&
             other.estimate.status == Status::unidentified;
    };
    const auto weight = std::ranges::find_if(all, is_weight);
    if (weight == all.end()) continue;
    const std::size_t k = std::size_t(weight - all.begin());
    Reported product = product_of(all, k, f0);
    const ProfileSides sides = find_ends(start, product, k, level_of(product, on, largest));
    const auto value = [&](const ProfileEnd& end) {
      const std::vector<Reported> there = reported_parameters(on.model, end.at.p);
      return there[k].estimate.value * there[f0].estimate.value;
    };
    Estimate& e = product.estimate;
    e.low = std::min(value(sides.low), e.value);
    e.high = std::max(value(sides.high), e.value);
    e.low_open = sides.low.open;
    e.high_open = sides.high.open;
    if (!e.low_open && !e.high_open) out.products.push_back(std::move(e));
  }
}

}  // namespace

void profile_all(std::vector<Reported>& all, const SampleStream& stream, const Grounds& on,
                 const ProfileOptions& options, Uncertainty& out) {
  if (on.exact) {
    out.profiled = true;
    return;
  }
  std::vector<std::size_t> searched;
  Ratios largest;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!has_profile(all[k], on)) continue;
    if (first_of_slot(all, k) == k) searched.push_back(k);
    const double ratio = noise_ratio(all[k], on);
    largest.all = std::max(largest.all, ratio);
    if (is_of_lobe(all[k])) largest.of_lobes = std::max(largest.of_lobes, ratio);
  }
  if (!(largest.all > 0)) return;
  ProfileSeeds seeds(stream, minima_within_reach(stream, on, largest.all, options));
  const ProfileStart start{stream, on.minimum, on.curvature, seeds, options.interrupted};
  std::vector<ProfileSides> sides(all.size());
  const auto search = [&](std::size_t j) {
    const std::size_t k = searched[j];
    sides[k] = find_ends(start, all[k], k, level_of(all[k], on, largest));
  };
  io::parallel_for(searched.size(), search, options.threads);
  bool bends = seeds.any();
  std::vector<CostedPoint> known;
  for (const std::size_t k : searched) {
    const bool absent = all[k].info->role == Role::specular && sides[k].low.limit_is_near;
    bends = bends || !sides[k].quadratic || absent;
    known.insert(known.end(), sides[k].near.begin(), sides[k].near.end());
  }
  const auto extend = [&](std::size_t j) {
    const std::size_t k = searched[j];
    extend_ends(start, all[k], k, level_of(all[k], on, largest), known, sides[k]);
  };
  if (bends) io::parallel_for(searched.size(), extend, options.threads);
  if (options.interrupted && options.interrupted->load()) return;
  out.profiled = true;
  out.singular = on.unturned;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!has_profile(all[k], on)) continue;
    const ProfileSides& found = sides[first_of_slot(all, k)];
    take_profile(found, k, on, all[k]);
    all[k].moves_shapes = all[k].weight && shapes_move(found, on);
  }
  for (const std::size_t k : searched)
    for (const ProfileEnd* end : {&sides[k].low, &sides[k].high})
      out.ends.push_back({end->at.p, end->open || is_unbounded(end->at.p, all, on)});
  add_products(start, all, on, largest, out);
}

}  // namespace brdf::fit
