#include "fit/model/model.h"
#include "fit/algebra/box_quadratic.h"

#include <algorithm>
#include <cmath>

#include "io/error.h"

namespace brdf::fit {

Model::Model(std::vector<Reflectance> forms, std::vector<std::string> channels, const FitOptions& options)
    : channels_(std::move(channels)) {
  groups_ = options.per_channel ? channels_.size() : 1;
  for (const Reflectance& form : forms) add_term(form);
  constraints_ = resolve(forms, channels_.size(), options);
  add_shape_slots(options.anisotropic);
  add_linear_slots();
}

void Model::add_term(const Reflectance& form) {
  TermModel term{form, &info(form)};
  const std::string name(term.info->name);
  if (!term.info->fittable())
    throw InputError("form '" + name + "' cannot be fitted: it is not linear in its weights");
  if (!weights_follow_from_lobes(term.info->lobes, term.info->weights))
    throw InputError("form '" + name +
                     "' cannot be fitted: its weights do not follow from those of its lobes");
  term.lobes = term.info->lobes.size();
  term.first_lobe = lobes_;
  lobes_ += term.lobes;
  name_ += (name_.empty() ? "" : "+") + name;
  terms_.push_back(std::move(term));
}

std::vector<double> Model::shape(std::span<const double> p, std::size_t term, std::size_t group) const {
  std::vector<double> shape = terms_[term].fixed_shape[group];
  for (std::size_t s = 0; s < shape_slots_; ++s) {
    const Slot& slot = slots_[s];
    if (slot.kind == Slot::Kind::shape && slot.term == term && slot.group == group)
      for (std::size_t m : slot.members) shape[m] = slot.to_natural(p[s]);
  }
  return shape;
}

Angle Model::tangent_phi(std::span<const double> p) const {
  return tangent_slot_ == kNoSlot ? fixed_tangent_ : radians(p[tangent_slot_]);
}

void Model::lobe_weights(std::span<const double> p, std::size_t channel, std::span<double> out) const {
  for (const TermModel& term : terms_) {
    const WeightMap& map = term.weights[channel];
    for (std::size_t k = 0; k < map.lobes; ++k) {
      double w = map.b[k];
      for (std::size_t u = 0; u < map.unknowns; ++u) w += map.a[k * map.unknowns + u] * p[map.first_slot + u];
      out[term.first_lobe + k] = w;
    }
  }
}

// The weights in the order of a term's table, from the weights of all lobes.
std::vector<double> Model::table_weights(std::span<const double> lobes, std::size_t term) const {
  const TermModel& t = terms_[term];
  std::vector<double> values;
  for (const auto& weight : t.form->weights_of(lobes.subspan(t.first_lobe, t.lobes)))
    values.push_back(weight.value);
  return values;
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
    const double natural =
        s.kind == Slot::Kind::shape ? terms_[s.term].info->shape[s.members[0]].initial : 0.0;
    p.push_back(s.to_solver(std::clamp(natural, s.min, s.max)));
  }
  return p;
}

void Model::apply_start(std::vector<double>& p) const {
  for (std::size_t s = 0; s < shape_slots_; ++s) {
    const Slot& slot = slots_[s];
    if (slot.kind == Slot::Kind::tangent) {
      if (const auto& start = constraints_.tangent.start; !start.empty()) p[s] = degrees(start[0]).radians();
      continue;
    }
    const Constraint& c = constraints_.terms[slot.term].shape[slot.members[0]];
    if (!c.start.empty()) p[s] = slot.to_solver(c.start_in(slot.group));
  }
}

namespace {

// The unknowns whose lobes' weights come closest to these.
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

void Model::apply_start_weights(std::vector<double>& p) const {
  std::vector<double> lobes(lobes_);
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    lobe_weights(p, c, lobes);
    for (std::size_t t = 0; t < terms_.size(); ++t) {
      std::vector<double> values = table_weights(lobes, t);
      bool named = false;
      for (std::size_t k = 0; k < values.size(); ++k) {
        const Constraint& constraint = constraints_.terms[t].weights[k];
        if (constraint.start.empty()) continue;
        values[k] = constraint.start_in(c);
        named = true;
      }
      if (!named) continue;
      const WeightMap& map = terms_[t].weights[c];
      const std::vector<double> x = closest_unknowns(map, linear_weights(*terms_[t].info, values));
      std::copy(x.begin(), x.end(), p.begin() + std::ptrdiff_t(map.first_slot));
    }
  }
}

Material Model::material(std::span<const double> p) const {
  Material m;
  m.channels = channels_;
  std::vector<double> weights(lobes_);
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    Term term{terms_[t].form, {}, {}};
    for (std::size_t g = 0; g < groups_; ++g) term.shape.push_back(shape(p, t, g));
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      lobe_weights(p, c, weights);
      term.weights.push_back(table_weights(weights, t));
    }
    if (terms_[t].info->anisotropic()) term.tangent_phi = tangent_phi(p);
    m.terms.push_back(std::move(term));
  }
  return m;
}

}  // namespace brdf::fit
