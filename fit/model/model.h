// A model to fit: one form or a sum of forms, with the mapping from the solver's parameters to its
// parameters.
//
// The solver works with shape parameters on a suitable scale (log alpha; the square of a parameter whose
// derivative vanishes at its lower bound) and with linear weights per channel. In these unknowns, the
// bounds of the specular weight and of f0 are plain bounds. Fixed and bounded parameters give an affine map
// from the linear unknowns to the weights of the lobes: w = A u + b.
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

// The map a u + b from the linear unknowns u of one term in one channel to the weights of the term's lobes.
struct WeightMap {
  std::size_t lobes = 0, unknowns = 0, first_slot = 0;
  std::vector<double> a;          // [lobe][unknown]
  std::vector<double> b;          // [lobe]
  std::vector<double> low, high;  // bounds of the unknowns

  double lobe(std::span<const double> p, std::size_t k) const;
  Gradient gradient(std::size_t lobe) const;
  // Returns the gradient of a function of the lobes' weights, given its derivatives by these weights.
  Gradient gradient(std::span<const double> by_lobe) const;
};

// A limit of the weights of one channel that a basis of both signs needs: the sum of `lobes` times the
// weights of all lobes is at least `least`. A pass over the samples adds half of `stiffness` times the square
// of the shortfall to the cost.
struct Cut {
  std::size_t channel = 0;
  std::vector<double> lobes;
  double least = 0, stiffness = 0;

  double shortfall(std::span<const double> weights) const;
  // Returns whether the weights are at the limit or beyond it.
  bool is_reached(std::span<const double> weights) const;
};

struct TermModel {
  Reflectance form;
  const ReflectanceInfo* info = nullptr;
  std::size_t lobes = 0, first_lobe = 0;
  std::size_t partials = 0, first_partial = 0;  // required derivatives, including the tangent's
  std::vector<int> partial;                     // [shape parameter]
  int tangent_partial = -1;
  int normal_partial = -1;                       // by x; the derivative by y follows
  std::vector<std::vector<double>> fixed_shape;  // [group][shape parameter]; NaN if set by a slot
  std::vector<WeightMap> weights;                // [channel]; empty if the weights are natural
};

// The derivative of a lobe's weight by an unknown.
struct WeightSlope {
  std::size_t lobe, slot;
  double value;
};

// One entry of a term's table of weights as a function of the solver's parameters.
struct TableWeight {
  double value, min, max;
  Gradient gradient;
  bool shared = false;  // by all channels
};

class Model {
 public:
  // Throws InputError if the forms cannot be fitted or an option has no effect on them.
  Model(std::vector<Reflectance> forms, std::vector<std::string> channels, const FitOptions& options);

  const std::string& name() const { return name_; }  // "ward", "oren_nayar+ward"
  const std::vector<TermModel>& terms() const { return terms_; }
  const Constraints& constraints() const { return constraints_; }
  const std::vector<Slot>& slots() const { return slots_; }
  const std::vector<std::string>& channels() const { return channels_; }
  std::size_t size() const { return slots_.size(); }
  // Returns the number of shape slots. They come first, followed by the slots of the weights.
  std::size_t shape_slots() const { return shape_slots_; }
  // Returns whether every channel has unknowns of its own in which the weights of its lobes are linear.
  bool linear() const { return !natural_; }
  std::size_t groups() const { return groups_; }  // number of sets of shapes: 1 or one per channel
  std::size_t group_of(std::size_t channel) const { return groups_ == 1 ? 0 : channel; }
  std::size_t lobes() const { return lobes_; }        // of all terms
  std::size_t partials() const { return partials_; }  // of all terms
  std::size_t tangent_slot() const { return tangent_slot_; }
  // Returns the slot of the normal's x; the slot of y follows. Returns kNoSlot if the normal is +z.
  std::size_t normal_slot() const { return normal_slot_; }
  bool fits_normal() const { return normal_slot_ != kNoSlot; }

  // Returns the slot of a derivative in one group.
  std::size_t slot_of_partial(std::size_t partial, std::size_t group) const {
    return partial_slot_[group * partials_ + partial];
  }
  // Returns the slopes of the shape parameter of a derivative by the unknowns, in one group. Empty if no
  // slot sets the parameter.
  Gradient slopes_of_partial(std::span<const double> p, std::size_t partial, std::size_t group) const;
  // Returns the same slopes for the parameter that a slot sets; the slot is the first of its nodes.
  Gradient shape_slopes(std::span<const double> p, std::size_t slot, std::size_t group) const;
  // Returns the basis in wavelength, or std::nullopt if shapes are not smooth over wavelength.
  const std::optional<SmoothBasis>& smooth() const { return smooth_; }
  // Returns the natural shape parameters of a term in a group.
  std::vector<double> shape(std::span<const double> p, std::size_t term, std::size_t group) const;
  // Returns the azimuth of the tangent.
  Angle tangent_phi(std::span<const double> p) const;
  // Returns the unit normal of the surface, +z if the normal is not fitted.
  Vec3<double> normal(std::span<const double> p) const;
  // Computes the weights of all lobes of a channel.
  void lobe_weights(std::span<const double> p, std::size_t channel, std::span<double> out) const;
  // Returns the derivatives of the weights of a channel's lobes by the unknowns.
  std::vector<WeightSlope> weight_slopes(std::span<const double> p, std::size_t channel) const;
  // Returns the weights of a term in the order of its table.
  std::vector<TableWeight> table_weights(std::span<const double> p, std::size_t term,
                                         std::size_t channel) const;
  // Sets the unknowns so that the weights come close to `values`, in the order of the tables.
  void set_weights(std::vector<double>& p, const WeightTable& values) const;
  // Returns the weights in the order of the tables.
  WeightTable weight_table(std::span<const double> p) const;
  // Returns the sum that --physical bounds; empty if there is no such sum.
  NaturalWeights::Sum bounded_sum(std::span<const double> p) const {
    return natural_ ? natural_->bounded_sum(p) : NaturalWeights::Sum();
  }

  // Returns whether a term has weights of either sign.
  bool is_signed() const;
  // Returns whether --physical limits the albedo itself, because a term has weights of either sign.
  bool limits_albedo() const { return limits_albedo_; }
  // The limits of the weights, and one more limit.
  const std::vector<Cut>& cuts() const { return cuts_; }
  void add_cut(Cut cut) { cuts_.push_back(std::move(cut)); }

  // Return the lower and the upper bounds of the solver's parameters.
  std::vector<double> low() const, high() const;
  // Returns the initial values of the tables. Linear unknowns are 0, clipped to their bounds.
  std::vector<double> initial() const;
  // Set the shape parameters, and the weights, that `--start` names. Other parameters of p are unchanged.
  void apply_start(std::vector<double>& p) const;
  void apply_start_weights(std::vector<double>& p) const;

  // Returns the material at the solver's parameters p.
  Material material(std::span<const double> p) const;

  // Returns the reported name of a parameter: alpha_x, or terms[1].alpha_x in a sum.
  std::string prefixed(std::size_t term, std::string_view parameter) const {
    return name_in_sum(terms_.size(), term, parameter);
  }

 private:
  void add_term(const Reflectance& form);
  void add_shape_slots(bool anisotropic);
  void add_shape_parameter(std::size_t term, const std::vector<std::size_t>& members);
  void add_nodes(Slot slot);
  // Returns the value, on the solver's scale and in a group, of the parameter that a slot sets.
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
  std::optional<std::array<double, 2>> normal_start_;  // std::nullopt: the normal is not fitted
  std::optional<NaturalWeights> natural_;
  std::optional<SmoothBasis> smooth_;
  bool limits_albedo_ = false;
  std::vector<Cut> cuts_;
};

}  // namespace brdf::fit
