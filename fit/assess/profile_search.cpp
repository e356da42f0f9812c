#include "fit/assess/profile_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/solve/starts.h"

namespace brdf::fit {
namespace {

constexpr double kOnLevel = 0.02;   // of the root of the rise
constexpr double kParabola = 0.15;  // tolerance within which the root of the rise follows the parabola
// Times the distance of an end: five standard errors if the profile is a parabola.
constexpr double kFar = 2.5;
constexpr double kClosed = 2.25;  // times the root of the level, which a profile must reach beyond an end
// Times the distance of an end. A profile that is still low at this distance has stopped rising.
constexpr double kPlateau = 5;
constexpr int kEdgeHalvings = 10;      // of the interval in which a plateau ends
constexpr double kJump = 1e-3;         // relative length within which a false crossing (a jump) is detected
constexpr double kFactor = 3;          // ratio of weights above which their logarithms are compared
constexpr double kLeastWeight = 1e-9;  // relative to the larger of two weights, for the other's logarithm
constexpr double kSlowest = 0.5;       // relative to the rate of the parabola, beyond the level
// Times the distance of the end. A limit closer than this gives no information on the rate.
constexpr double kNearLimit = 1.2;
constexpr int kPoints = 40;            // of one side
constexpr int kRounds = 4;             // of the search for an end further out
constexpr std::size_t kBestSeeds = 3;  // of the shapes of the grid
constexpr double kStepBeyond = 0.1;    // step beyond an end, relative to its distance

class ProfileSearch {
 public:
  ProfileSearch(const ProfileStart& start, const Reported& r, std::size_t index, ProfileLevel level)
      : start_(start),
        model_(start.stream.model()),
        coordinate_(model_, r, index),
        solver_(start.stream, start.minimum, coordinate_, level.rise, start.interrupted),
        level_(level.rise),
        plateau_level_(std::max(level.rise, level.of_lobes)),
        error_(level.error),
        weight_(r.weight && !r.divided),
        may_vanish_(r.info->role == Role::specular) {
    const auto [x, gradient] = coordinate_.with_gradient(start.minimum.p);
    origin_ = x;
    const Eigen::VectorXd along = start.curvature.inverse * gradient;
    const double own = gradient.dot(along);
    follows_ = own > 0 ? Eigen::VectorXd(along / own) : Eigen::VectorXd::Zero(along.size());
  }

  ProfileSides run() {
    ProfileSides out;
    out.low = find(-1);
    out.high = find(1);
    out.quadratic = quadratic_;
    out.near = std::move(near_);
    return out;
  }

  void extend(std::span<const CostedPoint> known, ProfileSides& sides) {
    extend(-1, known, sides.low);
    extend(1, known, sides.high);
    std::move(near_.begin(), near_.end(), std::back_inserter(sides.near));
  }

 private:
  double pace(const ProfilePoint& point) const { return std::sqrt(std::max(point.rise, 0.0) / level_); }
  double distance(double x) const { return std::abs(x - origin_); }
  bool stopped() const { return start_.interrupted && start_.interrupted->load(std::memory_order_relaxed); }

  ProfilePoint solve_at(double x, std::vector<double> p, bool hold_shapes = false) {
    ProfilePoint best = solver_.least_at(x, std::move(p), hold_shapes);
    if (best.rise < square(kClosed) * plateau_level_) near_.push_back({best.p, best.rise});
    return best;
  }

  // Returns a start on the path so far: straight on from the minimum, or between the points on either side.
  std::vector<double> way_to(double x) const {
    std::vector<double> p = start_.minimum.p;
    if (inside_ && outside_) {
      const double share = (x - inside_->x) / (outside_->x - inside_->x);
      for (std::size_t k = 0; k < p.size(); ++k)
        p[k] = inside_->p[k] + share * (outside_->p[k] - inside_->p[k]);
    } else if (inside_ && inside_->x != origin_) {
      const double stretch = std::min((x - origin_) / (inside_->x - origin_), 2.0);
      for (std::size_t k = 0; k < p.size(); ++k) p[k] += stretch * (inside_->p[k] - p[k]);
    } else {
      for (std::size_t k = 0; k < p.size(); ++k) p[k] += follows_(Eigen::Index(k)) * (x - origin_);
    }
    return p;
  }

  ProfilePoint at(double x) { return solve_at(x, way_to(x)); }

  // Searches from the inside for the crossing with the level. The end is open at the limit, and if no
  // crossing is found. If the profile jumps over the level, the end is the point beyond the jump.
  ProfileEnd cross(double guess) {
    for (int k = 0; k < kPoints && !stopped(); ++k) {
      const double x = is_beyond(guess, limit_) ? limit_ : guess;
      ProfilePoint point = at(x);
      const double reached = pace(point);
      if (k == 0 && !outside_ && std::abs(reached - 1) > kParabola) quadratic_ = false;
      const bool at_limit = x == limit_;
      if (reached < 1 && at_limit) return {std::move(point), true, true};
      if (std::abs(reached - 1) <= kOnLevel) return {std::move(point), false, false};
      if (reached >= 1)
        outside_ = std::move(point);
      else if (!inside_ || is_beyond(point.x, inside_->x))
        inside_ = std::move(point);
      if (!outside_) {
        const double stretch = std::clamp(1.05 / std::max(pace(*inside_), 1e-3), 1.25, 4.0);
        guess = origin_ + stretch * std::max(distance(inside_->x), distance(x)) * side_;
        continue;
      }
      const double from = inside_ ? inside_->x : origin_, reach = outside_->x - from;
      const double size = logarithmic(from, outside_->x) ? std::abs(outside_->x) : distance(outside_->x);
      if (std::abs(reach) <= kJump * size) return {*outside_, false, false};
      const double below = 1 - (inside_ ? pace(*inside_) : 0), above = pace(*outside_) - 1;
      const double share = k % 3 == 2 ? 0.5 : below / (below + above);
      guess = between(from, outside_->x, std::clamp(share, 0.02, 0.98));
    }
    return {inside_ ? *inside_ : ProfilePoint{origin_, 0, start_.minimum.p}, true, false};
  }

  // Weights can differ by powers of ten along a valley.
  bool logarithmic(double a, double b) const {
    return weight_ && std::min(a, b) >= 0 && std::max(a, b) > kFactor * std::min(a, b);
  }
  double between(double a, double b, double share) const {
    if (!logarithmic(a, b)) return a + share * (b - a);
    const double least = kLeastWeight * std::max(a, b), from = std::max(a, least), to = std::max(b, least);
    return from * std::pow(to / from, share);
  }

  bool is_beyond(double x, double y) const { return side_ * (x - y) >= 0; }

  // Returns the edge of a plateau, between a point on the plateau and one above it.
  ProfilePoint edge_of_plateau() {
    for (int k = 0; k < kEdgeHalvings && !stopped(); ++k) {
      ProfilePoint point = at(between(inside_->x, outside_->x, 0.5));
      (pace(point) < kClosed ? inside_ : outside_) = std::move(point);
    }
    return *inside_;
  }

  // Checks whether the profile keeps rising beyond a crossing. If the profile bends, the end moves out
  // until no point is further from the minimum, in units of the end's distance, than the root of its rise.
  // If the profile stops rising, the end moves to the edge of the plateau. If the profile falls below the
  // level again, that point is taken as inside.
  void look_beyond(ProfileEnd& end, bool& fell) {
    const double reach = distance(end.at.x);
    double farthest = reach;
    inside_ = end.at;
    for (double stretch = kFar; !stopped(); stretch *= 2) {
      const double asked = origin_ + side_ * stretch * reach, x = is_beyond(asked, limit_) ? limit_ : asked;
      const double ratio = distance(x) / std::max(reach, 1e-300);
      if (ratio < kNearLimit) {
        end.limit_is_near = true;
        return;
      }
      outside_.reset();
      ProfilePoint point = at(x);
      const double reached = pace(point);
      if (stretch == kFar && std::abs(reached / ratio - 1) > kParabola) quadratic_ = false;
      end.limit_is_near = x == limit_ && reached < kClosed;
      if (reached < 1 - kOnLevel) {
        inside_ = std::move(point);
        fell = true;
        return;
      }
      farthest = std::max(farthest, distance(point.x) / reached);
      const bool closed = reached >= kClosed;
      if (closed && stretch > kPlateau) {
        outside_ = std::move(point);
        end.at = edge_of_plateau();
        return;
      }
      if (closed || (x == limit_ && !may_vanish_ && reached >= 1 + kSlowest * (ratio - 1))) {
        if (farthest < (1 + kStepBeyond) * reach) return;
        outside_ = std::move(point);
        inside_ = end.at;
        end.at = at(origin_ + side_ * farthest);
        return;
      }
      inside_ = std::move(point);
      if (x != limit_) continue;
      end.open = true;
      end.at = std::move(*inside_);
      return;
    }
  }

  // Returns the least cost at x from starts that are not on the path so far.
  std::optional<ProfilePoint> elsewhere(double x) {
    std::vector<ProfilePoint> seeds;
    const auto add = [&](std::vector<double> p) {
      if (stopped()) return;
      if (coordinate_.slot() != kNoSlot) p[coordinate_.slot()] = x;
      const auto same_shapes = [&](const ProfilePoint& other) {
        return std::equal(p.begin(), p.begin() + std::ptrdiff_t(model_.shape_slots()), other.p.begin());
      };
      if (std::ranges::none_of(seeds, same_shapes)) seeds.push_back(solve_at(x, p, true));
    };
    for (const std::vector<double>& p : start_.seeds.points()) add(p);
    std::ranges::stable_sort(seeds, {}, &ProfilePoint::rise);
    std::optional<ProfilePoint> best;
    for (std::size_t k = 0; k < std::min(seeds.size(), kBestSeeds); ++k) {
      ProfilePoint found = solve_at(x, seeds[k].p);
      if (!best || found.rise < best->rise) best = std::move(found);
    }
    return best;
  }

  void begin(int side) {
    side_ = side;
    limit_ = side < 0 ? coordinate_.low() : coordinate_.high();
    inside_.reset();
    outside_.reset();
  }

  ProfileEnd find(int side) {
    begin(side);
    if (is_beyond(origin_, limit_)) return {{origin_, 0, start_.minimum.p}, true, true};
    const bool known = error_ > 0 && std::isfinite(error_);
    return settled(known ? origin_ + side * error_ : origin_ + kStepBeyond * (limit_ - origin_));
  }

  // Returns the crossing beyond which the profile keeps rising.
  ProfileEnd settled(double guess) {
    for (int round = 0; round < kRounds && !stopped(); ++round) {
      ProfileEnd end = cross(guess);
      bool fell = false;
      if (!end.open) look_beyond(end, fell);
      if (!fell) return end;
      outside_.reset();
      if (inside_->x == limit_) break;
      guess = origin_ + 2 * (inside_->x - origin_);
    }
    return {inside_ ? *inside_ : ProfilePoint{origin_, 0, start_.minimum.p}, true, false};
  }

  // Moves an end out to points that other profiles found beyond it, by the rules of look_beyond(), and to
  // points reached from other shapes.
  void extend(int side, std::span<const CostedPoint> known, ProfileEnd& end) {
    for (int round = 0; round < kRounds && !end.open && !stopped(); ++round) {
      begin(side);
      if (is_beyond(end.at.x, limit_)) return;
      reach_for(known, end);
      const double step = kStepBeyond * std::max(distance(end.at.x), error_);
      const double asked = end.at.x + side * step;
      std::optional<ProfilePoint> found = elsewhere(is_beyond(asked, limit_) ? limit_ : asked);
      if (!found || !(pace(*found) < 1 - kOnLevel)) return;
      inside_ = std::move(found);
      end = is_beyond(inside_->x, limit_) ? ProfileEnd{*inside_, true, true}
                                          : settled(origin_ + 2 * (inside_->x - origin_));
    }
  }

  // Moves the end out to the positions that the known points imply.
  void reach_for(std::span<const CostedPoint> known, ProfileEnd& end) {
    const double reach = distance(end.at.x);
    double farthest = (1 + kStepBeyond) * reach;
    for (const CostedPoint& point : known) {
      ProfilePoint here{coordinate_.at(point.p), point.rise, point.p};
      if (!is_beyond(here.x, end.at.x)) continue;
      const double away = distance(here.x);
      const bool plateau = away > kPlateau * reach && point.rise < square(kClosed) * plateau_level_;
      if (!plateau && pace(here) >= kClosed) continue;
      const double says = plateau ? away : away / std::max(pace(here), 1.0);
      if (says <= farthest) continue;
      farthest = says;
      outside_ = std::move(here);
    }
    if (!outside_) return;
    inside_ = end.at;
    const double x = origin_ + side_ * farthest;
    end.at = farthest >= distance(outside_->x) ? *outside_ : at(x);
  }

  const ProfileStart& start_;
  const Model& model_;
  ProfileCoordinate coordinate_;
  ProfileSolver solver_;
  double level_, plateau_level_, error_;
  // may_vanish_: a lobe without weight leaves its shape free; the evidence for such a lobe must reach five
  // standard errors.
  bool weight_, may_vanish_;
  double origin_ = 0, limit_ = 0;
  Eigen::VectorXd follows_;  // derivatives of the solver's parameters by this one
  int side_ = 1;
  bool quadratic_ = true;
  std::optional<ProfilePoint> inside_, outside_;  // nearest to the level
  std::vector<CostedPoint> near_;
};

}  // namespace

ProfileSides find_ends(const ProfileStart& start, const Reported& r, std::size_t index, ProfileLevel level) {
  return ProfileSearch(start, r, index, level).run();
}

void extend_ends(const ProfileStart& start, const Reported& r, std::size_t index, ProfileLevel level,
                 std::span<const CostedPoint> known, ProfileSides& sides) {
  ProfileSearch(start, r, index, level).extend(known, sides);
}

const std::vector<std::vector<double>>& ProfileSeeds::points() {
  std::call_once(filled_, [&] {
    if (stream_.model().shape_slots() == 0) return;
    for (std::vector<double>& p : grid_starts(stream_.model())) {
      start_weights(stream_, p);
      points_.push_back(std::move(p));
    }
  });
  return points_;
}

}  // namespace brdf::fit
