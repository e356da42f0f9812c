// Searches parameters of a target that are nearer than the copied ones and not worse in any stated figure.
#pragma once

#include "interop/project.h"
#include "io/samples/samples.h"

namespace brdf::interop {

// Returns true if the program mixes shaders and the term's weights add up to more than 1.
bool exceeds(const Term& of_target, const TargetRules& rules);

// The search, which keeps the best parameters found so far.
class Refit {
 public:
  // `table` has the wanted values at the fitted pairs. If the program cannot hold the weights of the copy
  // together, the figures of the copy do not limit the search.
  Refit(const Comparison& wanted, const TargetRules& rules, const io::SampleTable& table,
        const Material& copy, const Loss& of_copy);

  // Tries these parameters and some points between them and the copy: slightly nearer parameters are seldom
  // worse in any figure.
  void between(const Material& fitted);
  // Climbs from the best parameters so far, and from the midpoint between the copy and the fitted
  // parameters. The figures of the copy at the fitted pairs are limits. The limits are tightened if the
  // judged pairs or the search for the largest difference do not confirm the result.
  void polish();

  bool improved() const { return improved_; }
  const Material& best() const { return best_; }

 private:
  Figures at_fitted_pairs(const Material& of_target) const;
  bool consider(const Material& candidate);
  // Climbs by the objective; `share` is the fraction of the limits that the climb must keep.
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
