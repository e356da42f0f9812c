// A model to fit: one form or a sum of forms, and how the solver's parameters map to it.
//
// The solver works on shape parameters on a scale that suits them (log alpha, the square of a parameter whose
// derivative vanishes at its lower bound) and on linear weights per channel, in which bounds of
// the specular weight and of f0 are plain bounds. Fixed and bounded parameters become an affine map from the
// linear unknowns to the lobes' weights: w = A u + b.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "fit/model/constraints.h"
#include "fit/model/lobe_columns.h"
#include "fit/model/natural_weights.h"
#include "fit/model/slot.h"
#include "fit/model/smooth.h"

namespace brdf::fit {

// The weights of one term's lobes in one channel from its linear unknowns u: a u + b.
struct WeightMap {
  std::size_t lobes = 0, unknowns = 0, first_slot = 0;
  std::vector<double> a;          // [lobe][unknown]
  std::vector<double> b;          // [lobe]
  std::vector<double> low, high;  // of the unknowns

  double lobe(std::span<const double> p, std::size_t k) const;
  Gradient gradient(std::size_t lobe) const;
  // Of a function of the lobes' weights, from its derivatives by those.
  Gradient gradient(std::span<const double> by_lobe) const;
};

struct TermModel {
  Reflectance form;
  const ReflectanceInfo* info = nullptr;
  std::size_t lobes = 0, first_lobe = 0;
  std::size_t partials = 0, first_partial = 0;  // derivatives that are needed, tangent included
  std::vector<int> partial;                     // [shape parameter]
  int tangent_partial = -1;
  int normal_partial = -1;                       // by x; the one by y follows
  std::vector<std::vector<double>> fixed_shape;  // [group][shape parameter]; NaN where a slot sets it
  std::vector<WeightMap> weights;                // [channel]; none where the weights are natural
};

// d weight of a lobe / d unknown.
struct WeightSlope {
  std::size_t lobe, slot;
  double value;
};

// One entry of a term's table of weights, as a function of the solver's parameters.
struct TableWeight {
  double value, min, max;
  Gradient gradient;
  bool shared = false;  // by all channels
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
  std::size_t shape_slots() const { return shape_slots_; }  // they come first; the rest are of the weights
  // Whether every channel has unknowns of its own, in which its lobes' weights are linear.
  bool linear() const { return !natural_; }
  std::size_t groups() const { return groups_; }  // sets of shapes: 1 or one per channel
  std::size_t group_of(std::size_t channel) const { return groups_ == 1 ? 0 : channel; }
  std::size_t lobes() const { return lobes_; }        // of all terms
  std::size_t partials() const { return partials_; }  // of all terms
  std::size_t tangent_slot() const { return tangent_slot_; }
  std::size_t normal_slot() const { return normal_slot_; }  // of x, then y; kNoSlot where the normal is +z
  bool fits_normal() const { return normal_slot_ != kNoSlot; }

  // Which slot a derivative belongs to, in one group.
  std::size_t slot_of_partial(std::size_t partial, std::size_t group) const {
    return partial_slot_[group * partials_ + partial];
  }
  // What a derivative by a shape parameter is by the unknowns, in one group; none where no slot sets it.
  Gradient slopes_of_partial(std::span<const double> p, std::size_t partial, std::size_t group) const;
  // The same for the parameter that a slot sets, the first one of its nodes.
  Gradient shape_slopes(std::span<const double> p, std::size_t slot, std::size_t group) const;
  const std::optional<SmoothBasis>& smooth() const { return smooth_; }  // none: shapes are not
  // Natural shape of a term in a group.
  std::vector<double> shape(std::span<const double> p, std::size_t term, std::size_t group) const;
  Angle tangent_phi(std::span<const double> p) const;
  Vec3<double> normal(std::span<const double> p) const;
  // Weights of all lobes of a channel.
  void lobe_weights(std::span<const double> p, std::size_t channel, std::span<double> out) const;
  std::vector<WeightSlope> weight_slopes(std::span<const double> p, std::size_t channel) const;
  // The weights of a term in the order of its table.
  std::vector<TableWeight> table_weights(std::span<const double> p, std::size_t term,
                                         std::size_t channel) const;
  // Sets the unknowns so that the weights come close to these, in the order of the tables.
  void set_weights(std::vector<double>& p, const WeightTable& values) const;
  WeightTable weight_table(std::span<const double> p) const;
  NaturalWeights::Sum bounded_sum(std::span<const double> p) const {
    return natural_ ? natural_->bounded_sum(p) : NaturalWeights::Sum();
  }

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
  void add_nodes(Slot slot);
  // On the solver's scale, in a group, of the parameter that a slot sets.
  double scaled_value(std::span<const double> p, std::size_t slot, std::size_t group) const;
  void add_tangent_slot();
  void add_normal_slots();
  void index_partials();
  void add_linear_slots();
  void add_natural_slots(std::span<const Reflectance> forms, Physical physical);
  std::string name_;
  std::vector<TermModel> terms_;
  std::vector<std::string> channels_;
  Constraints constraints_;
  std::vector<Slot> slots_;
  std::vector<std::size_t> partial_slot_;
  std::size_t shape_slots_ = 0, groups_ = 1, lobes_ = 0, partials_ = 0, tangent_slot_ = kNoSlot,
              normal_slot_ = kNoSlot;
  Angle fixed_tangent_{};
  std::optional<std::array<double, 2>> normal_start_;  // none: the normal is not fitted
  std::optional<NaturalWeights> natural_;
  std::optional<SmoothBasis> smooth_;
};

}  // namespace brdf::fit
