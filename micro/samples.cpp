#include "micro/samples.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"
#include "io/files/text.h"
#include "micro/model.h"

namespace brdf::micro {
namespace {

struct Range {
  std::string name;
  double min, max;
};

struct Kind {
  const char* name;
  bool grooves, lambert;
  std::vector<Range> parameters;
};

// Names of the parameters of surfaces. They equal the parameter names of the corresponding forms.
struct Names {
  std::string width, along, across, slope, index, albedo;
};

const Names& names() {
  static const Names all = [] {
    const ReflectanceInfo mirrors = form_of_mirror_grooves().info(),
                          lambert = form_of_lambert_grooves().info();
    const auto shape = [](const ReflectanceInfo& form, Role role) {
      return std::string(form.shape[std::size_t(form.shape_index(role))].name);
    };
    return Names{std::string(mirrors.tied_name()),
                 shape(mirrors, Role::width),
                 shape(mirrors, Role::width_across),
                 shape(lambert, Role::slope),
                 shape(mirrors, Role::index),
                 std::string(lambert.weights[std::size_t(lambert.weight_index(Role::diffuse))].name)};
  }();
  return all;
}

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = [] {
    const Range width{names().width, 0.01, 1.5}, along{names().along, 0.01, 1.5},
        across{names().across, 0.01, 1.5}, slope{names().slope, 0.001, 1.2}, index{names().index, 1, 5},
        albedo{names().albedo, 0, 1};
    return std::vector<Kind>{{"gaussian", false, false, {width, along, across, index}},
                             {"lambert_gaussian", false, true, {width, along, across, albedo}},
                             {"mirror_grooves", true, false, {width, index}},
                             {"lambert_grooves", true, true, {slope, albedo}}};
  }();
  return all;
}

const Kind& find_kind(const std::string& name) {
  for (const Kind& kind : kinds())
    if (name == kind.name) return kind;
  throw InputError("--microsurface " + name + ": must be one of " + io::joined(surface_names()));
}

void check(const SampleSettings& s, const Kind& kind) {
  for (const auto& [name, value] : s.parameters) {
    const auto found = std::ranges::find_if(
        kind.parameters, [&, parameter = name](const Range& r) { return parameter == r.name; });
    if (found == kind.parameters.end()) {
      std::vector<std::string> known;
      for (const Range& r : kind.parameters) known.push_back(r.name);
      throw InputError("--set " + name + ": " + kind.name + " has " + io::joined(known));
    }
    io::require_between("--set " + name, value, found->min, found->max);
  }
  for (const double theta : s.theta_i) io::require_between("--theta-i", theta, 0, 89);
  for (const double azimuth : s.azimuths) io::require_between("--azimuths", azimuth, -360, 360);
  if (s.cell != 0) io::require_between("--cell", s.cell, 0.25, 30);
  io::require_between("--bounces", s.bounces, 1, 1000);
  if (s.surfaces != 0) io::require_between("--surfaces", s.surfaces, 8, 1e6);
  io::require_between("--size", s.size, 64, 4096);
  if (s.size % 2 != 0) throw InputError("--size " + std::to_string(s.size) + ": must be even");
  io::require_between("--rays", static_cast<double>(s.rays), 0, 1e10);
  io::require_between("--min-power", s.min_power, 0, 1);
  if (s.gpu && kind.lambert)
    throw InputError("--gpu: follows rays over mirrors only; the facets of " + s.surface +
                     " draw random numbers on the way. Leave --gpu out");
}

std::optional<double> parameter(const SampleSettings& s, const std::string& name) {
  for (const auto& [key, value] : s.parameters)
    if (key == name) return value;
  return std::nullopt;
}

Simulation simulation(const SampleSettings& s, const Kind& kind) {
  Simulation result;
  const double alpha = parameter(s, names().width).value_or(0.3);
  if (kind.grooves && kind.lambert)
    result.geometry = Grooves{GrooveAngles::oren_nayar, parameter(s, names().slope).value_or(0.35), 1024};
  else if (kind.grooves)
    result.geometry = Grooves{GrooveAngles::beckmann, alpha, 1024};
  else
    result.geometry = HeightField{.alpha_x = parameter(s, names().along).value_or(alpha),
                                  .alpha_y = parameter(s, names().across).value_or(alpha),
                                  .size = s.size};
  result.facets.reflection = kind.lambert ? Reflection::lambert : Reflection::mirror;
  result.facets.eta = parameter(s, names().index).value_or(0);
  result.facets.rho = parameter(s, names().albedo).value_or(1);
  result.surfaces = s.surfaces > 0 ? s.surfaces : kind.grooves && !kind.lambert ? 512 : 16;
  // A mirror groove reflects into two directions only. Many grooves with few rays each are therefore most
  // efficient.
  result.rays = s.rays > 0 ? s.rays : kind.lambert ? 1 << 12 : kind.grooves ? 1 << 13 : 1 << 18;
  result.max_bounces = s.bounces;
  result.seed = s.seed;
  result.threads = s.threads;
  if (s.gpu) result.device = std::make_shared<DevicePaths>();
  return result;
}

double cell_width(const SampleSettings& s, const Kind& kind, const Simulation& sim) {
  if (s.cell != 0) return s.cell;
  if (kind.lambert) return 10;
  const auto* field = std::get_if<HeightField>(&sim.geometry);
  const double alpha =
      field ? std::min(field->alpha_x, field->alpha_y) : std::get<Grooves>(sim.geometry).width;
  // The half width of a lobe is about 2 alpha, which is 115 degrees times alpha.
  return std::clamp(20 * alpha, 0.5, 5.0);
}

double in_turn(double phi) {
  const double rest = std::fmod(phi, 360);
  return rest < 0 ? rest + 360 : rest;
}

class TableWriter {
 public:
  TableWriter(bool orders, const Cells& cells) : orders_(orders), cells_(cells) {
    table.set_channels(orders ? std::vector<std::string>{"order_1", "order_2", "order_3_up"}
                              : std::vector{std::string("fr")});
  }

  void add(double theta_i, double phi_i, int cell, const Estimate (&f)[kOrderClasses],
           const Estimate& total) {
    table.add_directions(theta_i, phi_i, rounded(cells_[cell].centre_theta().degrees()),
                         in_turn(phi_i + rounded(cells_[cell].centre_phi().degrees())));
    for (std::size_t c = 0; c < table.channels.size(); ++c) {
      const Estimate& e = orders_ ? f[c] : total;
      table.values[c].push_back(e.mean);
      table.sigma[c].push_back(std::max(e.standard_error, 1e-300));  // the format requires sigma > 0
    }
  }

  io::SampleTable table;

 private:
  // Centres are simple fractions of a degree; the conversion to radians changes their last digits.
  static double rounded(double angle) { return std::round(angle * 1e9) / 1e9; }

  bool orders_;
  const Cells& cells_;
};

// One incidence: polar angle and azimuth in degrees, with the values of the table.
struct Light {
  double theta, phi;
};

std::vector<Incidence> incidences(const std::vector<Light>& lights) {
  std::vector<Incidence> all;
  for (const Light& light : lights) all.push_back({degrees(light.theta), degrees(light.phi)});
  return all;
}

void add_mirrors(const SampleSettings& s, const Simulation& sim, const std::vector<Light>& lights,
                 const Cells& cells, const Progress& progress, TableWriter& writer) {
  const std::vector<Scatter> measured = measure_scatter(sim, incidences(lights), cells, progress);
  double lost = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Scatter& one = measured[i];
    for (int c = 0; c < cells.size(); ++c) {
      const double share = one.total[c].mean * cells[c].projected_solid_angle();
      if (share < s.min_power || share == 0) continue;
      writer.add(lights[i].theta, lights[i].phi, c, {one.f[0][c], one.f[1][c], one.f[2][c]}, one.total[c]);
    }
    lost = std::max(lost, one.account.leaked + (s.bounces >= 64 ? one.account.beyond : 0));
  }
  if (lost > 1e-5) {
    writer.table.warnings.push_back(
        "rays with " + io::to_text(lost) + " of the power were lost (still inside after " +
        std::to_string(s.bounces) + " reflections, or after the limit of 2^24 steps)");
  }
}

// The cells belong to one azimuth of the light. A rotated sample is measured with rotated cells.
void add_lambert(const Simulation& sim, const std::vector<Light>& lights, const Cells& cells,
                 const Progress& progress, TableWriter& writer) {
  for (std::size_t begin = 0, end = 0; begin < lights.size(); begin = end) {
    while (end < lights.size() && lights[end].phi == lights[begin].phi) ++end;
    const std::vector<Light> turn(lights.begin() + begin, lights.begin() + end);
    std::vector<Incidence> views;
    for (int c = 0; c < cells.size(); ++c)
      views.push_back({cells[c].centre_theta(), cells[c].centre_phi() + degrees(turn[0].phi)});
    const auto measured = measure_radiance(sim, incidences(turn), views, progress);
    for (std::size_t i = 0; i < turn.size(); ++i) {
      for (int c = 0; c < cells.size(); ++c)
        writer.add(turn[i].theta, turn[i].phi, c, measured[i][c].f, measured[i][c].total);
    }
  }
}

void record(const SampleSettings& s, const Simulation& sim, double cell, io::SampleTable& table) {
  const auto add = [&](const char* key, const std::string& value) {
    table.metadata.emplace_back(key, value);
  };
  add("sample", "traced microsurface " + s.surface);
  add("instrument", "virtual goniophotometer (brdf synth --microsurface)");
  add("source", "computed; truth below");
  add("licence", "Apache-2.0");
  for (auto& field : io::provenance_fields(io::provenance(s.seed))) table.metadata.push_back(field);
  std::string truth = s.surface;
  if (const auto* field = std::get_if<HeightField>(&sim.geometry)) {
    truth += " " + names().along + "=" + io::to_text(field->alpha_x) + " " + names().across + "=" +
             io::to_text(field->alpha_y) + " size=" + std::to_string(field->size) +
             " correlation_length=" + io::to_text(field->correlation_length);
  } else {
    const Grooves& grooves = std::get<Grooves>(sim.geometry);
    truth += " " + (grooves.angles == GrooveAngles::oren_nayar ? names().slope : names().width) + "=" +
             io::to_text(grooves.width) + " grooves=" + std::to_string(grooves.count);
  }
  if (sim.facets.reflection == Reflection::lambert)
    truth += " " + names().albedo + "=" + io::to_text(sim.facets.rho);
  if (sim.facets.reflection == Reflection::mirror)
    truth +=
        sim.facets.eta == 0 ? " perfect reflector" : " " + names().index + "=" + io::to_text(sim.facets.eta);
  add("truth", truth);
  add("theta_i", io::joined_numbers(s.theta_i));
  add("azimuths", io::joined_numbers(s.azimuths));
  add("cell", io::to_text(cell) + " degrees");
  add("bounces", std::to_string(s.bounces));
  add("surfaces", std::to_string(sim.surfaces));
  add("rays", std::to_string(sim.rays) + " per surface and direction");
  if (sim.facets.reflection == Reflection::mirror) add("min_power", io::to_text(s.min_power));
  if (sim.device) add("device", sim.device->device());
}

}  // namespace

std::vector<std::string> surface_names() {
  std::vector<std::string> names;
  for (const Kind& kind : kinds()) names.emplace_back(kind.name);
  return names;
}

io::SampleTable trace_samples(const SampleSettings& s, const Progress& progress) {
  const Kind& kind = find_kind(s.surface);
  check(s, kind);
  const Simulation sim = simulation(s, kind);
  const double width = cell_width(s, kind, sim);
  const Cells cells(degrees(width));
  TableWriter writer(s.orders, cells);
  std::vector<Light> lights;
  for (const double azimuth : s.azimuths)
    for (const double theta : s.theta_i) lights.push_back({theta, in_turn(180 - azimuth)});
  if (kind.lambert)
    add_lambert(sim, lights, cells, progress, writer);
  else
    add_mirrors(s, sim, lights, cells, progress, writer);
  if (writer.table.rows() == 0) throw InputError("no cell receives --min-power of the light");
  record(s, sim, width, writer.table);
  return std::move(writer.table);
}

}  // namespace brdf::micro
