// Tests the studio: the light of its floor next to a ball, its sampling densities, and the ball's light
// compared with direct integration.
#include "io/page/sphere/studio.h"

#include <gtest/gtest.h>

#include <cmath>

#include "brdf/forms.h"
#include "brdf/random.h"
#include "io/page/sphere/still.h"

namespace brdf::io::sphere {
namespace {

// Calls visit(w, solid angle) for directions that cover the sphere evenly.
template <class Visit>
void over_sphere(int rows, Visit&& visit) {
  const int columns = 2 * rows;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double y = 1 - 2 * (i + 0.5) / rows, sine = std::sqrt(1 - y * y),
                   phi = 2 * kPi * (j + 0.5) / columns;
      visit(Vec3<double>{sine * std::sin(phi), y, sine * std::cos(phi)}, 4 * kPi / (rows * columns));
    }
}

TEST(Studio, TheFloorReceivesWhatTheBallLeaves) {
  for (const double distance : {0.2, 0.7, 1.5, 4.0}) {
    double open = 0, left = 0;
    over_sphere(600, [&](const Vec3<double>& w, double angle) {
      if (w.y <= 0) return;
      open += w.y * angle;
      // The ray from the floor meets the ball whose centre is at height 1.
      const Vec3<double> centre{-distance, 1, 0};
      const double along = dot(w, centre), nearest2 = dot(centre, centre) - along * along;
      if (!(along > 0 && nearest2 < 1)) left += w.y * angle;
    });
    EXPECT_NEAR(studio::light_beside_ball(1.0, 1.0, distance * distance), left / open, 2e-3) << distance;
  }
  EXPECT_EQ(studio::light_beside_ball(1.0, 1.0, 0.0), 0);
  EXPECT_GT(studio::light_beside_ball(1.0, 1.0, 1e4), 0.999);
  // Above the horizon the floor has no effect; the contact is straight below the
  // lowest place of the ball.
  EXPECT_EQ(studio::floor_share(Vec3<double>{0, -1, 0}, Vec3<double>{0.6, 0.8, 0}), 1);
  EXPECT_EQ(studio::floor_share(Vec3<double>{0, -1, 0}, Vec3<double>{0, -1, 0}), 0);
}

TEST(Studio, TheDensityOfTheBoxesIsThatOfTheirDirections) {
  double sum = 0;
  over_sphere(700, [&](const Vec3<double>& w, double angle) { sum += studio::box_density(w) * angle; });
  EXPECT_NEAR(sum, 3, 0.03);
  // The mean of 1/density over the directions of a box is its solid angle, if no other box overlaps.
  Random random(5);
  std::array<double, 3> found{}, expected{};
  constexpr int kDraws = 20000;
  for (int k = 0; k < kDraws; ++k) {
    const auto directions = studio::box_directions(random.uniform(), random.uniform());
    for (std::size_t b = 0; b < 3; ++b) {
      EXPECT_GT(studio::box_density(directions[b]), 0);
      found[b] += 1 / studio::box_density(directions[b]) / kDraws;
    }
  }
  over_sphere(700, [&](const Vec3<double>& w, double angle) {
    for (std::size_t b = 0; b < 3; ++b) {
      const studio::SoftBox& box = studio::soft_boxes()[b];
      const double facing = dot(w, box.centre);
      if (facing > 0.01 && std::fabs(dot(w, box.across)) < facing * box.half[0] * (1 + box.edge) &&
          std::fabs(dot(w, box.up)) < facing * box.half[1] * (1 + box.edge))
        expected[b] += angle;
    }
  });
  for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(found[b] / expected[b], 1, 0.02) << b;
}

// Integrates over the hemisphere directly.
Colour integrated(const Material& material, const View& view, double x, double y) {
  const FittedPairs fitted = fitted_pairs(material);
  const auto [n, t, b] = frame_at(view, x, y);
  const auto local = [&](const Vec3<double>& w) { return Vec3<double>{dot(w, t), dot(w, b), dot(w, n)}; };
  Colour sum{};
  over_sphere(450, [&](const Vec3<double>& w, double angle) {
    const Vec3<double> wi = local(w);
    if (wi.z <= 0) return;
    const Colour f = fitted(wi, local(view.towards)), light = studio::radiance(w);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += f[c] * light[c] * wi.z * studio::floor_share(n, w) * angle;
  });
  return sum;
}

TEST(Studio, TheBallReflectsTheIntegralOfTheLight) {
  Material white = make_material(lambert{}), metal = make_material(cook_torrance{}),
           brushed = make_material(ward{});
  metal.terms[0].shape[0] = {0.12, 0.12};
  brushed.terms[0].shape[0] = {0.1, 0.35};
  for (const Material* material : {&white, &metal, &brushed}) {
    const Studio studio(*material);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {-0.4, 0.4}, {0.6, 0.1}, {0.1, -0.8}}) {
      const Colour found = studio.reflected(first_view(), x, y),
                   expected = integrated(*material, first_view(), x, y);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c] / expected[c], 1, 0.04)
            << info(material->terms[0].form).name << " at " << x << ", " << y;
    }
  }
}

TEST(Studio, TheWidthsFollowTheLobe) {
  Material metal = make_material(cook_torrance{});
  metal.terms[0].shape[0] = {0.05, 0.2};
  const auto [narrow, wide] = lobe_widths(fitted_pairs(metal));
  EXPECT_NEAR(narrow, 0.05, 0.01);
  EXPECT_NEAR(wide, 0.2, 0.05);
  EXPECT_EQ(lobe_widths(fitted_pairs(make_material(lambert{})))[1], 1);
}

TEST(Studio, ExposureIsZeroUnlessTheBallWouldBeBlackOrWhite) {
  Material grey = make_material(lambert{});
  const auto of = [&](double rho) {
    grey.terms[0].weights = {{rho}, {rho}, {rho}};
    return studio_exposure(grey);
  };
  EXPECT_EQ(of(0.8), 0);
  EXPECT_EQ(of(0.05), 0);  // a dark material looks dark
  EXPECT_GT(of(0.001), 3);
}

}  // namespace
}  // namespace brdf::io::sphere
