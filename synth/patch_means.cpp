#include "synth/patch_means.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <queue>

#include "brdf/quadrature.h"
#include "io/formats/klems_bases.h"
#include "io/samples/degrees.h"
#include "synth/patch_symmetry.h"

namespace brdf::synth {
namespace {

using io::klems::Patch;

constexpr std::size_t kNodes = 3;   // per dimension
constexpr double kSmallest = 1e-6;  // 1/sr: values below count as this when errors become relative

double degrees_of_square(double u) {
  return radians(std::asin(std::sqrt(std::clamp(u, 0.0, 1.0)))).degrees();
}

// The distance of an interval from 0, or from the next multiple of 360.
double gap(double low, double high) {
  const double shift = 360 * std::round((low + high) / 720);
  low -= shift;
  high -= shift;
  return low > 0 ? low : high < 0 ? -high : 0;
}

// Lower and upper bounds of sin^2 of both polar angles, and of both azimuths in degrees.
using Box = std::array<std::array<double, 2>, 4>;
constexpr std::size_t kLightU = 0, kViewerU = 1, kViewerPhi = 2, kLightPhi = 3;

// The half widths at half maximum of a lobe, in degrees: in the direction in which the lobe is narrowest, and
// in the direction in which it is widest. Infinite and 0 if there is no lobe.
struct Widths {
  double narrow = std::numeric_limits<double>::infinity(), wide = 0;
};

// The widths of the lobe around the mirror direction (or the light), by polar angle.
class Lobe {
 public:
  Lobe(const Material& material, bool is_mirror, bool is_isotropic) {
    for (std::size_t k = 0; k < kAngles; ++k)
      for (const double phi : {0.0, 45.0, 90.0}) {
        if (phi > 0 && is_isotropic) continue;
        const Widths one = widths_at(material, kStep * double(k), phi, is_mirror);
        widths_[k].narrow = std::min(widths_[k].narrow, one.narrow);
        widths_[k].wide = std::max(widths_[k].wide, one.wide);
      }
  }
  // Returns the widths at the polar angles next to `theta`.
  Widths at(double theta) const {
    const auto k = std::min(static_cast<std::size_t>(theta / kStep), kAngles - 1);
    const Widths &below = widths_[k], &above = widths_[std::min(k + 1, kAngles - 1)];
    return {std::min(below.narrow, above.narrow), std::max(below.wide, above.wide)};
  }

 private:
  static constexpr double kStep = 5;  // degrees
  static constexpr std::size_t kAngles = 18;

  static Widths widths_at(const Material& material, double theta, double phi, bool is_mirror) {
    constexpr double kNarrowest = 0.005, kWidest = 12;  // degrees
    std::vector<double> peak(material.channels.size()), f(peak.size());
    const double viewer_phi = phi + (is_mirror ? 180 : 0);
    const Vec3<double> light = io::unit_vector(theta, phi);
    eval(material, light, io::unit_vector(theta, viewer_phi), peak);
    Widths widths;
    for (double d = kNarrowest; d < kWidest; d *= 1.5) {
      const double turn = theta > d ? d / io::sin_degrees(theta) : 180;
      const Vec3<double> aside[] = {io::unit_vector(theta + d < 90 ? theta + d : theta - d, viewer_phi),
                                    io::unit_vector(theta > 0 ? theta : d, viewer_phi + turn)};
      bool all = true;
      for (const Vec3<double>& viewer : aside) {
        eval(material, light, viewer, f);
        for (std::size_t c = 0; c < f.size(); ++c) {
          if (f[c] < peak[c] / 2)
            widths.narrow = std::min(widths.narrow, d);
          else
            all = false;
        }
      }
      widths.wide = d;
      if (all) return widths;
    }
    return widths.narrow < kWidest ? widths : Widths{};
  }

  std::array<Widths, kAngles> widths_;
};

struct Mean {
  std::vector<double> of;  // channels
  double error = 0;        // relative, estimated
  bool is_resolved = true;
};

// Integrates one pair of patches.
class PairIntegral {
 public:
  PairIntegral(const Material& material, const Lobe& mirror, const Lobe& backward, bool is_turnable)
      : material_(material), mirror_(mirror), backward_(backward), dimensions_(is_turnable ? 3 : 4) {}

  Mean mean(const Patch& light, const Patch& viewer) {
    light_ = light;
    viewer_ = viewer;
    total_.assign(material_.channels.size(), 0.0);
    std::vector<Cell> first;
    const bool is_lobe_resolved = divide_to_lobe(pieces(), first);
    scale_ = total_;
    for (double& scale : scale_) scale = std::max(std::abs(scale), kSmallest);
    // The errors are known only now that the sizes of the values are known.
    std::priority_queue<Examined> cells;
    double error = 0;
    for (const Cell& cell : first) {
      Examined one = examined(cell);
      error += one.error;
      cells.push(std::move(one));
    }
    while (error > kPatchTolerance && cells.size() < most_cells()) {
      const Examined worst = cells.top();
      cells.pop();
      add(worst.correction, -1);
      error -= worst.error;
      // The halves replace the cell in the total.
      add(worst.of.integral, -1);
      for (const Cell& half : worst.halves) {
        add(half.integral, 1);
        Examined one = examined(half);
        error += one.error;
        cells.push(std::move(one));
      }
    }
    return {total_, std::max(error, 0.0), is_lobe_resolved && error <= kPatchTolerance};
  }

 private:
  struct Cell {
    Box box;
    std::vector<double> integral;  // of the channels; the integral over all cells is the mean
  };
  // A cell with the changes of its integral by halving it in each dimension. Their sum corrects the integral.
  struct Examined {
    Cell of;
    std::array<Cell, 2> halves;  // in the dimension of the largest change
    std::vector<double> correction;
    double error = 0;  // sum of the changes of all dimensions, relative to the mean
    bool operator<(const Examined& other) const { return error < other.error; }
  };

  // The azimuths are cut where the density of their differences has a kink, and at both planes of symmetry.
  std::vector<Box> pieces() const {
    const auto square = [](double theta) {
      const double s = io::sin_degrees(theta);
      return s * s;
    };
    Box box;
    box[kLightU] = {square(light_.lower), square(light_.upper)};
    box[kViewerU] = {square(viewer_.lower), square(viewer_.upper)};
    const double a = light_.width / 2, b = viewer_.width / 2;
    if (dimensions_ == 4) {
      box[kLightPhi] = {light_.phi + 180 - a, light_.phi + 180 + a};
      box[kViewerPhi] = {viewer_.phi - b, viewer_.phi + b};
      return {box};
    }
    box[kLightPhi] = {0, 0};
    const double centre = centre_of_difference();
    std::vector<double> cuts{centre - a - b, centre - std::abs(a - b), centre + std::abs(a - b),
                             centre + a + b};
    for (const double plane : {-360.0, -180.0, 0.0, 180.0, 360.0, 540.0})
      if (plane > cuts.front() && plane < centre + a + b) cuts.push_back(plane);
    std::ranges::sort(cuts);
    std::vector<Box> boxes;
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      constexpr double kNothing = 1e-9;  // degrees
      if (cuts[k] - cuts[k - 1] < kNothing) continue;
      box[kViewerPhi] = {cuts[k - 1], cuts[k]};
      boxes.push_back(box);
    }
    return boxes;
  }

  double centre_of_difference() const { return viewer_.phi - (light_.phi + 180); }

  // Returns the density of a place with respect to the box's coordinates, relative to the mean over both
  // patches.
  double density(double difference) const {
    const double light = light_.width, viewer = viewer_.width;
    if (dimensions_ == 4) return 1 / (light * viewer);
    const double distance = std::abs(difference - centre_of_difference());
    const double overlap = std::min({(light + viewer) / 2 - distance, light, viewer});
    return std::max(overlap, 0.0) / (light * viewer);
  }

  // Halves the cells around the lobes until they are as narrow as the lobe. Returns false if they became too
  // many. All cells of a size are halved before smaller ones.
  bool divide_to_lobe(std::vector<Box> boxes, std::vector<Cell>& first) {
    bool is_resolved = true;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const Box box = boxes[k];
      const std::size_t widest = dimension_to_halve(box);
      const bool is_full = boxes.size() > most_cells();
      if (widest == dimensions_ || is_full) {
        is_resolved = is_resolved && widest == dimensions_;
        first.push_back(cell_of(box));
        add(first.back().integral, 1);
        continue;
      }
      const auto [low, high] = cut(box, widest);
      boxes.push_back(low);
      boxes.push_back(high);
    }
    return is_resolved;
  }

  // Four dimensions need many cells for a narrow lobe, and time is limited.
  std::size_t most_cells() const { return dimensions_ == 3 ? 100'000 : 3000; }

  static std::pair<Box, Box> cut(const Box& box, std::size_t dimension) {
    std::pair<Box, Box> halves{box, box};
    const double middle = (box[dimension][0] + box[dimension][1]) / 2;
    halves.first[dimension][1] = middle;
    halves.second[dimension][0] = middle;
    return halves;
  }

  // Returns the dimension in which the cell is to be halved because of a lobe, or dimensions_.
  std::size_t dimension_to_halve(const Box& box) const {
    const double light[] = {degrees_of_square(box[kLightU][0]), degrees_of_square(box[kLightU][1])};
    const double viewer[] = {degrees_of_square(box[kViewerU][0]), degrees_of_square(box[kViewerU][1])};
    const double across = io::sin_degrees(std::max(light[1], viewer[1]));
    const double sizes[] = {light[1] - light[0], viewer[1] - viewer[0],
                            (box[kViewerPhi][1] - box[kViewerPhi][0]) * across,
                            (box[kLightPhi][1] - box[kLightPhi][0]) * across};
    const std::size_t widest = static_cast<std::size_t>(std::max_element(sizes, sizes + dimensions_) - sizes);
    const double apart_in_theta = std::max({light[0] - viewer[1], viewer[0] - light[1], 0.0});
    const double low = box[kViewerPhi][0] - box[kLightPhi][1], high = box[kViewerPhi][1] - box[kLightPhi][0];
    const double nearest = io::sin_degrees(std::min(light[0], viewer[0]));
    const auto is_at = [&](const Lobe& lobe, double turn) {
      const Widths widths = lobe.at((light[0] + light[1]) / 2);
      constexpr double kReach = 3;  // widths
      const auto is_within = [&](double width) {
        return sizes[widest] > width && apart_in_theta < kReach * width &&
               gap(low - turn, high - turn) * nearest < kReach * width;
      };
      return is_within(widths.narrow) || is_within(widths.wide);
    };
    return is_at(mirror_, 180) || is_at(backward_, 0) ? widest : dimensions_;
  }

  // Computes f_r of all channels at the first `count` nodes.
  void evaluate(std::size_t count) {
    values_.assign(total_.size() * kMostNodes, 0.0);
    std::array<double, kMostNodes> one;
    for (std::size_t c = 0; c < total_.size(); ++c)
      for (const Term& term : material_.terms) {
        eval_batch(term, c, nodes_.view().part(0, count), one.data());
        for (std::size_t k = 0; k < count; ++k) values_[c * kMostNodes + k] += one[k];
      }
  }

  // Computes the integral over a box with the product of Gauss rules.
  Cell cell_of(const Box& box) {
    const quadrature::GaussRule& rule = quadrature::gauss_legendre(int(kNodes));
    const std::size_t channels = total_.size();
    std::size_t count = 1;
    for (std::size_t d = 0; d < dimensions_; ++d) count *= kNodes;
    weights_.resize(count);
    double volume = 1 / (extent_of(light_) * extent_of(viewer_));
    for (std::size_t d = 0; d < dimensions_; ++d) volume *= box[d][1] - box[d][0];
    for (std::size_t k = 0; k < count; ++k) {
      std::array<double, 4> at{0, 0, 0, box[kLightPhi][0]};
      double weight = volume;
      for (std::size_t d = 0, rest = k; d < dimensions_; ++d, rest /= kNodes) {
        at[d] = box[d][0] + (box[d][1] - box[d][0]) * rule.node[rest % kNodes];
        weight *= rule.weight[rest % kNodes];
      }
      weights_[k] = weight * density(at[kViewerPhi] - at[kLightPhi]);
      nodes_.set(k, vector_of(at[kLightU], at[kLightPhi]), vector_of(at[kViewerU], at[kViewerPhi]));
    }
    evaluate(count);
    Cell cell{box, std::vector<double>(channels, 0.0)};
    for (std::size_t c = 0; c < channels; ++c)
      for (std::size_t k = 0; k < count; ++k) cell.integral[c] += weights_[k] * values_[c * kMostNodes + k];
    return cell;
  }

  static double extent_of(const Patch& patch) {
    const double low = io::sin_degrees(patch.lower), high = io::sin_degrees(patch.upper);
    return high * high - low * low;
  }

  static Vec3<double> vector_of(double u, double phi) {
    const double s = std::sqrt(u);
    return {s * io::cos_degrees(phi), s * io::sin_degrees(phi), std::sqrt(1 - u)};
  }

  void add(const std::vector<double>& integral, double times) {
    for (std::size_t c = 0; c < total_.size(); ++c) total_[c] += times * integral[c];
  }

  // Halves a cell in each dimension, and adds the changes of its integral to the total. Halving in a single
  // dimension would miss a highlight that lies between the nodes of another.
  Examined examined(Cell cell) {
    Examined out;
    out.correction.assign(total_.size(), 0.0);
    double most = -1;
    for (std::size_t d = 0; d < dimensions_; ++d) {
      const auto [low, high] = cut(cell.box, d);
      std::array<Cell, 2> halves{cell_of(low), cell_of(high)};
      double error = 0;
      for (std::size_t c = 0; c < total_.size(); ++c) {
        const double change = halves[0].integral[c] + halves[1].integral[c] - cell.integral[c];
        out.correction[c] += change;
        error = std::max(error, std::abs(change) / scale_[c]);
      }
      out.error += error;
      if (error > most) most = error, out.halves = std::move(halves);
    }
    add(out.correction, 1);
    out.of = std::move(cell);
    return out;
  }

  const Material& material_;
  const Lobe &mirror_, &backward_;
  const std::size_t dimensions_;
  Patch light_{}, viewer_{};
  std::vector<double> total_, scale_;
  static constexpr std::size_t kMostNodes = 81;
  DirectionArrays<double> nodes_{kMostNodes};
  std::vector<double> values_, weights_;  // of the nodes of a cell; values by channel
};

}  // namespace

PatchMeans patch_means(const Material& material, const io::Progress& progress) {
  const std::vector<Patch> patches = io::klems::patches_of(io::klems::known_bases().front().rings);
  const PatchSymmetry symmetry = symmetry_of(material);
  const Lobe mirror(material, true, symmetry.turn), backward(material, false, symmetry.turn);
  std::vector<std::pair<std::size_t, std::size_t>> jobs;  // light, viewer
  std::map<PatchSymmetry::Class, std::size_t> known;
  std::vector<std::size_t> job_of;
  for (std::size_t light = 0; light < patches.size(); ++light)
    for (std::size_t viewer = 0; viewer < patches.size(); ++viewer) {
      const std::size_t job =
          known.emplace(symmetry.class_of(patches[light], patches[viewer]), jobs.size()).first->second;
      if (job == jobs.size()) jobs.emplace_back(light, viewer);
      job_of.push_back(job);
    }
  std::vector<Mean> means(jobs.size());
  std::mutex mutex;
  int done = 0;
  io::parallel_for(jobs.size(), [&](std::size_t k) {
    means[k] = PairIntegral(material, mirror, backward, symmetry.turn)
                   .mean(patches[jobs[k].first], patches[jobs[k].second]);
    const std::lock_guard lock(mutex);
    if (progress) progress(++done, int(jobs.size()));
  });
  PatchMeans result;
  result.table.set_channels(material.channels);
  for (std::size_t light = 0; light < patches.size(); ++light)
    for (std::size_t viewer = 0; viewer < patches.size(); ++viewer) {
      const Mean& mean = means[job_of[light * patches.size() + viewer]];
      result.table.add_directions(patches[light].theta, io::within_turn(patches[light].phi + 180),
                                  patches[viewer].theta, patches[viewer].phi);
      for (std::size_t c = 0; c < mean.of.size(); ++c) result.table.values[c].push_back(mean.of[c]);
      if (mean.is_resolved) result.error = std::max(result.error, mean.error);
      result.unresolved += !mean.is_resolved;
    }
  return result;
}

}  // namespace brdf::synth
