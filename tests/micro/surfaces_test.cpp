// Generated surfaces have the given slopes, correlation and groove angles; tracer and masking agree with
// independent computations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brdf/material.h"
#include "micro/goniometer.h"
#include "micro/masking.h"

namespace brdf::micro {
namespace {

Simulation field(double alpha_x, double alpha_y, int size = 128, int surfaces = 64) {
  Simulation s;
  s.geometry = HeightField{.alpha_x = alpha_x, .alpha_y = alpha_y, .size = size};
  s.surfaces = surfaces;
  return s;
}

double z(const Estimate& e, double expected) {
  return (e.mean - expected) / e.standard_error;
}

TEST(HeightField, MeshHasTheGivenSlope) {
  for (const auto& [ax, ay] : {std::pair{0.3, 0.3}, {0.1, 0.5}, {0.005, 0.005}}) {
    const Slopes slopes = measure_slopes(field(ax, ay), {});
    EXPECT_LT(slopes.alpha_x.standard_error, 0.01 * ax);
    EXPECT_LT(std::abs(z(slopes.alpha_x, ax)), 4) << ax << ' ' << slopes.alpha_x.mean;
    EXPECT_LT(std::abs(z(slopes.alpha_y, ay)), 4) << ay << ' ' << slopes.alpha_y.mean;
  }
}

TEST(HeightField, HasBeckmannsSlopes) {
  const Slopes slopes = measure_slopes(field(0.2, 0.4), {0.5, 1, 3, 6});
  const double q[] = {0.5, 1, 3, 6};
  for (int k = 0; k < 4; ++k) {
    EXPECT_LT(std::abs(z(slopes.outside[k], std::exp(-q[k]))), 4) << q[k];
    EXPECT_LT(slopes.outside[k].standard_error, 0.12 * std::exp(-q[k]));
  }
}

// The correlation of the heights falls to 1/e at the given distance.
TEST(HeightField, HasTheGivenCorrelation) {
  Collector correlation;
  Simulation s = field(0.3, 0.3);
  for (int index = 0; index < 64; ++index) {
    const Surface surface = make_surface(s, index);
    double product = 0, square_sum = 0;
    for (int j = 0; j < surface.ny; ++j) {
      for (int i = 0; i < surface.nx; ++i) {
        product += surface.vertex(i, j) * surface.vertex((i + 8) % surface.nx, j);
        square_sum += square(surface.vertex(i, j));
      }
    }
    correlation.add(product / square_sum);
  }
  EXPECT_NEAR(correlation.estimate().mean, std::exp(-1.0), 4 * correlation.estimate().standard_error);
}

// Any two triangles that share a vertex give it the same height, also across the border of the period.
TEST(Surface, HasNoGaps) {
  const Surface s = make_surface(field(0.5, 0.25, 16), 0);
  for (int j = -2; j < 20; ++j) {
    for (int i = -2; i < 20; ++i) {
      const double x = i * s.dx, y = j * s.dy;
      const double height = s.vertex((i + 16) % 16, (j + 16) % 16);
      for (const double side_x : {-1e-9, 1e-9}) {
        for (const double side_y : {-1e-9, 0.5e-9, 2e-9}) {
          EXPECT_NEAR(s.facet_at(x + side_x, y + side_y).height(x, y), height, 1e-6);
        }
      }
    }
  }
}

// The shares of grooves below given angles against the integral of the density.
TEST(Grooves, HaveTheStatedAngles) {
  const double sigma = 0.5, alpha = 0.6;
  const auto share_below = [](const Surface& s, double angle) {
    int below = 0;
    for (int k = 0; k < s.nx / 2; ++k) below += std::atan(-2 * s.vertex(2 * k + 1, 0)) < angle;
    return below / (s.nx / 2.0);
  };
  const auto integral = [&](double to) {
    double sum = 0;
    for (int k = 0; k < 2000; ++k) {
      const double t = (k + 0.5) / 2000 * to;
      sum += std::exp(-t * t / (2 * sigma * sigma)) * std::sin(t) * to / 2000;
    }
    return sum;
  };
  constexpr int kCount = 40000;
  Random random = random_for(1, 0, Purpose::geometry);
  const Surface diffuse = make_grooves({GrooveAngles::oren_nayar, sigma, kCount}, random);
  const Surface mirrors = make_grooves({GrooveAngles::beckmann, alpha, kCount}, random);
  for (const double angle : {0.2, 0.5, 1.0, 1.4}) {
    const double p = integral(angle) / integral(kPi / 2);
    EXPECT_NEAR(share_below(diffuse, angle), p, 4 * std::sqrt(p * (1 - p) / kCount));
    const double q = 1 - std::exp(-square(std::tan(angle) / alpha));
    EXPECT_NEAR(share_below(mirrors, angle), q, 4 * std::sqrt(q * (1 - q) / kCount) + 1e-9);
  }
}

// Returns the surface's point over (x, y) as the start of a ray.
Place on_surface(const Surface& s, March& march, double x, double y) {
  Place place = march.place_over(x, y, 0);
  place.at.z = s.facet_at(x, y).height(x, y);
  return place;
}

// The tracer against small steps over the endless surface, which use neither cells nor the period.
TEST(March, FindsWhatSmallStepsFind) {
  const Surface s = make_surface(field(0.6, 0.4, 32), 3);
  March march = s.march();
  Random random = random_for(5, 0, Purpose::scatter);
  int hits = 0, escapes = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Place start =
        on_surface(s, march, s.period_x() * random.uniform(), s.period_y() * random.uniform());
    const Vec w =
        direction(radians(kPi / 2 * (0.7 + 0.35 * random.uniform())), radians(2 * kPi * random.uniform()));
    const Facet at_start = s.facet_at(start.at.x, start.at.y);
    if (w.z - at_start.slope_x * w.x - at_start.slope_y * w.y < 0.02) continue;
    double t = 2e-3;
    Vec p = start.at + w * t;
    const double step = 2e-3;
    while (p.z > s.facet_at(p.x, p.y).height(p.x, p.y) && p.z <= s.z_max + 0.1)
      p = start.at + w * (t += step);
    const March::Meeting met = march.march(start, w);
    if (p.z > s.z_max) {
      ++escapes;
      EXPECT_EQ(met.fate, March::escaped) << trial;
      continue;
    }
    ++hits;
    ASSERT_EQ(met.fate, March::hit) << trial;
    const Vec& found = met.place.at;
    EXPECT_NEAR(std::remainder(found.x - p.x, s.period_x()), 0, 2 * step) << trial;
    EXPECT_NEAR(std::remainder(found.y - p.y, s.period_y()), 0, 2 * step) << trial;
    EXPECT_NEAR(found.z, s.facet_at(found.x, found.y).height(found.x, found.y), 1e-12) << trial;
  }
  EXPECT_GT(hits, 50);
  EXPECT_GT(escapes, 30);
}

// Rays from vertices and along edges, diagonals and the seams of the period meet a surface that continues:
// no ray passes between two triangles.
TEST(March, MeetsEdgesAndVertices) {
  const Surface s = make_surface(field(0.8, 0.5, 16), 1);
  March march = s.march();
  int hits = 0;
  for (const double dx : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    for (const double dy : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      for (const double dz : {-2.0, -0.1, -1e-3}) {
        const Vec along{dx * s.dx, dy * s.dy, dz};
        const Vec w = along * (1 / std::sqrt(dot(along, along)));
        for (int j = 0; j <= s.ny; ++j) {
          for (int i = 0; i <= s.nx; ++i) {
            const Place start = march.place_over(i * s.dx, j * s.dy, s.z_max);
            const March::Meeting met = march.march(start, w);
            ASSERT_EQ(met.fate, March::hit) << i << ' ' << j << ' ' << dx << ' ' << dy << ' ' << dz;
            EXPECT_NEAR(met.place.at.z,
                        s.facet_at(met.place.at.x, met.place.at.y).height(met.place.at.x, met.place.at.y),
                        1e-12);
            ++hits;
          }
        }
      }
    }
  }
  EXPECT_EQ(hits, 5 * 5 * 3 * 17 * 17);
}

// Blocks and cells above which a ray stays are left out. With blocks that are never left out, every path is
// the same.
TEST(March, LeavesOutOnlyWhatARayDoesNotMeet) {
  const Surface s = make_surface(field(0.7, 0.3, 130), 2);
  EXPECT_EQ(s.tops.size(), 17u * 17u);
  Surface whole = s;
  std::ranges::fill(whole.tops, float(s.z_max));
  March march = s.march(), slow = whole.march();
  Random random(8);
  for (const double theta : {0.2, 1.0, 1.5}) {
    const Vec wi = direction(radians(theta), radians(1.1));
    for (int k = 0; k < 2000; ++k) {
      const double u = random.uniform(), v = random.uniform();
      const Path a = march.path_over_mirrors(wi, u, v, 0, 64), b = slow.path_over_mirrors(wi, u, v, 0, 64);
      ASSERT_EQ(a.order, b.order) << k;
      ASSERT_EQ(a.fate, March::escaped);
      ASSERT_NEAR(dot(a.travel, b.travel), 1, 1e-12) << k;
    }
  }
}

// A level ray below the highest vertex of a surface that it never meets is followed to the limit and no
// further.
TEST(March, GivesUpALevelRay) {
  Surface s;
  s.nx = s.ny = 2;
  s.heights = {0, 0, 0, 0};
  s.tops = {0};
  s.z_max = 1;
  March march = s.march();
  EXPECT_EQ(march.march(march.place_over(0.25, 0.5, 0.5), {1, 0, 0}).fate, March::lost);
}

// For any surface, the visible area projected along a direction is cos theta per macroscopic area.
TEST(Masking, SeesTheProjectedAreaOfThePlane) {
  Simulation s = field(0.5, 0.5, 256, 8);
  s.rays = 40000;
  for (const Masking& m : measure_masking(s, {radians(0.5), radians(1.2), radians(1.45)})) {
    const double cosine = std::cos(m.theta.radians());
    EXPECT_LT(m.projected_area.standard_error, 0.02 * cosine);
    EXPECT_LT(std::abs(z(m.projected_area, cosine)), 5) << m.theta.degrees();
    EXPECT_LT(std::abs(z(m.facing_area, cosine * (1 + smith_lambda(0.5, m.theta)))), 5) << m.theta.degrees();
  }
}

}  // namespace
}  // namespace brdf::micro
