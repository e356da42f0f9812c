#include "micro/theory.h"

#include <functional>

#include "micro/masking.h"
#include "micro/theory_text.h"

namespace brdf::micro {

TheoryRow theory_row(std::string surface, std::string quantity, const Estimate& simulated, double model,
                     bool exact) {
  TheoryRow row{std::move(surface),
                std::move(quantity),
                simulated.mean,
                simulated.standard_error,
                model,
                kNone,
                exact,
                {}};
  const double difference = simulated.mean - model;
  if (simulated.standard_error > 0) row.z = difference / simulated.standard_error;
  return row;
}

bool holds(const TheoryRow& row) {
  if (!row.exact) return true;
  if (std::isnan(row.z)) return std::abs(row.simulated - row.model) <= kExactShare;
  return std::abs(row.z) <= kExactZ;
}

void explain(std::vector<TheoryRow>& rows, const std::string& cause) {
  for (TheoryRow& row : rows)
    if (!row.exact && !std::isnan(row.model)) row.cause = cause;
}

std::vector<TheoryRow> compare_slopes(const TheoryOptions& options) {
  std::vector<TheoryRow> rows;
  for (const auto& [ax, ay] : {std::pair{0.1, 0.1}, {0.3, 0.3}, {0.5, 0.5}, {0.2, 0.5}}) {
    Simulation s;
    s.geometry = HeightField{.alpha_x = ax, .alpha_y = ay};
    s.surfaces = 16 * options.effort;
    s.seed = options.seed;
    s.threads = options.threads;
    const Slopes slopes = measure_slopes(s, {1, 3});
    const std::string name =
        ax == ay ? gaussian_name(ax)
                 : "gaussian alpha_x " + io::short_number(ax) + " alpha_y " + io::short_number(ay);
    rows.push_back(theory_row(name, "alpha_x of the mesh", slopes.alpha_x, ax, true));
    rows.push_back(theory_row(name, "alpha_y of the mesh", slopes.alpha_y, ay, true));
    rows.push_back(theory_row(name, "share of slopes beyond alpha", slopes.outside[0], std::exp(-1.0), true));
    rows.push_back(
        theory_row(name, "share of slopes beyond sqrt(3) alpha", slopes.outside[1], std::exp(-3.0), true));
  }
  return rows;
}

std::vector<TheoryRow> compare_masking(const TheoryOptions& options) {
  std::vector<TheoryRow> rows;
  for (const double alpha : {0.3, 0.5}) {
    Simulation s;
    s.geometry = HeightField{.alpha_x = alpha, .alpha_y = alpha};
    s.surfaces = 16 * options.effort;
    s.rays = 1 << 14;
    s.seed = options.seed;
    s.threads = options.threads;
    for (const Masking& m : measure_masking(s, {30_deg, 60_deg, 75_deg, 85_deg})) {
      const double cosine = std::cos(m.theta.radians());
      const double g1 = 1 / (1 + smith_lambda(alpha, m.theta));
      const std::string name = gaussian_name(alpha),
                        at = "theta " + io::short_number(m.theta.degrees()) + ": ";
      rows.push_back(theory_row(name, at + "projected area seen", m.projected_area, cosine, true));
      rows.push_back(theory_row(name, at + "projected area facing", m.facing_area, cosine / g1, true));
      rows.push_back(theory_row(name, at + "visible share of facing points, against Smith's G1",
                                m.visible_points, g1, false));
      rows.push_back(theory_row(name, at + "the same, facets tilted towards", m.visible_towards, g1, false));
      rows.push_back(theory_row(name, at + "the same, facets tilted away", m.visible_away, g1, false));
    }
  }
  explain(rows,
          "Smith assumes that the slope of a microfacet and the heights in front of it are independent; on a "
          "continuous surface a microfacet tilted away is behind its own slope and is masked more often");
  return rows;
}

std::vector<TheoryRow> compare_reciprocity(const TheoryOptions& options) {
  std::vector<TheoryRow> rows;
  const auto add = [&](const std::string& name, Simulation s) {
    s.seed = options.seed;
    s.threads = options.threads;
    s.surfaces = 16 * options.effort;
    s.rays = 1 << 14;
    const Cells cells(15_deg);
    const Cell& a = cells[cells.find(direction(radians(0.38), {}))];
    for (const Angle phi : {0_deg, 90_deg, 180_deg}) {
      const Cell& b = cells[cells.find(direction(radians(1.18), phi))];
      const Exchange e = measure_exchange(s, a, b);
      const Estimate forward{e.forward.mean, std::hypot(e.forward.standard_error, e.backward.standard_error)};
      const std::string quantity =
          "f_r theta 22 to theta 67, phi " + io::short_number(phi.degrees()) + ", against the reversed path";
      rows.push_back(theory_row(name, quantity, forward, e.backward.mean, true));
    }
  };
  add(gaussian_name(0.5), {.geometry = HeightField{.alpha_x = 0.5, .alpha_y = 0.5}});
  add("mirror grooves alpha 0.5", {.geometry = Grooves{GrooveAngles::beckmann, 0.5, 1024}});
  add("Lambertian grooves sigma 30", {.geometry = Grooves{GrooveAngles::oren_nayar, kPi / 6, 1024},
                                      .facets = {.reflection = Reflection::lambert, .rho = 0.9}});
  return rows;
}

std::vector<TheoryRow> compare_energy(const TheoryOptions& options) {
  std::vector<TheoryRow> rows;
  for (const double alpha : {0.1, 0.5, 1.0}) {
    Simulation s;
    s.geometry = HeightField{.alpha_x = alpha, .alpha_y = alpha};
    s.seed = options.seed;
    s.threads = options.threads;
    s.surfaces = 8 * options.effort;
    for (const Scatter& one :
         measure_scatter(s, {{30_deg, {}}, {60_deg, {}}, {85_deg, {}}}, Cells(radians(0.3)))) {
      const std::string at = "theta_i " + io::short_number(one.incidence.theta.degrees()) + ": ";
      rows.push_back(
          theory_row(gaussian_name(alpha), at + "albedo, up to 64 reflections", one.albedo, 1, true));
      rows.push_back(
          theory_row(gaussian_name(alpha), at + "share of rays lost", {one.account.lost(), kNone}, 0, true));
      for (const int order : {1, 2, 3}) {
        rows.push_back(theory_row(gaussian_name(alpha),
                                  at + "share after " + io::short_number(order) + " reflection(s)",
                                  {one.account.escaped[order - 1], kNone}, kNone, false));
      }
    }
  }
  return rows;
}

std::vector<TheoryRow> compare_with_theory(const TheoryOptions& options, const Progress& progress) {
  std::vector<std::function<std::vector<TheoryRow>()>> parts;
  parts.push_back([&] { return compare_slopes(options); });
  parts.push_back([&] { return compare_masking(options); });
  for (const double alpha : {0.1, 0.3, 0.5}) {
    for (const double theta_i : {30.0, 60.0}) {
      parts.push_back(
          [&, alpha, theta_i] { return compare_single_bounce(options, alpha, degrees(theta_i)); });
    }
  }
  // Illuminates the retro direction.
  parts.push_back([&] { return compare_single_bounce(options, 1, 60_deg); });
  for (const double theta_i : {30.0, 60.0})
    parts.push_back([&, theta_i] { return compare_mirror_grooves(options, degrees(theta_i)); });
  for (const double sigma : {10.0, 20.0, 30.0})
    parts.push_back([&, sigma] { return compare_lambert_grooves(options, degrees(sigma)); });
  parts.push_back([&] { return compare_reciprocity(options); });
  parts.push_back([&] { return compare_energy(options); });

  std::vector<TheoryRow> rows;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (TheoryRow& row : parts[k]()) rows.push_back(std::move(row));
    if (progress) progress(static_cast<int>(k + 1), static_cast<int>(parts.size()));
  }
  return rows;
}

}  // namespace brdf::micro
