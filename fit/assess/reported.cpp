#include "fit/assess/reported.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

constexpr double kLogError = 1, kRangeError = 0.5, kFresnelError = 0.25, kWeightError = 0.5;
constexpr double kTangentError = 22.5;

// Returns the slot that sets one shape parameter of a term in a group.
std::size_t shape_slot(const Model& model, std::size_t term, std::size_t parameter, std::size_t group) {
  for (std::size_t s = 0; s < model.shape_slots(); ++s) {
    const Slot& slot = model.slots()[s];
    if (slot.kind == Slot::Kind::shape && slot.term == term && slot.in_group(group) &&
        std::ranges::find(slot.members, parameter) != slot.members.end())
      return s;
  }
  return kNoSlot;
}

void add_shape(const Model& model, std::span<const double> p, std::size_t t, std::vector<Reported>& out) {
  const TermModel& term = model.terms()[t];
  for (std::size_t g = 0; g < model.groups(); ++g) {
    const std::vector<double> shape = model.shape(p, t, g);
    for (std::size_t k = 0; k < shape.size(); ++k) {
      const std::size_t s = shape_slot(model, t, k, g);
      const bool smooth = s != kNoSlot && model.slots()[s].nodes > 1;
      const bool shared =
          model.groups() == 1 || (s != kNoSlot && !smooth && model.slots()[s].group == kEveryGroup);
      if (shared && g > 0) continue;
      Reported r;
      r.estimate.name = model.prefixed(t, term.info->shape[k].name);
      r.info = &term.info->shape[k];
      if (!shared) r.estimate.channel = model.channels()[g];
      r.estimate.value = shape[k];
      if (s != kNoSlot) {
        const Slot& slot = model.slots()[s];
        if (!smooth) r.slot = s;
        r.scale = s;
        r.gradient = model.shape_slopes(p, s, g);
        r.min = slot.min;
        r.max = slot.max;
      }
      out.push_back(std::move(r));
    }
  }
}

void add_weights(const Model& model, std::span<const double> p, std::size_t t, std::vector<Reported>& out) {
  const TermModel& term = model.terms()[t];
  const int divided = weight_of_f0(term.info->lobes);
  std::vector<double> lobes(model.lobes());
  bool any_lobe = false;  // divided by f0, in any channel
  for (std::size_t c = 0; c < model.channels().size() && divided >= 0; ++c)
    any_lobe = any_lobe || model.table_weights(p, t, c)[std::size_t(divided)].value > 0;
  for (std::size_t c = 0; c < model.channels().size(); ++c) {
    model.lobe_weights(p, c, lobes);
    double total = 0;
    for (double w : lobes) total += w;
    const std::vector<TableWeight> table = model.table_weights(p, t, c);
    for (std::size_t k = 0; k < table.size(); ++k) {
      if (table[k].shared && c > 0) continue;
      const ParameterInfo& info = term.info->weights[k];
      Reported r;
      r.estimate.name = model.prefixed(t, info.name);
      if (!table[k].shared) r.estimate.channel = model.channels()[c];
      r.estimate.value = table[k].value;
      r.info = &info;
      r.gradient = table[k].gradient;
      r.min = table[k].min;
      r.max = table[k].max;
      r.weight = true;
      r.weight_scale = total;
      if (info.role == Role::f0) {
        r.divided = &term.info->weights[std::size_t(divided)];
        r.without_lobe = table[k].shared ? !any_lobe : !(table[std::size_t(divided)].value > 0);
      }
      out.push_back(std::move(r));
    }
  }
}

}  // namespace

std::vector<Reported> reported_parameters(const Model& model, std::span<const double> p) {
  std::vector<Reported> out;
  for (std::size_t t = 0; t < model.terms().size(); ++t) add_shape(model, p, t, out);
  if (const std::size_t s = model.tangent_slot(); s != kNoSlot) {
    Reported r;
    r.estimate.name = kTangentInfo.name;
    r.estimate.value = radians(p[s]).degrees();
    r.info = &kTangentInfo;
    r.slot = s;
    r.gradient = {{s, radians(1).degrees()}};
    r.min = kTangentInfo.min;
    r.max = kTangentInfo.max;
    out.push_back(std::move(r));
  }
  for (std::size_t a = 0; a < kNormalInfo.size() && model.fits_normal(); ++a) {
    Reported r;
    r.estimate.name = kNormalInfo[a].name;
    r.info = &kNormalInfo[a];
    r.slot = model.normal_slot() + a;
    r.estimate.value = p[r.slot];
    r.gradient = {{r.slot, 1}};
    r.min = kNormalInfo[a].min;
    r.max = kNormalInfo[a].max;
    out.push_back(std::move(r));
  }
  for (std::size_t t = 0; t < model.terms().size(); ++t) add_weights(model, p, t, out);
  return out;
}

Reported product_of(const std::vector<Reported>& all, std::size_t a, std::size_t b) {
  Reported out = all[a];
  const Reported& other = all[b];
  out.estimate = {};
  out.estimate.name = all[a].estimate.name + " " + other.estimate.name;
  out.estimate.channel = all[a].estimate.channel;
  out.estimate.value = all[a].estimate.value * other.estimate.value;
  for (auto& [slot, slope] : out.gradient) slope *= other.estimate.value;
  for (const auto& [slot, slope] : other.gradient) {
    const auto has = [&, at = slot](const auto& g) { return g.first == at; };
    const auto found = std::ranges::find_if(out.gradient, has);
    if (found == out.gradient.end())
      out.gradient.emplace_back(slot, slope * all[a].estimate.value);
    else
      found->second += slope * all[a].estimate.value;
  }
  out.min = all[a].min * other.min;
  out.max = all[a].max * other.max;
  out.divided = nullptr;
  out.times = b;
  return out;
}

Extent extent_of(const Reported& r, const Model& model, std::span<const double> p, double half_width) {
  if (r.scale != kNoSlot) {
    const Slot& slot = model.slots()[r.scale];
    const double u = r.slot != kNoSlot ? p[r.slot] : slot.to_solver(r.estimate.value);
    return {slot.to_natural(u - half_width), slot.to_natural(u + half_width)};
  }
  return {std::max(r.estimate.value - half_width, r.min), std::min(r.estimate.value + half_width, r.max)};
}

bool says_nothing(const Reported& r, const Model& model, double error) {
  if (r.divided) return error > kFresnelError;
  if (r.weight) return error > kWeightError * std::max(std::abs(r.estimate.value), r.weight_scale);
  if (r.info == &kTangentInfo) return error > kTangentError;
  if (r.scale == kNoSlot) return error > kRangeError * (r.max - r.min);
  const Slot& slot = model.slots()[r.scale];
  if (slot.scale == Scale::log || slot.scale == Scale::log1p) return error > kLogError;
  const double u = slot.to_solver(r.estimate.value);
  return slot.to_natural(u + error) - slot.to_natural(u - error) > 2 * kRangeError * (r.max - r.min);
}

namespace {

constexpr double kOpenEnd = std::numeric_limits<double>::infinity();

Extent opened(Extent extent, const Estimate& e) {
  return {e.low_open ? -kOpenEnd : extent.low, e.high_open ? kOpenEnd : extent.high};
}

}  // namespace

Extent interval_of(const Estimate& e) {
  return opened({e.low, e.high}, e);
}

Extent interval_with_lack_of_fit(const Estimate& e) {
  return std::isnan(e.with_lack_of_fit.low) ? e.with_lack_of_fit : opened(e.with_lack_of_fit, e);
}

std::string extent_text(Extent e, int digits) {
  if (std::isnan(e.low) || std::isnan(e.high)) return "-";
  if (std::isinf(e.low) && std::isinf(e.high)) return "any value";
  if (std::isinf(e.low)) return "at most " + io::short_number(e.high, digits);
  if (std::isinf(e.high)) return "at least " + io::short_number(e.low, digits);
  return io::short_number(e.low, digits) + " to " + io::short_number(e.high, digits);
}

std::string label(const std::string& name, const std::string& channel) {
  return channel.empty() ? name : name + "[" + channel + "]";
}

std::string label(const Estimate& e) {
  return label(e.name, e.channel);
}

std::string shape_text(const Material& m) {
  std::vector<std::string> values;
  for (const Term& term : m.terms) {
    const ReflectanceInfo& f = info(term.form);
    for (std::size_t k = 0; k < f.shape.size(); ++k)
      values.push_back(std::string(f.shape[k].name) + " " + io::short_number(term.shape[0][k]));
  }
  return values.empty() ? "-" : io::joined(values);
}

std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return io::joined(names);
  return io::joined({names.begin(), names.end() - 1}) + " and " + names.back();
}

std::vector<std::string> names_with(const std::vector<Reported>& all, Status status, std::size_t channels) {
  std::vector<std::pair<std::string, std::vector<std::string>>> grouped;
  for (const Reported& r : all) {
    if (r.estimate.status != status) continue;
    auto it = std::ranges::find_if(grouped, [&](const auto& g) { return g.first == r.estimate.name; });
    if (it == grouped.end()) it = grouped.insert(grouped.end(), {r.estimate.name, {}});
    if (!r.estimate.channel.empty()) it->second.push_back(r.estimate.channel);
  }
  std::vector<std::string> out;
  for (const auto& [name, list] : grouped) {
    std::string text = name;
    if (!list.empty() && list.size() < channels) text += " (" + io::joined(list) + ")";
    out.push_back(std::move(text));
  }
  return out;
}

namespace {

// Returns an f0 that is not identifiable, or that divides a weight which is not identifiable.
const Reported* unidentified_split(const std::vector<Reported>& all) {
  for (const Reported& f0 : all) {
    if (!f0.divided || f0.estimate.status == Status::fixed) continue;
    const auto is_part = [&](const Reported& r) {
      return r.estimate.status == Status::unidentified && (r.info == f0.info || r.info == f0.divided);
    };
    if (std::ranges::any_of(all, is_part)) return &f0;
  }
  return nullptr;
}

}  // namespace

std::string advice(const std::vector<Reported>& all, const Model& model) {
  // Returns any unidentifiable parameter with one of these roles.
  const auto unidentified = [&](std::initializer_list<Role> roles) -> const Reported* {
    for (const Reported& r : all)
      if (r.estimate.status == Status::unidentified && std::ranges::find(roles, r.info->role) != roles.end())
        return &r;
    return nullptr;
  };
  bool any_specular = false, all_zero = true;
  for (const Reported& r : all)
    if (r.info->role == Role::specular) {
      any_specular = true;
      all_zero = all_zero && r.estimate.status == Status::at_bound && !(r.estimate.value > 0);
    }
  const Reported* width =
      unidentified({Role::width, Role::width_across, Role::exponent, Role::exponent_across});
  if (width && any_specular && all_zero)
    return "the measurements show no specular lobe: fit without the lobe, or fix its width";
  for (const Reported& r : all)
    if (r.info == &kTangentInfo && r.estimate.status == Status::unidentified)
      return "measure more azimuths with the sample rotated, or fit without --anisotropic";
  if (const Reported* slope = unidentified({Role::slope}))
    return "measure more azimuths on the side of incidence (phi_o - phi_i below 90 degrees), or fix " +
           std::string(slope->info->name);
  if (const Reported* f0 = unidentified_split(all); f0 && !width) {
    const std::string name(f0->info->name);
    const bool tie = model.channels().size() > 1 && !f0->estimate.channel.empty();
    return "only " + std::string(f0->divided->name) + " " + name +
           " can be determined from these small difference angles: measure at grazing angles (theta_d above "
           "40 degrees), " +
           (tie ? "give all channels one " + name + " (--tie " + name + "), " : "") +
           (model.linear() ? "bound the weights (--physical), " : "") + "or fix " + name;
  }
  if (width) return "measure closer to the mirror direction, or fix the width";
  if (model.terms().size() > 1) return "fit fewer terms, or fix some parameters";
  return "measure more directions, or fix one of these parameters";
}

}  // namespace brdf::fit
