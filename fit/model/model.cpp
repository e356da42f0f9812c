#include "fit/model/model.h"

#include <algorithm>
#include <cmath>

#include "fit/solve/solve.h"
#include "io/error.h"
#include "io/text.h"

namespace brdf::fit {

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
    const LinearBlock& block = term.weights[channel];
    for (std::size_t k = 0; k < block.lobes; ++k) {
      double w = block.b[k];
      for (std::size_t u = 0; u < block.unknowns; ++u)
        w += block.a[k * block.unknowns + u] * p[block.first_slot + u];
      out[term.first_lobe + k] = w;
    }
  }
}

namespace {

// The weights in the order of the form's table, from the weights of its lobes.
std::vector<double> table_weights(const Reflectance& form, std::span<const double> lobes) {
  std::vector<double> values;
  for (const auto& weight : form->weights_of(lobes)) values.push_back(weight.value);
  return values;
}

}  // namespace

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

void Model::apply_start(const std::vector<NamedValues>& start, std::vector<double>& p) const {
  for (const NamedValues& given : start) {
    for (std::size_t s = 0; s < shape_slots_; ++s) {
      const Slot& slot = slots_[s];
      if (slot.kind == Slot::Kind::tangent && given.name == "tangent_phi") p[s] = given.values[0] * kPi / 180;
      if (slot.kind != Slot::Kind::shape) continue;
      const ParameterInfo& info = terms_[slot.term].info->shape[slot.members[0]];
      if (!addresses(given.name, slot.term, info.name)) continue;
      check_range(info, given.values[0], "--start");
      const std::size_t k = given.values.size() > 1 ? std::min(slot.group, given.values.size() - 1) : 0;
      p[s] = slot.to_solver(std::clamp(given.values[k], slot.min, slot.max));
    }
  }
}

void Model::apply_start_weights(const std::vector<NamedValues>& start, std::vector<double>& p) const {
  std::vector<double> weights(lobes_);
  for (std::size_t c = 0; c < channels_.size(); ++c)
    for (std::size_t t = 0; t < terms_.size(); ++t) {
      const TermModel& term = terms_[t];
      lobe_weights(p, c, weights);
      std::vector<double> values =
          table_weights(term.form, std::span(weights).subspan(term.first_lobe, term.lobes));
      bool named = false;
      for (const NamedValues& given : start)
        for (std::size_t k = 0; k < values.size(); ++k)
          if (addresses(given.name, t, term.info->weights[k].name)) {
            values[k] = given.values[given.values.size() == channels_.size() ? c : 0];
            check_range(term.info->weights[k], values[k], "--start");
            named = true;
          }
      if (!named) continue;
      // The unknowns that come closest to these lobes' weights.
      const std::vector<double> target = linear_weights(*term.info, values);
      const LinearBlock& block = term.weights[c];
      Matrix h(block.unknowns, block.unknowns);
      std::vector<double> g(block.unknowns, 0);
      for (std::size_t k = 0; k < block.lobes; ++k)
        for (std::size_t u = 0; u < block.unknowns; ++u) {
          g[u] -= block.a[k * block.unknowns + u] * (target[k] - block.b[k]);
          for (std::size_t v = 0; v < block.unknowns; ++v)
            h(u, v) += block.a[k * block.unknowns + u] * block.a[k * block.unknowns + v];
        }
      const std::vector<double> x = box_quadratic(h, g, block.low, block.high);
      std::copy(x.begin(), x.end(), p.begin() + std::ptrdiff_t(block.first_slot));
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
      term.weights.push_back(
          table_weights(terms_[t].form, std::span(weights).subspan(terms_[t].first_lobe, terms_[t].lobes)));
    }
    if (terms_[t].info->anisotropic()) term.tangent_phi = tangent_phi(p);
    m.terms.push_back(std::move(term));
  }
  return m;
}

}  // namespace brdf::fit
