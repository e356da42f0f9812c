// Comparisons of f_r: height fields and grooves with the forms derived for them.
#include <algorithm>
#include <cmath>

#include "micro/cavity.h"
#include "micro/model.h"
#include "micro/theory.h"
#include "micro/theory_text.h"

namespace brdf::micro {
namespace {

constexpr double kLeastPower = 1e-4;  // cells with less power are not judged
constexpr Angle kRetro = 20_deg;      // masking and shadowing are one event within this angle
constexpr double kApart = 0.05;       // relative difference that counts
constexpr double kSignificance = 2;   // if it exceeds so many standard errors

Simulation with(const TheoryOptions& options) {
  Simulation s;
  s.seed = options.seed;
  s.threads = options.threads;
  return s;
}

// Returns a cell side that is small compared with the width of the lobe (2 alpha in the outgoing angle).
Angle cell_width(double alpha) {
  return degrees(std::clamp(alpha * 25, 2.0, 5.0));
}

std::string in_words(Angle angle) {
  return io::short_number(angle.degrees());
}

std::string in_plane(Angle theta_o, bool forward) {
  return "theta_o " + in_words(theta_o) + (forward ? " forward" : " backward");
}

// Adds one row for every cell of the plane of incidence with sufficient power.
void add_in_plane(std::vector<TheoryRow>& rows, const std::string& surface, const Scatter& scatter,
                  const Cells& cells, const Material& form, bool exact, double least_power) {
  for (int c = 0; c < cells.size(); ++c) {
    const bool back = std::abs(cells[c].centre_phi().radians()) < 1e-9,
               forward = std::abs((cells[c].centre_phi() - 180_deg).radians()) < 1e-9;
    const Estimate& f = scatter.f[0][c];
    if (!(back || forward) || f.mean * cells[c].projected_solid_angle() < least_power) continue;
    rows.push_back(theory_row(surface,
                              "f_r theta_i " + in_words(scatter.incidence.theta) + ", " +
                                  in_plane(cells[c].centre_theta(), forward) + ", single",
                              f, cell_mean(form, scatter.incidence, cells[c]), exact));
  }
}

double model_albedo(const Material& form, const Incidence& from) {
  const Cells fine(1_deg);
  double sum = 0;
  for (int c = 0; c < fine.size(); ++c)
    sum += cell_mean(form, from, fine[c]) * fine[c].projected_solid_angle();
  return sum;
}

// Returns the single-reflection albedo with its standard error, from a simulation limited to one reflection.
TheoryRow albedo_row(const std::string& surface, const Scatter& scatter, const Material& form, bool exact) {
  return theory_row(surface, "albedo theta_i " + in_words(scatter.incidence.theta) + ", single",
                    scatter.albedo, model_albedo(form, scatter.incidence), exact);
}

}  // namespace

CellAgreement agreement(const Scatter& scatter, const Cells& cells, const Material& form) {
  CellAgreement a;
  const Vec wi = direction(scatter.incidence.theta, {});
  for (int c = 0; c < cells.size(); ++c) {
    const Estimate& f = scatter.f[0][c];
    const double solid = cells[c].projected_solid_angle();
    if (f.mean * solid < kLeastPower) continue;
    const double m = cell_mean(form, scatter.incidence, cells[c]);
    const bool apart = std::abs(f.mean - m) - kApart * m > kSignificance * f.standard_error;
    if (std::acos(std::min(dot(wi, cells[c].centre()), 1.0)) < kRetro.radians()) {
      ++a.retro_cells;
      a.retro_apart += apart;
      a.worst_retro = std::max(a.worst_retro, f.mean / m - 1);
      continue;
    }
    ++a.cells;
    a.apart += apart;
    if (apart && std::abs(f.mean / m - 1) > std::abs(a.worst_apart)) {
      a.worst_apart = f.mean / m - 1;
      a.worst_apart_at = {cells[c].centre_theta(), cells[c].centre_phi()};
    }
    a.power += f.mean * solid;
    a.power_apart += apart ? f.mean * solid : 0;
    a.mean_error += f.standard_error / m;
  }
  a.mean_error /= std::max(a.cells, 1);
  return a;
}

std::vector<TheoryRow> compare_single_bounce(const TheoryOptions& options, double alpha, Angle theta_i) {
  Simulation s = with(options);
  s.geometry = HeightField{.alpha_x = alpha, .alpha_y = alpha};
  s.surfaces = 16 * options.effort;
  s.rays = 1 << 18;
  s.max_bounces = 1;
  const Cells cells(cell_width(alpha));
  const Scatter scatter = measure_scatter(s, {{theta_i, {}}}, cells)[0];
  const Material form = model(form_of_rough_mirrors(), {{Role::diffuse, 0},
                                                        {Role::specular, 1},
                                                        {Role::f0, 1},
                                                        {Role::width, alpha},
                                                        {Role::width_across, alpha}});
  const std::string name = gaussian_name(alpha), at = "theta_i " + in_words(theta_i) + ": ";

  std::vector<TheoryRow> rows{albedo_row(name, scatter, form, false)};
  const CellAgreement a = agreement(scatter, cells, form);
  const auto add = [&](const std::string& quantity, double number) {
    rows.push_back(theory_row(name, at + quantity, {number, kNone}, kNone, false));
  };
  add("cells judged", a.cells);
  add("mean relative standard error of a cell", a.mean_error);
  add("share of cells not significantly beyond 5 %", 1 - a.apart / std::max<double>(a.cells, 1));
  add("share of their power in such cells", 1 - a.power_apart / std::max(a.power, 1e-300));
  if (a.apart > 0)
    add("greatest relative difference of the others, at theta_o " + in_words(a.worst_apart_at.theta) +
            " phi " + in_words(a.worst_apart_at.phi),
        a.worst_apart);
  add("cells within 20 degrees of the retro direction", a.retro_cells);
  add("of these significantly beyond 5 %", a.retro_apart);
  if (a.retro_cells > 0) add("greatest relative excess among them", a.worst_retro);
  add_in_plane(rows, name, scatter, cells, form, false, kLeastPower);
  explain(rows,
          "the form masks and shadows microfacets as if their slopes were independent of the heights around "
          "them: microfacets tilted towards a grazing viewing direction are masked less (the form is too "
          "dark at grazing angles), and near retroreflection masking and shadowing are the same event (the "
          "form is too dark there)");
  return rows;
}

std::vector<TheoryRow> compare_mirror_grooves(const TheoryOptions& options, Angle theta_i) {
  constexpr double kAlpha = 0.4, kEta = 1.5;
  Simulation s = with(options);
  s.geometry = Grooves{GrooveAngles::beckmann, kAlpha, 1024};
  s.facets.eta = kEta;
  s.surfaces = 512 * options.effort;
  s.rays = 1 << 13;
  s.max_bounces = 1;
  const Cells cells(10_deg);
  const Scatter scatter = measure_scatter(s, {{theta_i, {}}}, cells)[0];
  const Material form = model(form_of_mirror_grooves(), {{Role::diffuse, 0},
                                                         {Role::specular, 1},
                                                         {Role::width, kAlpha},
                                                         {Role::width_across, kAlpha},
                                                         {Role::index, kEta}});
  const std::string name =
      "mirror grooves alpha " + io::short_number(kAlpha) + " eta " + io::short_number(kEta);
  std::vector<TheoryRow> rows{albedo_row(name, scatter, form, true)};
  add_in_plane(rows, name, scatter, cells, form, true, kLeastPower);
  return rows;
}

std::vector<TheoryRow> compare_lambert_grooves(const TheoryOptions& options, Angle sigma) {
  constexpr double kRho = 0.9;
  // An albedo so small that interreflection vanishes. The form then gives its direct term.
  constexpr double kThin = 1e-6;
  Simulation s = with(options);
  s.geometry = Grooves{GrooveAngles::oren_nayar, sigma.radians(), 1024};
  s.facets = {.reflection = Reflection::lambert, .rho = kRho};
  s.surfaces = 32 * options.effort;
  s.rays = 1 << 14;
  const std::vector<Incidence> from{{30_deg, {}}, {60_deg, {}}, {75_deg, {}}};
  std::vector<Incidence> views{{}};
  for (const Angle theta : {30_deg, 60_deg, 75_deg})
    for (const Angle phi : {0_deg, 90_deg, 180_deg}) views.push_back({theta, phi});
  const auto measured = measure_radiance(s, from, views);
  const std::string name = "Lambertian grooves sigma " + in_words(sigma) + " rho " + io::short_number(kRho);
  const auto with_albedo = [&](const Reflectance& form, double albedo) {
    return model(form, {{Role::diffuse, albedo}, {Role::slope, sigma.radians()}});
  };
  const Reflectance full_form = form_with_interreflection(), qualitative_form = form_of_lambert_grooves();
  const Material full = with_albedo(full_form, kRho), direct = with_albedo(full_form, kThin),
                 qualitative = with_albedo(qualitative_form, kRho);
  const std::string full_name(full_form.info().name), qualitative_name(qualitative_form.info().name);

  std::vector<TheoryRow> rows;
  double full_difference = 0, qualitative_difference = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec wi = direction(from[i].theta, {});
    for (std::size_t v = 0; v < views.size(); ++v) {
      const Vec wo = direction(views[v].theta, views[v].phi);
      const Radiance& f = measured[i][v];
      const double f_full = value(full, wi, wo), f_qualitative = value(qualitative, wi, wo);
      const double share = 1 / (static_cast<double>(from.size()) * views.size() * f.total.mean);
      full_difference += std::abs(f.total.mean - f_full) * share;
      qualitative_difference += std::abs(f.total.mean - f_qualitative) * share;
      const bool normal = views[v].theta == Angle{}, in_line = views[v].theta == from[i].theta;
      if (!normal && (!in_line || views[v].phi == 90_deg)) continue;
      const std::string where = "f_r theta_i " + in_words(from[i].theta) + " " +
                                (normal                    ? "normal"
                                 : views[v].phi == 180_deg ? "forward"
                                                           : "retro");
      const double f_direct = value(direct, wi, wo) / kThin * kRho;
      rows.push_back(theory_row(name, where + ", against " + full_name, f.total, f_full, false));
      rows.push_back(
          theory_row(name, where + ", against " + qualitative_name, f.total, f_qualitative, false));
      rows.push_back(theory_row(name, where + ", one reflection, against the cavity integral", f.f[0],
                                kRho * groove_single_reflection(sigma.radians(), wi, wo), true));
      rows.push_back(theory_row(name, where + ", one reflection, against " + full_name + "'s direct term",
                                f.f[0], f_direct, false));
      rows.push_back(theory_row(name,
                                where + ", two reflections, against " + full_name + "'s interreflection",
                                f.f[1], f_full - f_direct, false));
    }
  }
  const auto add = [&](const std::string& quantity, double number) {
    rows.push_back(theory_row(name, quantity, {number, kNone}, kNone, false));
  };
  add("mean relative difference to " + full_name + " over 30 pairs", full_difference);
  add("mean relative difference to " + qualitative_name + " over 30 pairs", qualitative_difference);
  explain(rows,
          "both forms are fits to the cavity integral (Oren and Nayar 1994): the direct term was fitted, the "
          "interreflection term represents two reflections, and the qualitative form omits this term and one "
          "coefficient");
  return rows;
}

}  // namespace brdf::micro
