// What the solver searches: one slot per free parameter, from the forms' tables and the user's options.
#include "fit/model/model.h"

#include <algorithm>
#include <cmath>

#include "io/error.h"
#include "io/text.h"

namespace brdf::fit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
bool is_width(std::string_view name) {
  return name == "alpha_x" || name == "alpha_y";
}

// True where every lobe's derivative by the parameter vanishes at its
// lower bound, as sigma's does in Oren-Nayar: such a parameter enters by
// its square, and on its own scale a solver would never leave the bound.
bool flat_at_minimum(const Reflectance& form, const ReflectanceInfo& info, std::size_t parameter) {
  std::vector<double> shape;
  for (const ParameterInfo& q : info.shape) shape.push_back(q.initial);
  shape[parameter] = info.shape[parameter].min;
  DirectionArrays<double> pairs(2);
  pairs.set(0, {-0.6, 0, 0.8}, {0.48, 0.64, 0.6});
  pairs.set(1, {-0.6, 0, 0.8}, {-0.28, 0, 0.96});
  LobeBlock block(form);
  block.evaluate(shape, {}, Partial::shape, pairs.view(), {});
  for (std::size_t k = 0; k < lobe_count_of(form); ++k)
    for (std::size_t j = 0; j < 2; ++j)
      if (block.derivative(k, parameter)[j] != 0) return false;
  return true;
}

Scale scale_of(const Reflectance& form, const ReflectanceInfo& info, std::size_t parameter) {
  const ParameterInfo& p = info.shape[parameter];
  if (p.log_scale) return p.min > 0 ? Scale::log : Scale::log1p;
  return flat_at_minimum(form, info, parameter) ? Scale::square : Scale::identity;
}

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

bool addresses(std::string_view given, std::size_t term, std::string_view parameter) {
  const std::string prefix = "terms[" + std::to_string(term) + "].";
  if (given.starts_with(prefix)) given.remove_prefix(prefix.size());
  return given == parameter || (given == "alpha" && is_width(parameter));
}

void check_range(const ParameterInfo& p, double value, const char* option) {
  if (!(value >= p.min && value <= p.max))
    throw InputError(std::string(option) + " " + std::string(p.name) + ": " + io::to_text(value) +
                     " is outside " + io::to_text(p.min) + " to " + io::to_text(p.max));
}

Model::Model(std::vector<Reflectance> forms, std::vector<std::string> channels, const FitOptions& options)
    : channels_(std::move(channels)) {
  groups_ = options.per_channel ? channels_.size() : 1;
  for (const Reflectance& form : forms) {
    TermModel term{form, &info(form)};
    if (!term.info->fittable())
      throw InputError("form '" + std::string(term.info->name) +
                       "' cannot be fitted: it is not linear in its weights");
    term.lobes = lobe_count_of(form);
    term.first_lobe = lobes_;
    lobes_ += term.lobes;
    name_ += (name_.empty() ? "" : "+") + std::string(term.info->name);
    terms_.push_back(std::move(term));
  }
  add_shape_slots(options);
  add_linear_slots(options);
  const auto check = [&](const std::string& name, const char* option) {
    for (std::size_t t = 0; t < terms_.size(); ++t) {
      for (const ParameterInfo& p : terms_[t].info->shape)
        if (addresses(name, t, p.name)) return;
      for (const ParameterInfo& p : terms_[t].info->weights)
        if (addresses(name, t, p.name)) return;
      if (name == "tangent_phi" && terms_[t].info->anisotropic()) return;
    }
    throw InputError(std::string(option) + " " + name + ": " + name_ + " has no such parameter");
  };
  for (const auto& f : options.fix) check(f.name, "--fix");
  for (const auto& s : options.start) check(s.name, "--start");
  for (const auto& b : options.bounds) check(b.name, "--bounds");
}

std::string Model::prefixed(std::size_t term, std::string_view parameter) const {
  if (terms_.size() == 1) return std::string(parameter);
  return "terms[" + std::to_string(term) + "]." + std::string(parameter);
}

// The value that --fix gives, NaN where it gives none.
double Model::fixed_value(const FitOptions& options, std::size_t term, std::string_view parameter,
                          std::size_t channel) const {
  double value = kNan;
  for (const NamedValues& f : options.fix) {
    if (!addresses(f.name, term, parameter)) continue;
    if (f.values.size() != 1 && f.values.size() != channels_.size())
      throw InputError("--fix " + f.name + ": " + std::to_string(f.values.size()) + " values for " +
                       std::to_string(channels_.size()) + " channels");
    value = f.values[f.values.size() == 1 ? 0 : channel];
  }
  return value;
}

void Model::add_shape_slots(const FitOptions& options) {
  bool turned = false;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    TermModel& term = terms_[t];
    const ReflectanceInfo& info = *term.info;
    term.fixed_shape.assign(groups_, std::vector<double>(info.shape.size(), kNan));
    term.partial.assign(info.shape.size(), -1);
    term.first_partial = partials_;
    const int x = info.shape_index("alpha_x"), y = info.shape_index("alpha_y");
    const bool tied = x >= 0 && y >= 0 && !options.anisotropic;
    for (std::size_t k = 0; k < info.shape.size(); ++k) {
      if (tied && int(k) == y) continue;
      const ParameterInfo& p = info.shape[k];
      Slot slot{Slot::Kind::shape, t, {k}};
      if (tied && int(k) == x) slot.members.push_back(std::size_t(y));
      slot.name = prefixed(t, tied && int(k) == x ? "alpha" : p.name);
      slot.scale = scale_of(term.form, info, k);
      slot.min = p.min, slot.max = p.max, slot.grid_max = p.usual_max;
      for (const NamedRange& b : options.bounds) {
        if (!addresses(b.name, t, p.name)) continue;
        check_range(p, b.low, "--bounds"), check_range(p, b.high, "--bounds");
        slot.min = b.low, slot.max = b.high;
        slot.grid_max = std::clamp(slot.grid_max, b.low, b.high);
      }
      slot.low = slot.to_solver(slot.min), slot.high = slot.to_solver(slot.max);
      bool free = false;
      for (std::size_t g = 0; g < groups_; ++g) {
        double fixed = fixed_value(options, t, p.name, g);
        if (tied && std::isnan(fixed)) fixed = fixed_value(options, t, info.shape[std::size_t(y)].name, g);
        if (!std::isnan(fixed)) {
          check_range(p, fixed, "--fix");
          for (std::size_t m : slot.members) term.fixed_shape[g][m] = fixed;
          continue;
        }
        free = true;
        slot.group = g;
        Slot one = slot;
        if (groups_ > 1) one.name += "[" + channels_[g] + "]";
        slots_.push_back(std::move(one));
      }
      if (free) {
        for (std::size_t m : slot.members) term.partial[m] = int(term.partials);
        ++term.partials;
      }
    }
    if (options.anisotropic && info.anisotropic()) {
      const double fixed = fixed_value(options, t, "tangent_phi", 0);
      if (std::isnan(fixed)) {
        term.tangent_partial = int(term.partials++);
        turned = true;
      } else {
        fixed_tangent_ = degrees(fixed);
      }
    }
    partials_ += term.partials;
  }
  if (turned) {
    tangent_slot_ = slots_.size();
    Slot slot{Slot::Kind::tangent};
    slot.name = "tangent_phi";
    slot.min = slot.low = -kPi, slot.max = slot.high = kPi;
    slots_.push_back(slot);
  }
  shape_slots_ = slots_.size();
  partial_slot_.assign(groups_ * partials_, kNoSlot);
  for (std::size_t s = 0; s < shape_slots_; ++s) {
    const Slot& slot = slots_[s];
    if (slot.kind != Slot::Kind::shape) continue;
    const TermModel& term = terms_[slot.term];
    partial_slot_[slot.group * partials_ + term.first_partial + std::size_t(term.partial[slot.members[0]])] =
        s;
  }
  for (const TermModel& term : terms_)
    if (term.tangent_partial >= 0)
      for (std::size_t g = 0; g < groups_; ++g)
        partial_slot_[g * partials_ + term.first_partial + std::size_t(term.tangent_partial)] = tangent_slot_;
}

void Model::add_linear_slots(const FitOptions& options) {
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    for (std::size_t t = 0; t < terms_.size(); ++t) {
      LinearBlock block = linear_block(t, c, options);
      block.first_slot = slots_.size();
      for (std::size_t u = 0; u < block.unknowns; ++u) {
        Slot slot{Slot::Kind::linear, t, {}, c};
        slot.min = slot.low = block.low[u];
        slot.max = slot.high = block.high[u];
        slot.name = prefixed(t, "weight") + std::to_string(u) + "[" + channels_[c] + "]";
        slots_.push_back(std::move(slot));
      }
      terms_[t].weights.push_back(std::move(block));
    }
  }
}

LinearBlock Model::linear_block(std::size_t t, std::size_t channel, const FitOptions& options) const {
  const ReflectanceInfo& info = *terms_[t].info;
  const std::size_t lobes = terms_[t].lobes;
  LinearBlock block;
  block.lobes = lobes;
  block.b.assign(lobes, 0);
  std::vector<std::vector<double>> columns;
  const auto unknown = [&](std::vector<double> column, double low, double high) {
    columns.push_back(std::move(column));
    block.low.push_back(low);
    block.high.push_back(high);
  };
  const auto range = [&](const ParameterInfo& p) {
    std::pair r{p.min, p.max};
    for (const NamedRange& b : options.bounds)
      if (addresses(b.name, t, p.name)) {
        check_range(p, b.low, "--bounds"), check_range(p, b.high, "--bounds");
        r = {b.low, b.high};
      }
    return r;
  };
  const auto fixed = [&](const ParameterInfo& p) {
    const double value = fixed_value(options, t, p.name, channel);
    if (!std::isnan(value)) check_range(p, value, "--fix");
    return value;
  };
  // A sum keeps one diffuse term: rho where a term has it, else the first kd. More would be collinear.
  bool diffuse_elsewhere = false;
  for (std::size_t s = 0; s < terms_.size(); ++s)
    diffuse_elsewhere = diffuse_elsewhere || (s != t && terms_[s].info->weight_index("rho") >= 0) ||
                        (s < t && terms_[s].info->weight_index("kd") >= 0);
  const int ks = info.weight_index("ks"), f0 = info.weight_index("f0");
  for (std::size_t k = 0; k < info.weights.size(); ++k) {
    const ParameterInfo& p = info.weights[k];
    if (f0 >= 0 && (int(k) == ks || int(k) == f0)) continue;
    double value = fixed(p);
    if (std::isnan(value) && p.name == "kd" && diffuse_elsewhere) value = 0;
    std::vector<double> column(lobes, 0);
    column[k] = 1;
    if (!std::isnan(value))
      block.b[k] = value;
    else
      unknown(column, range(p).first, range(p).second);
  }
  if (f0 >= 0) {  // lobes ks and f0: V D with ks f0, V D s with ks (1 - f0)
    const std::size_t near = std::size_t(ks), rise = std::size_t(f0);
    const double weight = fixed(info.weights[near]), fresnel = fixed(info.weights[rise]);
    const auto [f_low, f_high] = range(info.weights[rise]);
    const auto [k_low, k_high] = range(info.weights[near]);
    const auto ray = [&](double f) {
      std::vector<double> column(lobes, 0);
      column[near] = f, column[rise] = 1 - f;
      return column;
    };
    if (!std::isnan(weight) && !std::isnan(fresnel)) {
      block.b[near] = weight * fresnel, block.b[rise] = weight * (1 - fresnel);
    } else if (!std::isnan(weight)) {
      block.b[rise] = weight;
      std::vector<double> column(lobes, 0);
      column[near] = weight, column[rise] = -weight;
      unknown(column, f_low, f_high);
    } else if (!std::isnan(fresnel)) {
      unknown(ray(fresnel), k_low, k_high);
    } else {
      if (k_low != info.weights[near].min || k_high != info.weights[near].max)
        throw InputError("--bounds ks: needs --fix f0 as well in " + std::string(info.name) +
                         ", where both share two lobes");
      unknown(ray(f_high), 0, info.weights[near].max);
      if (f_low < f_high) unknown(ray(f_low), 0, info.weights[near].max);
    }
  }
  block.unknowns = columns.size();
  block.a.assign(lobes * block.unknowns, 0);
  for (std::size_t k = 0; k < lobes; ++k)
    for (std::size_t u = 0; u < block.unknowns; ++u) block.a[k * block.unknowns + u] = columns[u][k];
  return block;
}

}  // namespace brdf::fit
