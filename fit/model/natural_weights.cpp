#include "fit/model/natural_weights.h"

#include <algorithm>
#include <optional>

#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

constexpr double kRounding = 1e-12;  // of a sum of weights
constexpr double kAtBound = 1e-9;    // of a sum that the solver has brought to its bound

// The place of the only specular weight, if f0 divides it.
struct Interface {
  std::size_t term, weight, f0;
};
std::optional<Interface> interface_of(std::span<const Reflectance> forms) {
  std::optional<Interface> found;
  std::size_t speculars = 0;
  for (std::size_t t = 0; t < forms.size(); ++t) {
    const ReflectanceInfo& info = forms[t].info();
    for (const ParameterInfo& p : info.weights) speculars += p.role == Role::specular;
    const int weight = weight_of_f0(info.lobes);
    if (weight >= 0 && info.weights[std::size_t(weight)].role == Role::specular)
      found = Interface{t, std::size_t(weight), std::size_t(info.weight_index(Role::f0))};
  }
  return speculars == 1 ? found : std::nullopt;
}

// Returns 1 - f0 for an f0 that is held or is itself an unknown.
Product without(const Product& f0) {
  if (f0.factors.empty()) return {1 - f0.scale, {}};
  return {1, {{f0.factors[0].slot, true}}};
}

Product times(Product a, const Product& b) {
  a.scale *= b.scale;
  a.factors.insert(a.factors.end(), b.factors.begin(), b.factors.end());
  return a;
}

bool held_at_one(const Constraint& c) {
  return c.is_fixed() && std::ranges::all_of(c.fixed, [](double value) { return value == 1; });
}

}  // namespace

double Product::value(std::span<const double> p) const {
  double v = scale;
  for (const Factor& f : factors) v *= f.value(p);
  return v;
}

Gradient Product::gradient(std::span<const double> p) const {
  Gradient out;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    double slope = factors[k].rest ? -scale : scale;
    for (std::size_t other = 0; other < factors.size(); ++other)
      if (other != k) slope *= factors[other].value(p);
    if (slope != 0) out.push_back({factors[k].slot, slope});
  }
  return out;
}

Product Product::times(Factor factor) const {
  Product out = *this;
  out.factors.push_back(factor);
  return out;
}

bool NaturalWeights::asked_for(const Constraints& constraints, Physical physical) {
  if (physical != Physical::off) return true;
  for (const TermConstraints& term : constraints.terms)
    for (const Constraint& c : term.weights)
      if (c.tied) return true;
  return false;
}

NaturalWeights::NaturalWeights(std::span<const Reflectance> forms, const Constraints& constraints,
                               const std::vector<std::string>& channels, Physical physical, std::size_t first)
    : forms_(forms.begin(), forms.end()),
      constraints_(constraints),
      channels_(channels),
      physical_(physical),
      first_(first) {
  if (physical == Physical::dielectric) {
    const Interface at = *interface_of(forms);
    constraints_.terms[at.term].weights[at.weight].fixed = {1};
  }
  std::vector<Place> free;
  for (std::size_t t = 0; t < forms_.size(); ++t) {
    const std::size_t count = forms_[t].info().weights.size();
    weights_.emplace_back(channels_.size(), std::vector<Product>(count));
    for (std::size_t k = 0; k < count; ++k) {
      const Place place{t, k};
      if (constraint(place).is_fixed())
        for (std::size_t c = 0; c < channels_.size(); ++c)
          weights_[t][c][k].scale = constraint(place).fixed_in(c);
      else if (!is_f0(place))
        free.push_back(place);
    }
  }
  add_f0s();
  if (physical != Physical::off)
    add_bounded(std::move(free));
  else
    for (const Place& place : free) add_alone(place, {});
  make_lobes();
}

// Returns the groups of channels that share a slot: one for all channels, or one per channel.
std::vector<std::size_t> NaturalWeights::groups(const Place& place) const {
  if (constraint(place).tied) return {kEveryGroup};
  std::vector<std::size_t> all(channels_.size());
  for (std::size_t c = 0; c < all.size(); ++c) all[c] = c;
  return all;
}

std::size_t NaturalWeights::add_slot(const Place& place, std::size_t group, double low, double high) {
  Slot slot{Slot::Kind::weight, place.term, {place.weight}, group, info_of(place).role};
  slot.min = slot.low = low;
  slot.max = slot.high = high;
  slot.name = name_in_sum(forms_.size(), place.term, info_of(place).name);
  if (group != kEveryGroup) slot.name += "[" + channels_[group] + "]";
  slots_.push_back(std::move(slot));
  place_.push_back(place);
  return first_ + slots_.size() - 1;
}

// Adds a weight that is itself an unknown. `most`, [channel], limits it in addition to its own bounds.
void NaturalWeights::add_alone(const Place& place, std::span<const double> most) {
  const Constraint& c = constraint(place);
  for (const std::size_t group : groups(place)) {
    double high = c.high;
    for (std::size_t channel = 0; channel < most.size(); ++channel)
      if (group == kEveryGroup || group == channel) high = std::min(high, most[channel]);
    const std::size_t slot = add_slot(place, group, c.low, high);
    for (std::size_t channel = 0; channel < channels_.size(); ++channel)
      if (slots_.back().in_group(channel))
        weights_[place.term][channel][place.weight].factors = {{slot, false}};
  }
}

// Adds the unknowns for f0. If all other weights are held, f0 of a dielectric is at most what they leave of
// 1.
void NaturalWeights::add_f0s() {
  std::vector<double> most;
  if (physical_ == Physical::dielectric)
    for (std::size_t c = 0; c < channels_.size(); ++c)
      most.push_back(2 - held(c));  // the held sum includes the specular weight, 1
  for (std::size_t t = 0; t < forms_.size(); ++t)
    if (const int f0 = forms_[t].info().weight_index(Role::f0); f0 >= 0)
      if (const Place place{t, std::size_t(f0)}; !constraint(place).is_fixed()) {
        for (const double limit : most)
          if (limit <= constraint(place).low)
            throw InputError("--physical: the weights that --fix holds leave no room for " +
                             std::string(info_of(place).name));
        add_alone(place, most);
      }
}

// Returns the sum of a channel's weights that are held.
double NaturalWeights::held(std::size_t channel) const {
  double sum = 0;
  for (std::size_t t = 0; t < forms_.size(); ++t)
    for (std::size_t k = 0; k < weights_[t][channel].size(); ++k)
      if (!is_f0({t, k}) && constraint({t, k}).is_fixed()) sum += weights_[t][channel][k].scale;
  return sum;
}

// Returns the remainder to 1 of the held weights, [channel]. If some weight is shared, all channels have
// the smallest remainder.
std::vector<double> NaturalWeights::room(const std::vector<Place>& free) const {
  std::vector<double> room(channels_.size(), 1);
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    room[c] -= held(c);
    if (room[c] < -kRounding)
      throw InputError("--physical: the weights that --fix holds add up to " + io::to_text(held(c)) +
                       ", which is more than 1");
  }
  const double least = *std::ranges::min_element(room);
  if (std::ranges::any_of(free, [&](const Place& place) { return constraint(place).tied; }))
    room.assign(room.size(), least);
  for (const Place& place : free)
    if (least <= std::max(constraint(place).low, kRounding))
      throw InputError("--physical: --fix and --bounds leave no room for " +
                       std::string(info_of(place).name));
  return room;
}

// Bounds the sum of a channel's weights by 1. For a dielectric, the remainder of 1 - f0 belongs to the
// other weights.
void NaturalWeights::add_bounded(std::vector<Place> free) {
  std::vector<Product> rest(channels_.size());  // the remainder of every channel's stick
  if (physical_ == Physical::dielectric) {
    const Interface at = *interface_of(forms_);
    for (std::size_t c = 0; c < channels_.size(); ++c) rest[c] = without(weights_[at.term][c][at.f0]);
    summed_ = free;
    summed_.push_back({at.term, at.f0});
  } else {
    const std::vector<double> most = room(free);
    if (free.size() == 1) {
      add_alone(free[0], most);
      return;
    }
    for (std::size_t c = 0; c < channels_.size(); ++c) rest[c].scale = most[c];
    for (std::size_t t = 0; t < forms_.size(); ++t)
      for (std::size_t k = 0; k < forms_[t].info().weights.size(); ++k)
        if (!is_f0({t, k}) && (!constraint({t, k}).is_fixed() || constraint({t, k}).fixed_in(0) != 0))
          summed_.push_back({t, k});
  }
  // Weights that all channels share are broken off first. Shares of a remainder that differs between
  // channels would give different weights.
  std::stable_partition(free.begin(), free.end(), [&](const Place& place) { return constraint(place).tied; });
  for (const Place& place : free) {
    const ParameterInfo& table = info_of(place);
    if (constraint(place).low != table.min || constraint(place).high != table.max)
      throw InputError("--bounds " + std::string(table.name) +
                       ": cannot be used with --physical, which bounds the sum of this and other weights: "
                       "hold the others with --fix, or remove one of the two options");
    for (const std::size_t group : groups(place)) {
      const std::size_t slot = add_slot(place, group, 0, 1);
      for (std::size_t c = 0; c < channels_.size(); ++c) {
        if (!slots_.back().in_group(c)) continue;
        weights_[place.term][c][place.weight] = rest[c].times({slot, false});
        rest[c] = rest[c].times({slot, true});
      }
    }
  }
}

Product NaturalWeights::product_of_lobe(std::size_t term, std::size_t channel, std::size_t lobe) const {
  const ReflectanceInfo& info = forms_[term].info();
  const LobeWeight& of = info.lobes[lobe];
  const Product& weight = weights_[term][channel][of.weight];
  if (of.factor == LobeWeight::Factor::one) return weight;
  const Product& f0 = weights_[term][channel][std::size_t(info.weight_index(Role::f0))];
  return times(weight, of.factor == LobeWeight::Factor::f0 ? f0 : without(f0));
}

void NaturalWeights::make_lobes() {
  for (std::size_t t = 0; t < forms_.size(); ++t) {
    lobes_.emplace_back(channels_.size());
    for (std::size_t c = 0; c < channels_.size(); ++c)
      for (std::size_t k = 0; k < forms_[t].info().lobes.size(); ++k)
        lobes_[t][c].push_back(product_of_lobe(t, c, k));
  }
}

NaturalWeights::Sum NaturalWeights::bounded_sum(std::span<const double> p) const {
  Sum sum;
  for (const Place& place : summed_)
    sum.name += (sum.name.empty() ? "" : " + ") + name_in_sum(forms_.size(), place.term, info_of(place).name);
  for (std::size_t c = 0; c < channels_.size() && !summed_.empty(); ++c) {
    double all = 0;
    for (const Place& place : summed_) all += weights_[place.term][c][place.weight].value(p);
    if (all >= 1 - kAtBound) sum.at_bound.push_back(c);
  }
  return sum;
}

bool NaturalWeights::shared(std::size_t term, std::size_t k) const {
  return constraint({term, k}).tied;
}

void NaturalWeights::set(std::vector<double>& p, const WeightTable& values) const {
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    const auto [term, k] = place_[s];
    double sum = 0, count = 0;
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      if (!slots_[s].in_group(c)) continue;
      // The slot itself is the last factor; the preceding factors are already set.
      Product before = weights_[term][c][k];
      before.factors.pop_back();
      const double whole = before.value(p);
      if (!(whole > 0)) continue;
      sum += values[term][c][k] / whole;
      ++count;
    }
    p[first_ + s] = count > 0 ? std::clamp(sum / count, slots_[s].low, slots_[s].high) : slots_[s].low;
  }
}

bool can_be_dielectric(std::span<const Reflectance> forms, const Constraints& constraints) {
  const auto at = interface_of(forms);
  if (!at) return false;
  const std::vector<Constraint>& weights = constraints.terms[at->term].weights;
  const Constraint &specular = weights[at->weight], &f0 = weights[at->f0];
  if (specular.is_fixed() ? !held_at_one(specular) : specular.low > 1 || specular.high < 1) return false;
  // A held weight in addition to a free weight would have to be subtracted from the shares of both.
  bool free = false, held = false;
  for (std::size_t t = 0; t < forms.size(); ++t)
    for (std::size_t k = 0; k < constraints.terms[t].weights.size(); ++k) {
      const Constraint& c = constraints.terms[t].weights[k];
      if (&c == &specular || &c == &f0) continue;
      free = free || !c.is_fixed();
      held = held || std::ranges::any_of(c.fixed, [](double value) { return value != 0; });
    }
  if (held && (free || f0.is_fixed())) return false;
  // A weight that all channels share cannot follow from an f0 that differs between channels.
  for (const TermConstraints& term : constraints.terms)
    for (const Constraint& c : term.weights)
      if (c.tied && &c != &specular && &c != &f0 && !f0.tied && f0.fixed.size() != 1) return false;
  return true;
}

bool must_be_dielectric(std::span<const Reflectance> forms, const Constraints& constraints) {
  const auto at = interface_of(forms);
  return at && held_at_one(constraints.terms[at->term].weights[at->weight]);
}

}  // namespace brdf::fit
