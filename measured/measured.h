// Measured samples as a reflectance. Values are interpolated between measured directions; directions
// without samples nearby are marked.
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

// The value at one pair of directions, and how well it is known.
struct Seen {
  std::vector<double> f;  // per channel, f_r in 1/sr
  double known = 0;       // [0, 1]: the share of the ratio's variance that nearby samples explain
  bool measured = false;  // `known` is at least kLeastKnown, and the polar angles were scanned
};

// The ratio of measured to fitted values at a place, per channel, and how well the ratio is known.
struct Ratio {
  std::vector<double> of;
  double known = 0;
};

// If less is known, the samples are too far away to determine the value.
constexpr double kLeastKnown = 0.7;

// f_r of the channels of a table at any pair of directions. The value is that of the fitted material times
// the ratio measured/fitted. The logarithm of the ratio is interpolated, or the ratio itself if a sample
// nearby is 0 or negative. The ratio is a Gaussian process about 1 in half-vector coordinates
// (coordinates.h, field.h). Its lengths and noise have the highest likelihood; the noise is at least the
// noise of the table (io/samples/noise.h).
//
// The ratio is assumed to be reciprocal. It is assumed to be isotropic unless the sample was rotated
// (several azimuths of incidence) and the anisotropic ratio has the higher likelihood. Far from all samples
// the ratio tends to 1, so the fitted value remains, and `measured` is false.
//
// A channel has a counterpart in the material if a channel there has the same name or the same colour; a
// material with one channel serves all. Channels without a counterpart, or with a black counterpart, are
// interpolated about their geometric mean instead; so are all channels without a material. With more
// samples this converges slowly if f_r is not smooth. Domain: unit vectors; 0 below the horizon.
class MeasuredReflectance final : public ReflectanceModel {
 public:
  // fit: interpolate the ratio of the samples to the fitted material. likeliest: with or without the
  // material, whichever gives the samples the higher likelihood; a material that hardly resembles the
  // samples does not help.
  enum class Beside { fit, likeliest };
  // Throws InputError if the table has no row above the horizon with a value.
  explicit MeasuredReflectance(const io::SampleTable& table, const Material* fitted = nullptr,
                               Beside beside = Beside::fit);

  const ReflectanceInfo& info() const override { return info_; }
  void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override;
  using ReflectanceModel::eval;

  // Returns the value at a pair of directions, and how well it is known.
  Seen at(const Vec3<double>& wi, const Vec3<double>& wo) const;
  // Returns at() if the pair is `measured`, otherwise std::nullopt. This is decided first, so other pairs
  // cost little.
  std::optional<Seen> measured_at(const Vec3<double>& wi, const Vec3<double>& wo) const;
  // The steps of at(): the place of a pair, the ratio at the place, and the resulting value.
  Place place(const Vec3<double>& wi, const Vec3<double>& wo) const {
    return place_of(wi, wo, chosen_.turning, chosen_.core);
  }
  Ratio ratio_at(const Place& place) const;
  Seen seen(const Vec3<double>& wi, const Vec3<double>& wo, const Ratio& ratio) const;

  const std::vector<std::string>& channels() const { return channels_; }
  // The relative standard deviation of the table's noise (io/samples/noise.h), which the values do not have
  // because they are smoothed; std::nullopt if it is not known.
  const std::optional<double>& scatter() const { return scatter_; }
  // The variation of the ratio, and whether azimuths of the sample are distinguished.
  const Variation& variation() const { return chosen_.variation; }
  Turning turning() const { return chosen_.turning; }
  double core() const { return chosen_.core; }
  // The largest polar angles that were scanned. The smaller angle of a pair is at most `inner`, and the
  // larger angle is at most `outer`.
  struct Range {
    double inner = 0, outer = 0;  // degrees
  };
  const Range& range() const { return range_; }

 private:
  // The rows that can be used, with the ratios measured/fitted as [channel][row].
  struct Rows {
    std::vector<Vec3<double>> wi, wo;
    std::vector<std::vector<double>> ratios;
    bool turned = false;  // incidence and half vector have several azimuths
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
  std::optional<double> scatter_;
  ReflectanceInfo info_;
  std::optional<Material> fitted_;
  std::vector<int> counterpart_;                    // of each channel, in the fitted material; -1: without
  std::vector<double> level_;                       // of each channel without a counterpart
  std::vector<std::vector<double>> logs_, ratios_;  // [channel][place]
  Choice chosen_;
  Range range_;
  std::unique_ptr<const Field> field_;
};

// Returns the reflectance as a material: a term without parameters.
// Example:
//     // #include "brdf/io/formats/read.h"
//     using namespace brdf;
//     const auto paint = std::make_shared<measured::MeasuredReflectance>(io::read_samples("paint.csv"));
//     const auto seen = paint->measured_at(direction(20_deg, 0_deg), direction(25_deg, 180_deg));
//     if (seen) std::printf("%g 1/sr\n", seen->f.front());
//     const Material material = material_of(paint);
Material material_of(std::shared_ptr<const MeasuredReflectance> measured);

}  // namespace brdf::measured
