// The search for a target's parameters that are nearer than the copied ones and worse in no stated figure.
#pragma once

#include "interop/project.h"
#include "io/samples/samples.h"

namespace brdf::interop {

// Whether the term's weights are above 1 together where the program mixes shaders.
bool exceeds(const Term& of_target, const TargetRules& rules);

class Refit {
 public:
  // `table` has the wanted values at the fitted pairs. A copy whose weights the program cannot hold together
  // limits nothing.
  Refit(const Comparison& wanted, const TargetRules& rules, const io::SampleTable& table,
        const Material& copy, const Loss& of_copy);

  // Tries these parameters, and some between them and the copy: what is a little nearer is seldom worse in
  // anything.
  void between(const Material& fitted);
  // Climbs from the best so far, and from half of the way to what was fitted, with the copy's figures at the
  // fitted pairs as limits; tighter ones where the judged pairs or the search for the largest difference do
  // not agree.
  void polish();

  bool improved() const { return improved_; }
  const Material& best() const { return best_; }

 private:
  Figures at_fitted_pairs(const Material& of_target) const;
  bool consider(const Material& candidate);
  // By the objective and the share of the limits that it keeps to.
  bool climb_from(Material candidate, const Figures& limits, double share);

  const Comparison& wanted_;
  const TargetRules& rules_;
  const io::SampleTable& table_;
  DirectionArrays<double> directions_;
  const Material copy_;
  Loss of_copy_;
  Material best_;
  Loss loss_;
  bool copy_holds_ = true, improved_ = false;
  std::vector<Material> fitted_;
};

}  // namespace brdf::interop
