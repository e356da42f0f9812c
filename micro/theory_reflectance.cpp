// Comparisons of f_r: height fields and grooves against the forms derived for them.
#include <algorithm>
#include <array>
#include <cmath>

#include "micro/model.h"
#include "micro/theory.h"
#include "micro/theory_text.h"

namespace brdf::micro {
namespace {

constexpr double kDegree = kPi / 180;
constexpr double kLeastPower = 1e-4;     // cells with less are not judged
constexpr double kRetro = 20 * kDegree;  // about this direction masking and shadowing are one event
constexpr double kApart = 0.05;          // relative difference that counts,
constexpr double kSignificance = 2;      // by more than so many standard errors

Simulation with(const TheoryOptions& options) {
  Simulation s;
  s.seed = options.seed;
  s.threads = options.threads;
  return s;
}

// Cells whose side is small against the lobe's width (2 alpha in the outgoing angle).
double cell_width(double alpha) {
  return std::clamp(alpha * 25, 2.0, 5.0) * kDegree;
}

std::string in_plane(double theta_o, bool forward) {
  return std::string("theta_o ") + text(theta_o / kDegree) + (forward ? " forward" : " backward");
}

// One row for every cell of the plane of incidence that holds enough power.
void add_in_plane(std::vector<TheoryRow>& rows, const std::string& surface, const Scatter& scatter,
                  const Cells& cells, const Material& form, bool exact, double least_power) {
  for (int c = 0; c < cells.size(); ++c) {
    const bool back = std::abs(cells[c].centre_phi()) < 1e-9,
               forward = std::abs(cells[c].centre_phi() - kPi) < 1e-9;
    const Estimate& f = scatter.f[0][c];
    if (!(back || forward) || f.mean * cells[c].projected_solid_angle() < least_power) continue;
    rows.push_back(theory_row(surface,
                              "f_r theta_i " + text(scatter.incidence.theta / kDegree) + ", " +
                                  in_plane(cells[c].centre_theta(), forward) + ", single",
                              f, cell_mean(form, scatter.incidence, cells[c]), exact));
  }
}

double model_albedo(const Material& form, const Incidence& from) {
  const Cells fine(1 * kDegree);
  double sum = 0;
  for (int c = 0; c < fine.size(); ++c)
    sum += cell_mean(form, from, fine[c]) * fine[c].projected_solid_angle();
  return sum;
}

// Single-reflection albedo with its standard error, from a simulation stopped after one reflection.
TheoryRow albedo_row(const std::string& surface, const Scatter& scatter, const Material& form, bool exact) {
  return theory_row(surface, "albedo theta_i " + text(scatter.incidence.theta / kDegree) + ", single",
                    scatter.albedo, model_albedo(form, scatter.incidence), exact);
}

}  // namespace

CellAgreement agreement(const Scatter& scatter, const Cells& cells, const Material& form) {
  CellAgreement a;
  const Vec wi = direction(scatter.incidence.theta, 0);
  for (int c = 0; c < cells.size(); ++c) {
    const Estimate& f = scatter.f[0][c];
    const double solid = cells[c].projected_solid_angle();
    if (f.mean * solid < kLeastPower) continue;
    const double m = cell_mean(form, scatter.incidence, cells[c]);
    const bool apart = std::abs(f.mean - m) - kApart * m > kSignificance * f.standard_error;
    if (std::acos(std::min(dot(wi, cells[c].centre()), 1.0)) < kRetro) {
      ++a.retro_cells;
      a.retro_apart += apart;
      a.worst_retro = std::max(a.worst_retro, f.mean / m - 1);
      continue;
    }
    ++a.cells;
    a.apart += apart;
    a.power += f.mean * solid;
    a.power_apart += apart ? f.mean * solid : 0;
    a.mean_error += f.standard_error / m;
  }
  a.mean_error /= std::max(a.cells, 1);
  return a;
}

std::vector<TheoryRow> compare_single_bounce(const TheoryOptions& options, double alpha, double theta_i) {
  Simulation s = with(options);
  s.geometry = HeightField{.alpha_x = alpha, .alpha_y = alpha};
  s.surfaces = 16 * options.effort;
  s.rays = 1 << 18;
  s.max_bounces = 1;
  const Cells cells(cell_width(alpha));
  const Scatter scatter = measure_scatter(s, {{theta_i, 0}}, cells)[0];
  const Material form = model("cook_torrance_beckmann",
                              {{"kd", 0}, {"ks", 1}, {"f0", 1}, {"alpha_x", alpha}, {"alpha_y", alpha}});
  const std::string name = gaussian_name(alpha), at = "theta_i " + text(theta_i / kDegree) + ": ";

  std::vector<TheoryRow> rows{albedo_row(name, scatter, form, false)};
  const CellAgreement a = agreement(scatter, cells, form);
  const auto add = [&](const std::string& quantity, double number) {
    rows.push_back(theory_row(name, at + quantity, {number, kNone}, kNone, false));
  };
  add("cells judged", a.cells);
  add("mean relative standard error of a cell", a.mean_error);
  add("share of cells within 5 %", 1 - a.apart / std::max<double>(a.cells, 1));
  add("share of their power in cells within 5 %", 1 - a.power_apart / std::max(a.power, 1e-300));
  add("cells within 20 degrees of the retro direction", a.retro_cells);
  add("of these apart by more than 5 %", a.retro_apart);
  if (a.retro_cells > 0) add("greatest relative excess among them", a.worst_retro);
  add_in_plane(rows, name, scatter, cells, form, false, kLeastPower);
  return rows;
}

std::vector<TheoryRow> compare_mirror_grooves(const TheoryOptions& options, double theta_i) {
  constexpr double kAlpha = 0.4, kEta = 1.5;
  Simulation s = with(options);
  s.geometry = Grooves{GrooveAngles::beckmann, kAlpha, 1024};
  s.facets.eta = kEta;
  s.surfaces = 512 * options.effort;
  s.rays = 1 << 13;
  s.max_bounces = 1;
  const Cells cells(10 * kDegree);
  const Scatter scatter = measure_scatter(s, {{theta_i, 0}}, cells)[0];
  const Material form =
      model("cook_torrance_vcavity",
            {{"kd", 0}, {"ks", 1}, {"alpha_x", kAlpha}, {"alpha_y", kAlpha}, {"eta", kEta}});
  const std::string name = "mirror grooves alpha " + text(kAlpha) + " eta " + text(kEta);
  std::vector<TheoryRow> rows{albedo_row(name, scatter, form, true)};
  add_in_plane(rows, name, scatter, cells, form, true, kLeastPower);
  return rows;
}

std::vector<TheoryRow> compare_lambert_grooves(const TheoryOptions& options, double sigma) {
  constexpr double kRho = 0.9;
  Simulation s = with(options);
  s.geometry = Grooves{GrooveAngles::oren_nayar, sigma, 1024};
  s.facets = {.reflection = Reflection::lambert, .rho = kRho};
  s.surfaces = 32 * options.effort;
  s.rays = 1 << 14;
  const std::vector<Incidence> from{{30 * kDegree, 0}, {60 * kDegree, 0}, {75 * kDegree, 0}};
  std::vector<Incidence> views{{0, 0}};
  for (const double theta : {30.0, 60.0, 75.0}) {
    for (const double phi : {0.0, 90.0, 180.0}) views.push_back({theta * kDegree, phi * kDegree});
  }
  const auto measured = measure_radiance(s, from, views);
  const std::string name = "Lambertian grooves sigma " + text(sigma / kDegree) + " rho " + text(kRho);
  const std::array<const char*, 2> forms{"oren_nayar_full", "oren_nayar"};

  std::vector<TheoryRow> rows;
  std::array<double, 2> difference{};
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t v = 0; v < views.size(); ++v) {
      const Estimate& f = measured[i][v].total;
      const bool normal = views[v].theta == 0, mirror = views[v].theta == from[i].theta && views[v].phi > 3;
      const bool retro = views[v].theta == from[i].theta && views[v].phi == 0;
      for (std::size_t k = 0; k < forms.size(); ++k) {
        const double m = value(model(forms[k], {{"rho", kRho}, {"sigma", sigma}}),
                               direction(from[i].theta, 0), direction(views[v].theta, views[v].phi));
        difference[k] += std::abs(f.mean - m) / (static_cast<double>(from.size()) * views.size() * f.mean);
        if (!(normal || mirror || retro)) continue;
        const std::string where = normal ? "normal" : mirror ? "forward" : "retro";
        rows.push_back(theory_row(
            name, "f_r theta_i " + text(from[i].theta / kDegree) + " " + where + ", against " + forms[k], f,
            m, false));
      }
    }
  }
  for (std::size_t k = 0; k < forms.size(); ++k) {
    rows.push_back(theory_row(name, std::string("mean relative difference to ") + forms[k] + " over 30 pairs",
                              {difference[k], kNone}, kNone, false));
  }
  return rows;
}

}  // namespace brdf::micro
