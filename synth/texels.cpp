#include "synth/texels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "brdf/frame.h"
#include "brdf/math.h"
#include "io/csv/csv.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/provenance.h"
#include "io/files/text.h"
#include "io/material/material_json.h"
#include "io/material/settings.h"
#include "io/samples/degrees.h"
#include "synth/random.h"
#include "texel/stack.h"

namespace brdf::synth {
namespace {

constexpr double kSteepestLight = 75;  // degrees
constexpr std::size_t kMostTexels = 8192, kMostImages = 100000;

void check(const TexelOptions& o) {
  io::require_between("--lights", o.lights, 1, double(kMostImages));
  io::require_between("--viewers", o.viewers, 1, double(kMostImages));
  io::require_between("--lights times --viewers", double(o.lights) * o.viewers, 1, double(kMostImages));
  io::require_between("--tilt", o.tilt, 0, 60);
  io::require_between("--noise", o.noise, 0, 2);
  io::require_between("--noise-floor", o.noise_floor, 0, 1e6);
  io::require_between("--saturation", o.saturation, 0, 1e30);
  io::require_between("--dark-level", o.dark_level, 0, 1e6);
  if (!texel::is_in_range(o.rig))
    throw InputError("--light-distance, --viewer-distance, --texel-size: must be from " +
                     io::to_text(texel::kShortest) + " to " + io::to_text(texel::kLongest));
  if (o.rig.is_near() && o.rig.texel_size == 0)
    throw InputError("--light-distance, --viewer-distance: need --texel-size, in their unit");
  io::require_between("--registration", o.registration, 0, 100);
}

// Adds points that are spread evenly on the cap of the hemisphere (Vogel 1979: the golden angle).
void add_points(int count, std::vector<double>& theta, std::vector<double>& phi) {
  constexpr double kGoldenAngle = 137.50776405003785;
  const double cap = 1 - io::cos_degrees(kSteepestLight);
  for (int k = 0; k < count; ++k) {
    const double z = 1 - cap * (k + 0.5) / count, azimuth = std::fmod(k * kGoldenAngle, 360.0);
    const double polar = io::polar_degrees({std::sqrt(1 - z * z), 0, z}).theta;
    theta.push_back(std::round(1e6 * polar) / 1e6);
    phi.push_back(std::round(1e6 * azimuth) / 1e6);
  }
}

bool is_weight(const Material& material, const std::string& name) {
  return std::ranges::any_of(material.terms, [&](const Term& term) {
    return std::ranges::any_of(info(term.form).weights,
                               [&](const ParameterInfo& w) { return w.name == name; });
  });
}

std::string prefix(const Material& material, std::size_t term) {
  return material.terms.size() == 1 ? "" : "terms[" + std::to_string(term) + "].";
}

}  // namespace

Variation parse_variation(const std::string& text) {
  const std::size_t equals = text.find('='), colon = text.find(':');
  Variation v;
  if (equals == std::string::npos || colon == std::string::npos || colon < equals ||
      !io::parse_number(std::string_view(text).substr(equals + 1, colon - equals - 1), v.low) ||
      !io::parse_number(std::string_view(text).substr(colon + 1), v.high) || !(v.low <= v.high))
    throw InputError("--vary " + text + ": must be NAME=LOW:HIGH with LOW at most HIGH");
  v.name = text.substr(0, equals);
  return v;
}

void parse_texels(const std::string& text, TexelOptions& options) {
  const std::size_t cross = text.find('x');
  double width = 0, height = 0;
  const auto fits = [](double n) { return n >= 1 && n <= double(kMostTexels) && n == std::floor(n); };
  if (cross == std::string::npos || !io::parse_number(std::string_view(text).substr(0, cross), width) ||
      !io::parse_number(std::string_view(text).substr(cross + 1), height) || !fits(width) || !fits(height))
    throw InputError("--texels " + text + ": must be WIDTHxHEIGHT, whole numbers from 1 to " +
                     std::to_string(kMostTexels));
  options.width = std::size_t(width);
  options.height = std::size_t(height);
}

Surface::Surface(const Material& material, const TexelOptions& options)
    : material_(material), options_(options) {
  for (const Variation& v : options_.vary) {
    const ParameterInfo parameter = io::parameter_named(material_, v.name, "--vary");
    for (const double end : {v.low, v.high})
      if (end < parameter.min || end > parameter.max)
        throw InputError("--vary " + v.name + ": " + io::to_text(end) + " must be between " +
                         io::to_text(parameter.min) + " and " + io::to_text(parameter.max));
  }
}

// Returns a smooth function with values in [0, 1], a different one for every `which`.
double Surface::field(std::size_t which, double x, double y) const {
  const double u = (x + 0.5) / double(options_.width), v = (y + 0.5) / double(options_.height);
  const double phase = std::fmod(double(which) * 0.6180339887498949, 1.0);
  const double across = 0.5 + 0.25 * double(which % 3), down = 0.5 + 0.25 * double((which + 1) % 4);
  return 0.5 + 0.5 * io::sin_degrees(360 * (across * u + down * v + phase));
}

Material Surface::material(double x, double y) const {
  Material out = material_;
  std::vector<io::Setting> settings;
  for (std::size_t k = 0; k < options_.vary.size(); ++k) {
    const Variation& v = options_.vary[k];
    const bool geometric = v.low > 0 && io::parameter_named(material_, v.name, "--vary").log_scale;
    io::Setting setting{v.name, {}};
    for (std::size_t c = 0; c < (is_weight(out, v.name) ? out.channels.size() : 1); ++c) {
      const double share = field(3 + 7 * k + c, x, y);
      setting.values.push_back(geometric ? v.low * math::exp(share * math::log(v.high / v.low))
                                         : v.low + share * (v.high - v.low));
    }
    settings.push_back(std::move(setting));
  }
  io::apply_settings(out, settings);
  return out;
}

Vec3<double> Surface::normal(double x, double y) const {
  // Both components reach the maximum together at most at one corner of the square.
  const double largest = io::sin_degrees(options_.tilt) * 0.7071067811865475;
  const double a = largest * (2 * field(0, x, y) - 1), b = largest * (2 * field(1, x, y) - 1);
  return {a, b, std::sqrt(1 - a * a - b * b)};
}

texel::Planes Surface::head_of_truth() const {
  texel::Planes out{options_.width, options_.height, {}, {}};
  for (std::size_t t = 0; t < material_.terms.size(); ++t) {
    const ReflectanceInfo& form = info(material_.terms[t].form);
    for (const ParameterInfo& p : form.shape) out.names.push_back(prefix(material_, t) + std::string(p.name));
    for (const std::string& channel : material_.channels)
      for (const ParameterInfo& p : form.weights)
        out.names.push_back(texel::plane_name(prefix(material_, t) + std::string(p.name), channel));
  }
  for (const char* name : {"normal.x", "normal.y", "normal.z"}) out.names.emplace_back(name);
  return out;
}

void Surface::fill_truth(const texel::Region& rows, std::vector<std::vector<float>>& values) const {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double x = double(rows.x + k % rows.width), y = double(rows.y + k / rows.width);
    const Material here = material(x, y);
    const Vec3<double> n = normal(x, y);
    std::size_t plane = 0;
    for (const Term& term : here.terms) {
      for (const double p : term.shape[0]) values[plane++][k] = float(p);
      for (const auto& channel : term.weights)
        for (const double p : channel) values[plane++][k] = float(p);
    }
    for (const double component : {n.x, n.y, n.z}) values[plane++][k] = float(component);
  }
}

io::SampleTable stack_directions(const TexelOptions& options) {
  std::vector<double> theta_i, phi_i, theta_o, phi_o;
  add_points(options.lights, theta_i, phi_i);
  if (options.viewers == 1) {
    theta_o = phi_o = {0};
  } else {
    add_points(options.viewers, theta_o, phi_o);
  }
  io::SampleTable table;
  for (std::size_t o = 0; o < theta_o.size(); ++o)
    for (std::size_t i = 0; i < theta_i.size(); ++i)
      table.add_directions(theta_i[i], phi_i[i], theta_o[o], phi_o[o]);
  return table;
}

namespace {

std::string image_name(int k) {
  char name[32];
  std::snprintf(name, sizeof name, "image_%05d.exr", k);
  return name;
}

// Throws InputError if the folder contains other images, which would be mistaken for images of this stack.
void check_folder(const std::filesystem::path& folder, const TexelOptions& options) {
  if (!std::filesystem::is_directory(folder)) return;
  std::set<std::string> own;
  for (int k = 0; k < options.lights * options.viewers; ++k) own.insert(image_name(k));
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (texel::is_image(entry.path()) && !own.contains(entry.path().filename().string()))
      throw InputError("-o " + folder.string() + ": holds " + entry.path().filename().string() +
                       ", which would be read as an image of this stack");
}

// Returns one reading. Two random numbers are drawn in any case, so that a setting has no side effects on
// the other random numbers.
float reading(double value, const TexelOptions& o, NormalPairs& random) {
  const NormalPairs::Pair z = random.next();
  if (o.noise > 0) value *= math::exp(o.noise * z.first - 0.5 * o.noise * o.noise);
  if (o.noise_floor > 0) value += o.noise_floor * z.second;
  value += o.dark_level;
  if (o.saturation > 0) value = std::min(value, o.saturation);
  return float(value);
}

void record(const Material& material, const TexelOptions& o, io::SampleTable& lights) {
  lights.add_comment("sample", "synthetic stack");
  for (const auto& [key, value] : io::provenance_fields(io::provenance(o.seed)))
    lights.add_comment(key, value);
  lights.add_comment("material", io::to_line(io::to_json(material)));
  if (o.registration > 0) lights.add_comment("registration", io::to_text(o.registration));
  if (std::isfinite(o.rig.light_distance))
    lights.add_comment("light_distance", io::to_text(o.rig.light_distance));
  if (std::isfinite(o.rig.viewer_distance))
    lights.add_comment("viewer_distance", io::to_text(o.rig.viewer_distance));
  if (o.rig.is_near()) lights.add_comment("texel_size", io::to_text(o.rig.texel_size));
  lights.add_comment("dark_level", io::to_text(o.dark_level));
  lights.add_comment("saturation", o.saturation > 0 ? io::to_text(o.saturation) : "none");
}

// A surface evaluated at the texels of some rows.
struct Grid {
  std::vector<Material> materials;
  std::vector<Vec3<double>> normals;
};

struct Shift {
  double x = 0, y = 0;
};

void sample(const Surface& surface, const texel::Region& rows, const Shift& shift, Grid& grid) {
  grid.materials.clear(), grid.normals.clear();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double x = double(rows.x + k % rows.width) + shift.x, y = double(rows.y + k / rows.width) + shift.y;
    grid.materials.push_back(surface.material(x, y));
    grid.normals.push_back(surface.normal(x, y));
  }
}

// The shift of an image against the others.
Shift shift_of(const TexelOptions& o, std::uint64_t image) {
  if (o.registration <= 0) return {};
  NormalPairs random(o.seed + 0xbf58476d1ce4e5b9u * (image + 1));
  const NormalPairs::Pair shift = random.next();
  return {o.registration * shift.first, o.registration * shift.second};
}

// A surface of more texels is evaluated again for every image, because a texel takes about 300 bytes.
constexpr std::size_t kMostKept = std::size_t(1) << 20;

}  // namespace

void write_stack(const std::filesystem::path& folder, const Material& material, const TexelOptions& options,
                 const io::Progress& progress) {
  check(options);
  check_folder(folder, options);
  const Surface surface(material, options);
  const std::size_t channels = material.channels.size();
  const texel::Region all{0, 0, options.width, options.height};
  const bool is_kept = options.registration <= 0 && all.size() <= kMostKept;
  Grid kept;
  if (is_kept) sample(surface, all, {}, kept);
  io::SampleTable lights = stack_directions(options);
  record(material, options, lights);
  const DirectionArrays<double> arrays = io::unit_directions(lights);
  const Directions<double> directions = arrays.view();
  io::make_folder(folder / "truth");
  std::vector<std::string> layers = material.channels;
  if (layers == std::vector<std::string>{"r", "g", "b"}) layers = {"R", "G", "B"};
  io::parallel_in_order(
      int(directions.count), int(io::all_processors()), progress,
      [&](int k) {
        NormalPairs random(options.seed + 0x9e3779b97f4a7c15u * std::uint64_t(k + 1));
        const Shift shift = shift_of(options, std::uint64_t(k));
        const Vec3<double> light = directions.wi(std::size_t(k)), viewer = directions.wo(std::size_t(k));
        std::vector<double> value(channels);
        Grid own;
        const auto fill = [&](const texel::Region& rows, std::vector<std::vector<float>>& out) {
          if (!is_kept) sample(surface, rows, shift, own);
          const Grid& grid = is_kept ? kept : own;
          const std::size_t before = is_kept ? rows.y * rows.width : 0;
          for (std::size_t t = 0; t < rows.size(); ++t) {
            const Vec3<double> place =
                texel::place_of(options.rig, options.width, options.height, double(t % rows.width),
                                double(rows.y + t / rows.width));
            const Vec3<double> wi = texel::direction_from(place, light, options.rig.light_distance),
                               wo = texel::direction_from(place, viewer, options.rig.viewer_distance);
            const double irradiance = texel::irradiance_at(place, light, options.rig.light_distance);
            const Vec3<double>& normal = grid.normals[before + t];
            eval_cos(grid.materials[before + t], in_frame_of(normal, wi), in_frame_of(normal, wo), value);
            for (std::size_t c = 0; c < channels; ++c)
              out[c][t] = reading(value[c] * irradiance, options, random);
          }
        };
        texel::write_planes(folder / image_name(k), {options.width, options.height, layers, {}}, fill);
        return 0;
      },
      [](int) {});
  texel::write_planes(folder / "truth" / "truth.exr", surface.head_of_truth(),
                      [&](const texel::Region& rows, std::vector<std::vector<float>>& values) {
                        surface.fill_truth(rows, values);
                      });
  io::write_samples(folder / texel::kLightsFile, lights);
}

}  // namespace brdf::synth
