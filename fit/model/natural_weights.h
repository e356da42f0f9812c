// Weights that are shared between channels or have a bounded sum. The solver's unknowns are then the
// weights themselves, each within its own bounds. A sum of at most 1 is divided like a stick that is
// broken: the first weight is a share of 1, the next a share of the remainder. Hence every weight, of a
// table or of a lobe, is a product of factors u or 1 - u with unknowns u.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brdf/reflectance.h"
#include "fit/model/constraints.h"
#include "fit/model/slot.h"

namespace brdf::fit {

using Gradient = std::vector<std::pair<std::size_t, double>>;       // by slot
using WeightTable = std::vector<std::vector<std::vector<double>>>;  // [term][channel][weight]

struct Product {
  struct Factor {
    std::size_t slot;
    bool rest;  // 1 - u
    double value(std::span<const double> p) const { return rest ? 1 - p[slot] : p[slot]; }
  };
  double scale = 1;
  std::vector<Factor> factors;

  double value(std::span<const double> p) const;
  Gradient gradient(std::span<const double> p) const;
  Product times(Factor factor) const;
};

class NaturalWeights {
 public:
  // Returns whether the options require natural weights: a weight is tied, or --physical is set.
  static bool asked_for(const Constraints& constraints, Physical physical);

  // The slots of the weights will be appended to `first` existing slots. Throws InputError if the
  // constraints contradict each other.
  NaturalWeights(std::span<const Reflectance> forms, const Constraints& constraints,
                 const std::vector<std::string>& channels, Physical physical, std::size_t first);

  const std::vector<Slot>& slots() const { return slots_; }
  // Returns weight number `k` of a term's table in one channel.
  const Product& weight(std::size_t term, std::size_t channel, std::size_t k) const {
    return weights_[term][channel][k];
  }
  // Returns the weight of a lobe of a term in one channel.
  const Product& lobe(std::size_t term, std::size_t channel, std::size_t lobe) const {
    return lobes_[term][channel][lobe];
  }
  // Returns whether all channels share weight number `k` of a term.
  bool shared(std::size_t term, std::size_t k) const;
  // The sum that --physical bounds: its name, "kd + ks", and the channels in which the sum is at its bound.
  // Empty if the sum has no more than one weight.
  struct Sum {
    std::string name;
    std::vector<std::size_t> at_bound;
  };
  Sum bounded_sum(std::span<const double> p) const;
  // Sets the slots of p so that the weights come close to `values`. A slot that several channels share
  // takes their mean.
  void set(std::vector<double>& p, const WeightTable& values) const;

 private:
  struct Place {
    std::size_t term, weight;
  };
  void add_f0s();
  double held(std::size_t channel) const;
  void add_bounded(std::vector<Place> free);
  void add_alone(const Place& place, std::span<const double> most);
  Product product_of_lobe(std::size_t term, std::size_t channel, std::size_t lobe) const;
  void make_lobes();
  std::size_t add_slot(const Place& place, std::size_t group, double low, double high);
  std::vector<double> room(const std::vector<Place>& free) const;
  std::vector<std::size_t> groups(const Place& place) const;
  const Constraint& constraint(const Place& place) const {
    return constraints_.terms[place.term].weights[place.weight];
  }
  const ParameterInfo& info_of(const Place& place) const {
    return forms_[place.term].info().weights[place.weight];
  }
  bool is_f0(const Place& place) const { return info_of(place).role == Role::f0; }

  std::vector<Reflectance> forms_;
  Constraints constraints_;
  std::vector<std::string> channels_;
  Physical physical_;
  std::size_t first_;
  std::vector<Slot> slots_;
  std::vector<Place> summed_;  // the weights with a sum of at most 1; empty for a single weight
  std::vector<Place> place_;   // [slot]
  std::vector<std::vector<std::vector<Product>>> weights_;  // [term][channel][weight]
  std::vector<std::vector<std::vector<Product>>> lobes_;    // [term][channel][lobe]
};

// Returns whether the weights can be those of a dielectric under these constraints. This requires one
// specular weight that is divided by f0. The fixed and tied parameters must permit this weight to be 1 and
// the other weights to follow from f0.
bool can_be_dielectric(std::span<const Reflectance> forms, const Constraints& constraints);
// Returns whether the weights can only be those of a dielectric, because the specular weight is fixed at 1.
bool must_be_dielectric(std::span<const Reflectance> forms, const Constraints& constraints);

}  // namespace brdf::fit
