#include "prove/check/sum_of_albedos.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "prove/scalar/interval.h"

namespace brdf::prove {
namespace {

using I = Interval<double>;

std::vector<Bounds> points(std::span<const double> values) {
  std::vector<Bounds> found;
  for (const double x : values) found.push_back({x, x});
  return found;
}

// Encloses a ratio of widths, which is rounded.
I exactly(double ratio) {
  return I::widened(ratio, ratio, 4);
}

// Returns the turn after its tangent is multiplied by `by`. A turn is t/(1 + t) of the tangent t.
I stretched(double turn, double by) {
  if (turn == 0) return I();
  const I along = exactly(by) * I::of(turn, turn);
  return along / (along + (I(1) - I::of(turn, turn)));
}
Bounds stretched(Bounds turn, double least, double most) {
  return {std::max(stretched(turn.lo, least).lo, 0.0), std::min(stretched(turn.hi, most).hi, 1.0)};
}

// Returns the views as seen by facets that are `by` times as wide.
Views stretched(const Views& views, const std::array<double, 2>& by) {
  if (by[0] == by[1]) return {by[0] == 1 ? views.turn : stretched(views.turn, by[0], by[0]), views.azimuth};
  I cosine, sine;
  circle(views.azimuth, cosine, sine);
  const I along2 = square(exactly(by[0])), across2 = square(exactly(by[1]));
  const I longer = sqrt(square(cosine) * (along2 - across2) + across2);
  const double ratio = by[1] / by[0];
  return {stretched(views.turn, longer.lo, longer.hi), stretched(views.azimuth, ratio, ratio)};
}

}  // namespace

SumOfAlbedos::SumOfAlbedos(const Channels& terms) {
  std::array<double, 2> narrowest{1, 1};
  Angle tangent{};  // of the terms that turn
  for (const Channel& c : terms) {
    const EnergyMethod* method = is_of_catalogue(c) ? albedo_method(catalogue_index(c.term.form)) : nullptr;
    known_ = known_ && method != nullptr;
    if (!known_) return;
    Part p{method, points(c.shape()), points(c.weights())};
    if (method->stretch != nullptr) p.stretch = method->stretch(p.shape);
    const bool turns = p.stretch[0] != p.stretch[1];
    known_ = known_ && !(turns && turns_ && c.term.tangent_phi != tangent);
    if (turns) tangent = c.term.tangent_phi;
    turns_ = turns_ || turns;
    if (p.stretch[0] * p.stretch[1] < narrowest[0] * narrowest[1]) narrowest = p.stretch;
    parts_.push_back(std::move(p));
  }
  for (Part& p : parts_) {
    for (std::size_t k = 0; k < 2; ++k) p.stretch[k] /= narrowest[k];
    known_ = known_ && p.method->albedo(p.shape, p.weights, {{0, 0}}, 1);
  }
}

AlbedoBounds SumOfAlbedos::operator()(const Views& views, double accuracy) const {
  I sum;
  AlbedoBounds all;
  for (const Part& p : parts_) {
    const AlbedoBounds b = *p.method->albedo(p.shape, p.weights, stretched(views, p.stretch), accuracy);
    sum = sum + I::of(b.value.lo, b.value.hi);
    for (std::size_t k = 0; k < 2; ++k) all.reach[k] += b.reach[k];
  }
  all.value = {sum.lo, sum.hi};
  return all;
}

Bounds SumOfAlbedos::within_range(Bounds b) {
  constexpr double kMost = std::numeric_limits<double>::max();
  return {std::clamp(b.lo, -kMost, kMost), std::isnan(b.hi) ? kMost : std::clamp(b.hi, -kMost, kMost)};
}

Domain SumOfAlbedos::domain() const {
  Domain views;
  views.variables.push_back({"turn_from_normal", 0, 1, Variable::Cut::middle});
  if (turns_) views.variables.push_back({"turn_from_first_axis", 0, 1, Variable::Cut::middle});
  return views;
}

Views SumOfAlbedos::views_of(std::span<const Bounds> box) {
  return {box[0], box.size() > 1 ? box[1] : Bounds{0, 0}};
}

}  // namespace brdf::prove
