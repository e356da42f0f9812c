// The unknowns of the solver: one slot per free parameter, from the tables of the forms and the constraints
// of the user.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/model/model.h"
#include "io/files/error.h"

namespace brdf::fit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Returns whether the derivative of every lobe by the parameter vanishes at the lower bound, as for sigma
// in Oren-Nayar. Such a parameter enters by its square; on its own scale a solver would never leave the
// bound.
bool flat_at_minimum(const Reflectance& form, const ReflectanceInfo& info, std::size_t parameter) {
  std::vector<double> shape;
  for (const ParameterInfo& q : info.shape) shape.push_back(q.initial);
  shape[parameter] = info.shape[parameter].min;
  DirectionArrays<double> pairs(2);
  pairs.set(0, {-0.6, 0, 0.8}, {0.48, 0.64, 0.6});
  pairs.set(1, {-0.6, 0, 0.8}, {-0.28, 0, 0.96});
  LobeColumns columns(form);
  columns.evaluate(shape, {}, Partial::shape, pairs.view(), {});
  for (std::size_t k = 0; k < info.lobes.size(); ++k)
    for (std::size_t j = 0; j < 2; ++j)
      if (columns.derivative(k, parameter)[j] != 0) return false;
  return true;
}

Scale scale_of(const Reflectance& form, const ReflectanceInfo& info, std::size_t parameter) {
  const ParameterInfo& p = info.shape[parameter];
  if (p.log_scale) return p.min > 0 ? Scale::log : Scale::log1p;
  return flat_at_minimum(form, info, parameter) ? Scale::square : Scale::identity;
}

// Builds the map from the weights of a term's table to the weights of its lobes, column by column.
class WeightMapBuilder {
 public:
  WeightMapBuilder(const ReflectanceInfo& info, const std::vector<Constraint>& constraints,
                   std::size_t channel)
      : info_(info), constraints_(constraints), channel_(channel) {
    map_.lobes = info.lobes.size();
    map_.b.assign(map_.lobes, 0);
  }

  WeightMap build() {
    const int f0 = info_.weight_index(Role::f0), divided = weight_of_f0(info_.lobes);
    for (std::size_t k = 0; k < info_.weights.size(); ++k) {
      if (int(k) == f0) continue;
      if (int(k) == divided)
        add_with_f0(k, std::size_t(f0));
      else
        add_plain(k);
    }
    map_.unknowns = columns_.size();
    map_.a.assign(map_.lobes * map_.unknowns, 0);
    for (std::size_t l = 0; l < map_.lobes; ++l)
      for (std::size_t u = 0; u < map_.unknowns; ++u) map_.a[l * map_.unknowns + u] = columns_[u][l];
    return std::move(map_);
  }

 private:
  using Column = std::vector<double>;

  // Returns the weights of the lobes if this weight is `size` and all others are 0.
  Column column(std::size_t weight, double size, double f0 = 0) const {
    std::vector<double> weights(info_.weights.size(), 0);
    weights[weight] = size;
    if (const int k = info_.weight_index(Role::f0); k >= 0) weights[std::size_t(k)] = f0;
    return linear_weights(info_, weights);
  }
  void add_constant(const Column& c) {
    for (std::size_t l = 0; l < map_.lobes; ++l) map_.b[l] += c[l];
  }
  void add_unknown(Column c, double low, double high) {
    columns_.push_back(std::move(c));
    map_.low.push_back(low);
    map_.high.push_back(high);
  }

  void add_plain(std::size_t weight) {
    const Constraint& c = constraints_[weight];
    if (c.is_fixed())
      add_constant(column(weight, c.fixed_in(channel_)));
    else
      add_unknown(column(weight, 1), c.low, c.high);
  }

  // Adds a weight with lobes that f0 divides. The unknowns are the weights at the lowest and the highest
  // f0, so the bounds of both parameters are plain bounds.
  void add_with_f0(std::size_t weight, std::size_t f0) {
    const Constraint &w = constraints_[weight], &f = constraints_[f0];
    const ParameterInfo& table = info_.weights[weight];
    if (w.is_fixed() && f.is_fixed()) {
      add_constant(column(weight, w.fixed_in(channel_), f.fixed_in(channel_)));
    } else if (w.is_fixed()) {
      const Column dark = column(weight, w.fixed_in(channel_), 0);
      Column slope = column(weight, w.fixed_in(channel_), 1);
      for (std::size_t l = 0; l < slope.size(); ++l) slope[l] -= dark[l];
      add_constant(dark);
      add_unknown(std::move(slope), f.low, f.high);
    } else if (f.is_fixed()) {
      add_unknown(column(weight, 1, f.fixed_in(channel_)), w.low, w.high);
    } else {
      if (w.low != table.min || w.high != table.max)
        throw InputError("--bounds " + std::string(table.name) + ": needs --fix " +
                         std::string(info_.weights[f0].name) + " as well in " + std::string(info_.name) +
                         ", because the two share lobes");
      add_unknown(column(weight, 1, f.high), 0, table.max);
      if (f.low < f.high) add_unknown(column(weight, 1, f.low), 0, table.max);
    }
  }

  const ReflectanceInfo& info_;
  const std::vector<Constraint>& constraints_;
  std::size_t channel_;
  WeightMap map_;
  std::vector<Column> columns_;
};

}  // namespace

double Slot::to_solver(double x) const {
  switch (scale) {
    case Scale::log:
      return std::log(x);
    case Scale::log1p:
      return std::log1p(x);
    case Scale::square:
      return x * x;
    default:
      return x;
  }
}

double Slot::to_natural(double u) const {
  double x = u;
  if (scale == Scale::log) x = std::exp(u);
  if (scale == Scale::log1p) x = std::expm1(u);
  if (scale == Scale::square) x = std::sqrt(std::max(u, 0.0));
  return std::clamp(x, min, max);
}

double Slot::slope(double u) const {
  switch (scale) {
    case Scale::log:
    case Scale::log1p:
      return std::exp(u);
    case Scale::square:
      return 0.5 / std::max(std::sqrt(std::max(u, 0.0)), kSquareFloor);
    default:
      return 1;
  }
}

void Model::add_shape_slots(bool anisotropic) {
  bool turned = false;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    TermModel& term = terms_[t];
    const ReflectanceInfo& info = *term.info;
    const auto [along, across] = info.axes();
    const bool tied = info.anisotropic() && !anisotropic;
    term.fixed_shape.assign(groups_, std::vector<double>(info.shape.size(), kNan));
    term.partial.assign(info.shape.size(), -1);
    term.first_partial = partials_;
    for (std::size_t k = 0; k < info.shape.size(); ++k) {
      if (tied && int(k) == across) continue;
      std::vector<std::size_t> members{k};
      if (tied && int(k) == along) members.push_back(std::size_t(across));
      add_shape_parameter(t, members);
    }
    if (info.anisotropic() && anisotropic && !constraints_.tangent.is_fixed()) {
      term.tangent_partial = int(term.partials++);
      turned = true;
    }
    if (normal_start_) {
      term.normal_partial = int(term.partials);
      term.partials += 2;
    }
    partials_ += term.partials;
  }
  if (constraints_.tangent.is_fixed()) fixed_tangent_ = degrees(constraints_.tangent.fixed[0]);
  if (turned) add_tangent_slot();
  if (normal_start_) add_normal_slots();
  shape_slots_ = slots_.size();
  index_partials();
}

// Adds the slots of one parameter, or of two tied parameters: one for every group of channels, unless the
// parameter is held.
void Model::add_shape_parameter(std::size_t t, const std::vector<std::size_t>& members) {
  TermModel& term = terms_[t];
  const Constraint& c = constraints_.terms[t].shape[members[0]];
  if (c.is_fixed()) {
    for (std::size_t g = 0; g < groups_; ++g)
      for (std::size_t m : members) term.fixed_shape[g][m] = c.fixed_in(g);
    return;
  }
  const ReflectanceInfo& info = *term.info;
  const ParameterInfo& p = info.shape[members[0]];
  Slot slot{Slot::Kind::shape, t, members};
  slot.role = p.role;
  slot.scale = scale_of(term.form, info, members[0]);
  slot.min = c.low;
  slot.max = c.high;
  slot.grid_max = std::clamp(p.usual_max, c.low, c.high);
  slot.low = slot.to_solver(slot.min);
  slot.high = slot.to_solver(slot.max);
  const std::string name = prefixed(t, members.size() > 1 ? info.tied_name() : p.name);
  for (std::size_t m : members) term.partial[m] = int(term.partials);
  ++term.partials;
  const bool shared = groups_ > 1 && c.tied;
  if (smooth_ && !shared) {
    slot.name = name;
    return add_nodes(std::move(slot));
  }
  for (std::size_t g = 0; g < (shared ? 1 : groups_); ++g) {
    slot.group = shared ? kEveryGroup : g;
    slot.name = groups_ > 1 && !shared ? name + "[" + channels_[g] + "]" : name;
    slots_.push_back(slot);
  }
}

// Adds the slots of a smooth shape, one for the value at each node.
void Model::add_nodes(Slot slot) {
  slot.group = kEveryGroup;
  slot.nodes = smooth_->nodes.size();
  for (slot.node = 0; slot.node < slot.nodes; ++slot.node) {
    slot.share = smooth_->share[slot.node];
    slots_.push_back(slot);
  }
}

void Model::add_tangent_slot() {
  tangent_slot_ = slots_.size();
  Slot slot{Slot::Kind::tangent};
  slot.name = kTangentInfo.name;
  slot.min = slot.low = -kPi;
  slot.max = slot.high = kPi;
  slots_.push_back(std::move(slot));
}

void Model::add_normal_slots() {
  normal_slot_ = slots_.size();
  for (const ParameterInfo& info : kNormalInfo) {
    Slot slot{Slot::Kind::normal};
    slot.group = kEveryGroup;
    slot.name = info.name;
    slot.min = slot.low = info.min;
    slot.max = slot.high = info.max;
    slots_.push_back(std::move(slot));
  }
}

// Sets the slot of each derivative.
void Model::index_partials() {
  partial_slot_.assign(groups_ * partials_, kNoSlot);
  const auto set = [&](std::size_t group, const TermModel& term, int partial, std::size_t slot) {
    partial_slot_[group * partials_ + term.first_partial + std::size_t(partial)] = slot;
  };
  for (std::size_t s = 0; s < shape_slots_; ++s) {
    const Slot& slot = slots_[s];
    for (std::size_t g = 0; g < groups_ && slot.kind == Slot::Kind::shape; ++g)
      if (slot.node == 0 && slot.in_group(g))
        set(g, terms_[slot.term], terms_[slot.term].partial[slot.members[0]], s);
  }
  for (const TermModel& term : terms_)
    for (std::size_t g = 0; g < groups_; ++g) {
      if (term.tangent_partial >= 0) set(g, term, term.tangent_partial, tangent_slot_);
      for (int a = 0; a < 2 && term.normal_partial >= 0; ++a)
        set(g, term, term.normal_partial + a, normal_slot_ + std::size_t(a));
    }
}

void Model::add_linear_slots() {
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    for (std::size_t t = 0; t < terms_.size(); ++t) {
      WeightMap map = WeightMapBuilder(*terms_[t].info, constraints_.terms[t].weights, c).build();
      map.first_slot = slots_.size();
      for (std::size_t u = 0; u < map.unknowns; ++u) {
        Slot slot{Slot::Kind::linear, t, {}, c};
        slot.min = slot.low = map.low[u];
        slot.max = slot.high = map.high[u];
        slot.name = prefixed(t, "weight") + std::to_string(u) + "[" + channels_[c] + "]";
        slots_.push_back(std::move(slot));
      }
      terms_[t].weights.push_back(std::move(map));
    }
  }
}

void Model::add_natural_slots(std::span<const Reflectance> forms, Physical physical) {
  natural_.emplace(forms, constraints_, channels_, physical, slots_.size());
  slots_.insert(slots_.end(), natural_->slots().begin(), natural_->slots().end());
}

}  // namespace brdf::fit
