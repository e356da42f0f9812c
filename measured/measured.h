// Measured samples as a reflectance: what was measured, filled in between, and where it was not measured it
// says so.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/samples/samples.h"
#include "measured/coordinates.h"
#include "measured/field.h"

namespace brdf::measured {

// What is known of one pair of directions.
struct Seen {
  std::vector<double> f;  // per channel, f_r in 1/sr
  double known = 0;       // [0, 1]: the share of the ratio's variance that the samples near by leave known
  bool measured = false;  // known to kLeastKnown or more, and within the polar angles that were scanned
};

// Measured over fitted at a place, per channel, and how well that is known.
struct Ratio {
  std::vector<double> of;
  double known = 0;
};

// Below this the samples are too far away to say what is there.
constexpr double kLeastKnown = 0.7;

// f_r of a table's channels at any pair of directions: the fitted material's value times the ratio
// measured/fitted, whose logarithm is interpolated (by the ratio itself where a sample near by is 0 or
// below). The ratio is taken as the same for light and viewer exchanged, and as isotropic unless the samples
// were turned (several azimuths of the light) and are likelier so. It is a Gaussian process about 1 in
// half-vector coordinates (coordinates.h, field.h): lengths and noise are the likeliest, the noise not below
// the sheet's (io/samples/noise.h). Away from all samples the ratio goes to 1, so the fitted value remains,
// and `measured` is false. Channels without a counterpart in the material (of the same name, or the same
// colour; a material of one channel serves all) or with a black one, and all where there is none, are
// interpolated about their geometric mean instead: slowly where f_r is not smooth. Domain: unit vectors; 0
// below the horizon.
class MeasuredReflectance final : public ReflectanceModel {
 public:
  // Beside the fitted material; or beside it or without it, as the samples are likelier: a material that has
  // little to do with them is no help.
  enum class Beside { fit, likeliest };
  // Throws InputError where the table has no row above the horizon with a value.
  explicit MeasuredReflectance(const io::SampleTable& table, const Material* fitted = nullptr,
                               Beside beside = Beside::fit);

  const ReflectanceInfo& info() const override { return info_; }
  void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override;
  using ReflectanceModel::eval;

  Seen at(const Vec3<double>& wi, const Vec3<double>& wo) const;
  // at() where it is `measured`; found out first, so that other pairs cost little.
  std::optional<Seen> measured_at(const Vec3<double>& wi, const Vec3<double>& wo) const;
  // The same in steps: where a pair is, the ratio there, and what that makes of the pair.
  Place place(const Vec3<double>& wi, const Vec3<double>& wo) const {
    return place_of(wi, wo, chosen_.turning, chosen_.core);
  }
  Ratio ratio_at(const Place& place) const;
  Seen seen(const Vec3<double>& wi, const Vec3<double>& wo, const Ratio& ratio) const;

  const std::vector<std::string>& channels() const { return channels_; }
  // How the ratio varies, and whether azimuths are told apart.
  const Variation& variation() const { return chosen_.variation; }
  Turning turning() const { return chosen_.turning; }
  double core() const { return chosen_.core; }
  // The largest polar angles that were scanned: the smaller one of a pair is within `inner`, the larger
  // within `outer`.
  struct Range {
    double inner = 0, outer = 0;  // degrees
  };
  const Range& range() const { return range_; }

 private:
  // Rows that can be used, and measured over fitted in [channel][row].
  struct Rows {
    std::vector<Vec3<double>> wi, wo;
    std::vector<std::vector<double>> ratios;
    bool turned = false;  // light and half vector come from several azimuths
  };
  Rows usable_rows(const io::SampleTable& table);
  void leave_black_channels(const Directions<double>& d);
  struct Choice {
    Variation variation;
    Turning turning = Turning::isotropic;
    double core = 0.1;
  };
  Choice likeliest(const Rows& rows, double noise) const;
  void keep(const Rows& rows);
  Ratio ratio_of(const Field::Weights& weights) const;
  bool scanned(const Vec3<double>& wi, const Vec3<double>& wo) const;
  void fitted_values(const Vec3<double>& wi, const Vec3<double>& wo, std::vector<double>& out) const;

  std::vector<std::string> channels_;
  ReflectanceInfo info_;
  std::optional<Material> fitted_;
  std::vector<int> counterpart_;                    // of each channel, in the fitted material; -1: none
  std::vector<double> level_;                       // of each channel without one
  std::vector<std::vector<double>> logs_, ratios_;  // [channel][place]
  Choice chosen_;
  Range range_;
  std::unique_ptr<const Field> field_;
};

// The same as a material: a term without parameters, for whoever takes materials.
Material material_of(std::shared_ptr<const MeasuredReflectance> measured);

}  // namespace brdf::measured
