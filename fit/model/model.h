// A model to fit: one form or a sum of forms, and how the solver's parameters map to it.
//
// The solver works on shape parameters on a scale that suits them (log alpha, the square of a parameter whose
// derivative vanishes at its lower bound) and on linear weights per channel, in which bounds of
// the specular weight and of f0 are plain bounds. Fixed and bounded parameters become an affine map from the
// linear unknowns to the lobes' weights: w = A u + b.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "fit/model/constraints.h"
#include "fit/model/lobe_columns.h"

namespace brdf::fit {

inline constexpr std::size_t kNoSlot = std::size_t(-1);

// A parameter on the square's scale is evaluated no closer to 0 than this: there its own derivative, which
// the scale divides by the parameter, is still exact.
inline constexpr double kSquareFloor = 1e-6;

enum class Scale { identity, log, log1p, square };

// One unknown of the solver.
struct Slot {
  enum class Kind { shape, tangent, linear } kind;
  std::size_t term = 0;
  std::vector<std::size_t> members;  // shape parameters it sets (two where the widths are tied)
  std::size_t group = 0;             // shape: which set of shapes; linear: which channel
  Role role = Role::other;           // of the first member
  Scale scale = Scale::identity;
  double min = 0, max = 0;   // natural
  double low = 0, high = 0;  // on the solver's scale
  double grid_max = 0;       // natural: what a grid of starts covers
  std::string name;          // as reported: alpha, alpha_x, terms[1].sigma

  // The same parameter, perhaps of other channels.
  bool same_parameter(const Slot& s) const {
    return kind == s.kind && term == s.term && members == s.members;
  }
  bool same_range(const Slot& s) const { return min == s.min && max == s.max; }
  double to_solver(double natural) const;
  double to_natural(double u) const;
  double slope(double u) const;  // d natural / d u
};

// The weights of one term's lobes in one channel from its linear unknowns u: a u + b.
struct WeightMap {
  std::size_t lobes = 0, unknowns = 0, first_slot = 0;
  std::vector<double> a;          // [lobe][unknown]
  std::vector<double> b;          // [lobe]
  std::vector<double> low, high;  // of the unknowns
};

struct TermModel {
  Reflectance form;
  const ReflectanceInfo* info = nullptr;
  std::size_t lobes = 0, first_lobe = 0;
  std::size_t partials = 0, first_partial = 0;  // derivatives that are needed, tangent included
  std::vector<int> partial;                     // [shape parameter]
  int tangent_partial = -1;
  std::vector<std::vector<double>> fixed_shape;  // [group][shape parameter]; NaN where a slot sets it
  std::vector<WeightMap> weights;                // [channel]
};

class Model {
 public:
  // Throws InputError where the forms cannot be fitted or an option has no effect on them.
  Model(std::vector<Reflectance> forms, std::vector<std::string> channels, const FitOptions& options);

  const std::string& name() const { return name_; }  // "ward", "oren_nayar+ward"
  const std::vector<TermModel>& terms() const { return terms_; }
  const Constraints& constraints() const { return constraints_; }
  const std::vector<Slot>& slots() const { return slots_; }
  const std::vector<std::string>& channels() const { return channels_; }
  std::size_t size() const { return slots_.size(); }
  std::size_t shape_slots() const { return shape_slots_; }  // they come first; the rest are linear
  std::size_t groups() const { return groups_; }            // sets of shapes: 1 or one per channel
  std::size_t group_of(std::size_t channel) const { return groups_ == 1 ? 0 : channel; }
  std::size_t lobes() const { return lobes_; }        // of all terms
  std::size_t partials() const { return partials_; }  // of all terms
  std::size_t tangent_slot() const { return tangent_slot_; }

  // Which slot a derivative belongs to, in one group.
  std::size_t slot_of_partial(std::size_t partial, std::size_t group) const {
    return partial_slot_[group * partials_ + partial];
  }
  // Natural shape of a term in a group.
  std::vector<double> shape(std::span<const double> p, std::size_t term, std::size_t group) const;
  Angle tangent_phi(std::span<const double> p) const;
  // Weights of all lobes of a channel.
  void lobe_weights(std::span<const double> p, std::size_t channel, std::span<double> out) const;

  std::vector<double> low() const, high() const;
  // At the tables' initial values; linear unknowns 0 within their bounds.
  std::vector<double> initial() const;
  // Sets the shape parameters, and the weights, that `--start` names; the others stay as p has them.
  void apply_start(std::vector<double>& p) const;
  void apply_start_weights(std::vector<double>& p) const;

  Material material(std::span<const double> p) const;

  // A parameter's name as reported: alpha_x, terms[1].alpha_x in a sum.
  std::string prefixed(std::size_t term, std::string_view parameter) const {
    return name_in_sum(terms_.size(), term, parameter);
  }

 private:
  void add_term(const Reflectance& form);
  void add_shape_slots(bool anisotropic);
  void add_shape_parameter(std::size_t term, const std::vector<std::size_t>& members);
  void add_tangent_slot();
  void index_partials();
  void add_linear_slots();
  std::vector<double> table_weights(std::span<const double> lobes, std::size_t term) const;

  std::string name_;
  std::vector<TermModel> terms_;
  std::vector<std::string> channels_;
  Constraints constraints_;
  std::vector<Slot> slots_;
  std::vector<std::size_t> partial_slot_;
  std::size_t shape_slots_ = 0, groups_ = 1, lobes_ = 0, partials_ = 0, tangent_slot_ = kNoSlot;
  Angle fixed_tangent_{};
};

}  // namespace brdf::fit
