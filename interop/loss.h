// The loss of accuracy when a material is carried into a program's formula or into a table.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brdf/integrals.h"
#include "brdf/material.h"
#include "io/files/json.h"

namespace brdf::interop {

// Relative differences are divided by |f_r| + kDark, which keeps dark directions from dominating.
inline constexpr double kDark = 1e-3;  // 1/sr
// Returns |carried - wanted| / (|wanted| + kDark), or infinity if the quotient is not finite.
double relative_difference(double wanted, double carried);

// The largest relative difference found by a search over angles of at most 80 degrees from the normal. The
// true maximum is not smaller.
struct Largest {
  double difference = 0;
  double theta_i = 0, phi_i = 0, theta_o = 0, phi_o = 0;  // degrees, in the surface's frame
  double wanted = 0, carried = 0;                         // BRDF values there, 1/sr
  std::string channel{};

  // Azimuth between both directions, 0 to 180 degrees.
  double phi() const;
};

// The loss of a carried material compared with the wanted one.
struct Loss {
  double rms = 0;                       // RMS of ln(1 + f cos_i) - ln(1 + g cos_i), over the judged pairs
  double median = 0;                    // median relative difference, over the same pairs
  Largest largest{};                    // found by a search
  double albedo = 0, albedo_theta = 0;  // largest difference of directional albedos, and its angle in degrees
  std::size_t pairs = 0;                // pairs of directions from which the search for `largest` starts
  // The largest difference at some directions from 80 to 89.99 degrees. It is looked at only if the search up
  // to 80 degrees found nothing: other formulas of the same lobe differ near grazing.
  std::optional<Largest> beyond{};

  // Returns whether the search found no difference. This is no proof that the formulas are the same.
  bool none_found() const { return largest.difference < kNone; }
  static constexpr double kNone = 1e-9;
};

// Returns the BRDF values of every channel at these directions, indexed [channel][row].
std::vector<std::vector<double>> values_at(const Material& material, const Directions<double>& directions);

// Root mean square, median and largest difference. Median and largest are relative to the wanted values.
struct Figures {
  double rms = 0, median = 0, largest = 0;
};
// Returns the figures over these directions. The values are indexed [channel][row].
Figures figures_of(const std::vector<std::vector<double>>& wanted,
                   const std::vector<std::vector<double>>& carried, const Directions<double>& directions);

// Compares materials with a wanted material. The values of the wanted material are computed once.
class Comparison {
 public:
  explicit Comparison(Material wanted, const AlbedoOptions& albedos = {.tolerance = 1e-5});

  const Material& wanted() const { return wanted_; }
  // Returns the loss of `carried`, measured at pairs up to 80 degrees that no fit has used. Albedos are
  // compared at 0, 30, 60 and 75 degrees.
  Loss loss_of(const Material& carried) const;
  // Returns the loss of `carried` if `carried` has a lower rms than `best` and is_better() than `copy`
  // (below), otherwise std::nullopt. Expensive figures are computed only while the decision is open.
  std::optional<Loss> better_loss_of(const Material& carried, const Loss& best, const Loss& copy) const;

 private:
  void add_pairs(const Material& carried, Loss& loss) const;
  void add_albedos(const Material& carried, Loss& loss) const;
  // Searches the largest relative difference. The climbs start from the worst directions of a net: theta in
  // steps of 4 degrees up to 80 degrees, azimuths dense near the mirror direction, and the lobes sampled at
  // their own widths. For anisotropic materials the net has incidence along, across and between the axes.
  Largest largest_of(const Material& carried) const;
  // Returns the largest difference at directions of which one is 80 to 89.99 degrees from the normal.
  Largest largest_beyond(const Material& carried) const;

  Material wanted_;
  AlbedoOptions albedo_options_;
  DirectionArrays<double> pairs_, net_;
  std::vector<std::vector<double>> at_pairs_, at_net_;
  std::vector<std::vector<double>> albedos_;  // by angle, then by channel
};

// Compares the losses of two formulas: returns true if `one` has the lower rms and an acceptable median.
// Bright values at grazing incidence dominate the rms, whereas a picture shows all other directions. The
// median must therefore be at most 2 %, or at most twice the median of `other`.
bool is_nearer(const Loss& one, const Loss& other);

// Compares a refit with the copied parameters: returns true if the rms is lower and no other stated figure
// is worse.
bool is_better(const Loss& one, const Loss& other);

// Returns the sentence on a loss for which none_found() holds: "no difference above 1e-9 at 5000 pairs of
// directions up to 80 degrees from the normal, nor at some up to 89.99 degrees", or with the largest
// difference beyond 80 degrees.
std::string none_found_in_words(const Loss& loss);

// Returns the loss as text: "largest at least 2.1 % (theta_i 80, theta_o 76, phi 180, r), median 0.03 %,
// albedo within 0.002 (at 75), rms 0.0012".
std::string in_words(const Loss& loss);

// Returns the loss as JSON.
io::Json to_json(const Loss& loss);

}  // namespace brdf::interop
