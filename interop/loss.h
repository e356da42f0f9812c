// What a program's formula or a table loses of a material.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brdf/integrals.h"
#include "brdf/material.h"
#include "io/files/json.h"

namespace brdf::interop {

// Relative differences are of |f_r| + kDark, so that what is black anyway does not count.
inline constexpr double kDark = 1e-3;  // 1/sr
// Infinite where one of them is no number.
double relative_difference(double wanted, double carried);

// The largest relative difference that a search found, at most 80 degrees from the normal: the true one is no
// smaller.
struct Largest {
  double difference = 0;
  double theta_i = 0, phi_i = 0, theta_o = 0, phi_o = 0;  // degrees, in the surface's frame
  double wanted = 0, carried = 0;                         // f_r there, 1/sr
  std::string channel{};

  // In the half circle, from the light's azimuth.
  double phi() const;
};

struct Loss {
  double rms = 0;                       // of ln(1 + f cos_i) - ln(1 + g cos_i), over the judged pairs
  double median = 0;                    // relative difference, over the same pairs
  Largest largest{};                    // by a search
  double albedo = 0, albedo_theta = 0;  // largest difference of directional albedos, and its angle

  bool exact() const { return largest.difference < 1e-9; }
};

// f_r of every channel at these directions: [channel][row].
std::vector<std::vector<double>> values_at(const Material& material, const Directions<double>& directions);

// Relative to the wanted values; with the rms.
struct Figures {
  double rms = 0, median = 0, largest = 0;
};
Figures figures_of(const std::vector<std::vector<double>>& wanted,
                   const std::vector<std::vector<double>>& carried, const Directions<double>& directions);

// A material that others are compared with: its values are computed once.
class Comparison {
 public:
  explicit Comparison(Material wanted, const AlbedoOptions& albedos = {.tolerance = 1e-5});

  const Material& wanted() const { return wanted_; }
  // Of `carried`, on pairs up to 80 degrees that no fit has seen; albedos at 0, 30, 60 and 75 degrees.
  Loss loss_of(const Material& carried) const;
  // The same where it is a better one than both (below); the dear figures only as far as that is open.
  std::optional<Loss> better_loss_of(const Material& carried, const Loss& best, const Loss& copy) const;

 private:
  void add_pairs(const Material& carried, Loss& loss) const;
  void add_albedos(const Material& carried, Loss& loss) const;
  // Searched from a net of directions (theta in steps of 4 degrees to 80, azimuths close together at the
  // mirror direction, the lobes at their own widths; of anisotropic materials along, across and between their
  // axes) by climbs from its worst places.
  Largest largest_of(const Material& carried) const;

  Material wanted_;
  AlbedoOptions albedo_options_;
  DirectionArrays<double> pairs_, net_;
  std::vector<std::vector<double>> at_pairs_, at_net_;
  std::vector<std::vector<double>> albedos_;  // by angle, of each channel
};

// Of two formulas: what is bright at grazing light decides the rms, and a picture shows the others, so the
// median is at most 2 %, or twice the other's.
bool is_nearer(const Loss& one, const Loss& other);

// Of a refit and the copied parameters: a lower rms that is paid for with another stated figure is none.
bool is_better(const Loss& one, const Loss& other);

// "largest at least 2.1 % (theta_i 80, theta_o 76, phi 180, r), median 0.03 %, albedo within 0.002 (at 75),
// rms 0.0012".
std::string in_words(const Loss& loss);

io::Json to_json(const Loss& loss);

}  // namespace brdf::interop
