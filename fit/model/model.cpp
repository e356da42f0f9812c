#include "fit/model/model.h"
#include "fit/algebra/box_quadratic.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"

namespace brdf::fit {

Model::Model(std::vector<Reflectance> forms, std::vector<std::string> channels, const FitOptions& options)
    : name_(name_of_sum(forms)), channels_(std::move(channels)) {
  groups_ = options.shapes_differ() ? channels_.size() : 1;
  if (options.smooth > 0) smooth_ = smooth_basis(channels_, options.smooth);
  for (const Reflectance& form : forms) add_term(form);
  constraints_ = resolve(forms, channels_, options);
  normal_start_ = options.normal;
  add_shape_slots(options.anisotropic);
  limits_albedo_ = options.physical != Physical::off && is_signed();
  const Physical physical = limits_albedo_ ? Physical::off : options.physical;
  if (NaturalWeights::asked_for(constraints_, physical))
    add_natural_slots(forms, physical);
  else
    add_linear_slots();
}

double Cut::shortfall(std::span<const double> weights) const {
  double sum = 0;
  for (std::size_t k = 0; k < lobes.size(); ++k) sum += lobes[k] * weights[k];
  return std::max(least - sum, 0.0);
}

bool Cut::is_reached(std::span<const double> weights) const {
  constexpr double kNear = 1e-4;  // of the limit
  Cut nearly = *this;
  nearly.least += kNear * std::abs(least);
  return nearly.shortfall(weights) > 0;
}

bool Model::is_signed() const {
  return std::ranges::any_of(terms_, [](const TermModel& term) { return term.info->basis != nullptr; });
}

double WeightMap::lobe(std::span<const double> p, std::size_t k) const {
  double w = b[k];
  for (std::size_t u = 0; u < unknowns; ++u) w += a[k * unknowns + u] * p[first_slot + u];
  return w;
}

Gradient WeightMap::gradient(std::size_t k) const {
  Gradient out;
  for (std::size_t u = 0; u < unknowns; ++u)
    if (const double slope = a[k * unknowns + u]; slope != 0) out.push_back({first_slot + u, slope});
  return out;
}

Gradient WeightMap::gradient(std::span<const double> by_lobe) const {
  Gradient out;
  for (std::size_t u = 0; u < unknowns; ++u) {
    double slope = 0, size = 0;
    for (std::size_t l = 0; l < lobes; ++l) {
      slope += by_lobe[l] * a[l * unknowns + u];
      size += std::abs(by_lobe[l] * a[l * unknowns + u]);
    }
    if (std::abs(slope) > 1e-12 * size) out.push_back({first_slot + u, slope});
  }
  return out;
}

void Model::add_term(const Reflectance& form) {
  TermModel term{form, &info(form)};
  const std::string name(term.info->name);
  if (!term.info->fittable())
    throw InputError("form '" + name + "' cannot be fitted, because the form is not linear in its weights");
  if (!weights_follow_from_lobes(term.info->lobes, term.info->weights))
    throw InputError("form '" + name +
                     "' cannot be fitted: its weights do not follow from the weights of its lobes");
  term.lobes = term.info->lobes.size();
  term.first_lobe = lobes_;
  lobes_ += term.lobes;
  terms_.push_back(std::move(term));
}

std::vector<double> Model::shape(std::span<const double> p, std::size_t term, std::size_t group) const {
  std::vector<double> shape = terms_[term].fixed_shape[group];
  for (std::size_t s = 0; s < shape_slots_; ++s) {
    const Slot& slot = slots_[s];
    if (slot.kind == Slot::Kind::shape && slot.term == term && slot.node == 0 && slot.in_group(group))
      for (std::size_t m : slot.members) shape[m] = slot.to_natural(scaled_value(p, s, group));
  }
  return shape;
}

double Model::scaled_value(std::span<const double> p, std::size_t s, std::size_t group) const {
  if (slots_[s].nodes == 1) return p[s];
  double u = 0;
  for (std::size_t k = 0; k < slots_[s].nodes; ++k) u += slots_[s + k].share[group] * p[s + k];
  return u;
}

Gradient Model::shape_slopes(std::span<const double> p, std::size_t s, std::size_t group) const {
  const Slot& slot = slots_[s];
  if (slot.nodes == 1) return {{s, slot.slope(p[s])}};
  const double u = scaled_value(p, s, group);
  // Between nodes a polynomial may leave the range; the value is then clamped to the end.
  const double slope = u >= slot.low && u <= slot.high ? slot.slope(u) : 0;
  Gradient out;
  for (std::size_t k = 0; k < slot.nodes; ++k) out.push_back({s + k, slope * slots_[s + k].share[group]});
  return out;
}

Gradient Model::slopes_of_partial(std::span<const double> p, std::size_t partial, std::size_t group) const {
  const std::size_t slot = slot_of_partial(partial, group);
  return slot == kNoSlot ? Gradient() : shape_slopes(p, slot, group);
}

Angle Model::tangent_phi(std::span<const double> p) const {
  return tangent_slot_ == kNoSlot ? fixed_tangent_ : radians(p[tangent_slot_]);
}

Vec3<double> Model::normal(std::span<const double> p) const {
  if (!fits_normal()) return {0, 0, 1};
  const double x = p[normal_slot_], y = p[normal_slot_ + 1];
  constexpr double kFlattest = 1e-3;  // a solver's step may leave the hemisphere: clamp to its rim
  const double z = std::sqrt(std::max(1 - x * x - y * y, kFlattest * kFlattest));
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

void Model::lobe_weights(std::span<const double> p, std::size_t channel, std::span<double> out) const {
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const TermModel& term = terms_[t];
    for (std::size_t k = 0; k < term.lobes; ++k)
      out[term.first_lobe + k] =
          natural_ ? natural_->lobe(t, channel, k).value(p) : term.weights[channel].lobe(p, k);
  }
}

std::vector<WeightSlope> Model::weight_slopes(std::span<const double> p, std::size_t channel) const {
  std::vector<WeightSlope> out;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const TermModel& term = terms_[t];
    for (std::size_t k = 0; k < term.lobes; ++k)
      for (const auto& [slot, slope] :
           natural_ ? natural_->lobe(t, channel, k).gradient(p) : term.weights[channel].gradient(k))
        out.push_back({term.first_lobe + k, slot, slope});
  }
  return out;
}

std::vector<TableWeight> Model::table_weights(std::span<const double> p, std::size_t t,
                                              std::size_t channel) const {
  const TermModel& term = terms_[t];
  std::vector<TableWeight> out;
  for (const Constraint& c : constraints_.terms[t].weights) out.push_back({0, c.low, c.high, {}});
  if (natural_) {
    for (std::size_t k = 0; k < out.size(); ++k) {
      const Product& weight = natural_->weight(t, channel, k);
      out[k].value = weight.value(p);
      out[k].gradient = weight.gradient(p);
      out[k].shared = natural_->shared(t, k);
      if (weight.factors.size() != 1 || weight.factors[0].rest) continue;
      const Slot& slot = slots_[weight.factors[0].slot];
      out[k].min = weight.scale * slot.min;
      out[k].max = weight.scale * slot.max;
    }
    return out;
  }
  std::vector<double> lobes(lobes_);
  lobe_weights(p, channel, lobes);
  const auto weights = term.form->weights_of(std::span(lobes).subspan(term.first_lobe, term.lobes));
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k].value = weights[k].value;
    out[k].gradient = term.weights[channel].gradient(weights[k].by_lobe);
  }
  return out;
}

WeightTable Model::weight_table(std::span<const double> p) const {
  WeightTable out(terms_.size(), std::vector<std::vector<double>>(channels_.size()));
  for (std::size_t t = 0; t < terms_.size(); ++t)
    for (std::size_t c = 0; c < channels_.size(); ++c)
      for (const TableWeight& weight : table_weights(p, t, c)) out[t][c].push_back(weight.value);
  return out;
}

std::vector<double> Model::low() const {
  std::vector<double> v;
  for (const Slot& s : slots_) v.push_back(s.low);
  return v;
}
std::vector<double> Model::high() const {
  std::vector<double> v;
  for (const Slot& s : slots_) v.push_back(s.high);
  return v;
}

std::vector<double> Model::initial() const {
  std::vector<double> p;
  for (const Slot& s : slots_) {
    double natural = 0;
    if (s.kind == Slot::Kind::shape) natural = terms_[s.term].info->shape[s.members[0]].initial;
    if (s.role == Role::f0) natural = terms_[s.term].info->weights[s.members[0]].initial;
    p.push_back(s.to_solver(std::clamp(natural, s.min, s.max)));
  }
  if (fits_normal()) std::copy(normal_start_->begin(), normal_start_->end(), &p[normal_slot_]);
  return p;
}

void Model::apply_start(std::vector<double>& p) const {
  for (std::size_t s = 0; s < shape_slots_; ++s) {
    const Slot& slot = slots_[s];
    if (slot.kind == Slot::Kind::normal) continue;
    if (slot.kind == Slot::Kind::tangent) {
      if (const auto& start = constraints_.tangent.start; !start.empty()) p[s] = degrees(start[0]).radians();
      continue;
    }
    const Constraint& c = constraints_.terms[slot.term].shape[slot.members[0]];
    // Given a value for every channel, a node takes the value of the channel in which the node has its
    // largest share.
    const std::size_t channel =
        slot.nodes == 1 ? slot.group : std::size_t(std::ranges::max_element(slot.share) - slot.share.begin());
    if (!c.start.empty()) p[s] = slot.to_solver(c.start_in(channel));
  }
}

namespace {

// Returns the unknowns that bring the weights of the lobes closest to the target.
std::vector<double> closest_unknowns(const WeightMap& map, std::span<const double> target) {
  Matrix h(map.unknowns, map.unknowns);
  std::vector<double> g(map.unknowns, 0);
  for (std::size_t k = 0; k < map.lobes; ++k)
    for (std::size_t u = 0; u < map.unknowns; ++u) {
      g[u] -= map.a[k * map.unknowns + u] * (target[k] - map.b[k]);
      for (std::size_t v = 0; v < map.unknowns; ++v)
        h(u, v) += map.a[k * map.unknowns + u] * map.a[k * map.unknowns + v];
    }
  return box_quadratic(h, g, map.low, map.high);
}

}  // namespace

void Model::set_weights(std::vector<double>& p, const WeightTable& values) const {
  if (natural_) {
    natural_->set(p, values);
    return;
  }
  for (std::size_t t = 0; t < terms_.size(); ++t)
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      const WeightMap& map = terms_[t].weights[c];
      const std::vector<double> x = closest_unknowns(map, linear_weights(*terms_[t].info, values[t][c]));
      std::copy(x.begin(), x.end(), p.begin() + std::ptrdiff_t(map.first_slot));
    }
}

void Model::apply_start_weights(std::vector<double>& p) const {
  WeightTable values = weight_table(p);
  bool named = false;
  for (std::size_t t = 0; t < terms_.size(); ++t)
    for (std::size_t c = 0; c < channels_.size(); ++c)
      for (std::size_t k = 0; k < values[t][c].size(); ++k) {
        const Constraint& constraint = constraints_.terms[t].weights[k];
        if (constraint.start.empty()) continue;
        values[t][c][k] = constraint.start_in(c);
        named = true;
      }
  if (named) set_weights(p, values);
}

Material Model::material(std::span<const double> p) const {
  Material m;
  m.channels = channels_;
  const WeightTable weights = weight_table(p);
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    Term term{terms_[t].form, {}, weights[t]};
    for (std::size_t g = 0; g < groups_; ++g) term.shape.push_back(shape(p, t, g));
    if (terms_[t].info->anisotropic()) term.tangent_phi = tangent_phi(p);
    m.terms.push_back(std::move(term));
  }
  return m;
}

}  // namespace brdf::fit
