#include "io/formats/rgl.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include "brdf/scalar.h"
#include "io/columns/stated_quantity.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/formats/rgl_stack.h"
#include "io/formats/tensor_file.h"
#include "io/samples/degrees.h"

namespace brdf::io::rgl {
namespace {

// Maps polar angles to [0, 1], densely near the normal.
double theta_to_unit(double theta) {
  return std::sqrt(theta * (2 / kPi));
}
double phi_to_unit(double phi) {
  return (phi + kPi) / (2 * kPi);
}

// Returns a direction mapped to the part of the circle of azimuths that the file holds, according to its
// symmetry: half a turn (2), or two planes of symmetry (4). `of` is the direction of incidence.
Vec3<double> folded(const Vec3<double>& w, const Vec3<double>& of, int symmetry) {
  const double across = of.y, along = symmetry == 4 ? of.x : across;
  return {std::signbit(along) ? w.x : -w.x, std::signbit(across) ? w.y : -w.y, w.z};
}

std::string band_name(float nm) {
  char digits[32];
  return std::string(digits, std::to_chars(digits, digits + sizeof digits, nm).ptr) + "nm";
}

double polar_angle(const Vec3<double>& w) {
  return std::atan2(std::sqrt(w.x * w.x + w.y * w.y), w.z);
}

}  // namespace

struct Measurement::Data {
  std::string description;
  std::vector<std::string> channels;
  std::vector<float> phi_i, theta_i;
  Stack sigma, ndf, bands;  // in `bands` the channel is a faster dimension than theta_i
  Warp vndf;
  bool has_jacobian = true;
  int symmetry = 1;  // in azimuth; the file is smaller by this factor

  // One or two azimuths carry no dependence on azimuth.
  bool isotropic() const { return phi_i.size() <= 2; }
};

Measurement::~Measurement() = default;

const std::string& Measurement::description() const {
  return data_->description;
}
const std::vector<std::string>& Measurement::channels() const {
  return data_->channels;
}
bool Measurement::isotropic() const {
  return data_->isotropic();
}
int Measurement::symmetry() const {
  return data_->symmetry;
}

Measurement::Measurement(const Content& content) : data_(std::make_unique<Data>()) {
  const TensorFile file(content);
  const auto refuse = [&](const std::string& why) { throw InputError(content.name + ": RGL file: " + why); };
  data_->description = file.bytes("description");
  data_->phi_i = file.floats("phi_i");
  data_->theta_i = file.floats("theta_i");
  const bool is_rgb = file.has("rgb");
  if (is_rgb)
    data_->channels = {"r", "g", "b"};
  else
    for (const float nm : file.floats("wavelengths")) data_->channels.push_back(band_name(nm));
  const std::string values = is_rgb ? "rgb" : "spectra";
  const auto &ndf = file.shape("ndf"), &sigma = file.shape("sigma"), &vndf = file.shape("vndf"),
             &bands = file.shape(values);
  const auto ascends = [](const std::vector<float>& nodes) {
    return !nodes.empty() && std::ranges::adjacent_find(nodes, std::greater_equal<>()) == nodes.end();
  };
  const auto at_least_two = [](std::size_t a, std::size_t b) { return a >= 2 && b >= 2; };
  const std::size_t azimuths = data_->phi_i.size(), angles = data_->theta_i.size();
  if (!ascends(data_->phi_i) || !ascends(data_->theta_i) || ndf.size() != 2 || sigma.size() != 2 ||
      vndf.size() != 4 || bands.size() != 5 || vndf[0] != azimuths || vndf[1] != angles ||
      bands[0] != azimuths || bands[1] != angles || bands[2] != data_->channels.size() || bands[2] == 0 ||
      !at_least_two(ndf[0], ndf[1]) || !at_least_two(sigma[0], sigma[1]) || !at_least_two(vndf[2], vndf[3]) ||
      !at_least_two(bands[3], bands[4]))
    refuse("the sizes of the fields are inconsistent");
  if (!data_->isotropic()) {
    const double span = static_cast<double>(data_->phi_i.back()) - data_->phi_i.front();
    const double part = std::round(2 * kPi / span);
    if (part != 1 && part != 2 && part != 4)
      refuse("phi_i spans neither a full circle, nor a half, nor a quarter of a circle");
    data_->symmetry = static_cast<int>(part);
  }
  data_->has_jacobian = !file.has("jacobian") || file.bytes("jacobian") != std::string(1, '\0');
  data_->ndf = Stack(file.floats("ndf"), ndf[1], ndf[0]);
  data_->sigma = Stack(file.floats("sigma"), sigma[1], sigma[0]);
  data_->vndf = Warp(file.floats("vndf"), azimuths * angles, vndf[3], vndf[2]);
  data_->bands = Stack(file.floats(values), bands[4], bands[3]);
}

void Measurement::eval_cos_o(const Vec3<double>& light, const Vec3<double>& viewer,
                             std::span<double> out) const {
  const bool folds = data_->symmetry > 1;
  const Vec3<double> wi = folds ? folded(light, light, data_->symmetry) : light;
  const Vec3<double> wo = folds ? folded(viewer, light, data_->symmetry) : viewer;
  const Vec3<double> sum = wi + wo;
  const double theta_i = polar_angle(wi), phi_i = std::atan2(wi.y, wi.x);
  const double phi_m = std::atan2(sum.y, sum.x);
  const double mx = theta_to_unit(polar_angle(sum));
  double my = phi_to_unit(data_->isotropic() ? phi_m - phi_i : phi_m);
  my -= std::floor(my);
  const Slices slices = find_slices(data_->phi_i, phi_i, data_->theta_i, theta_i);
  double x, y;
  data_->vndf.invert(mx, my, slices, x, y);
  const double scale = data_->has_jacobian
                           ? data_->ndf.eval(mx, my, {}) /
                                 (4 * data_->sigma.eval(theta_to_unit(theta_i), phi_to_unit(phi_i), {}))
                           : 1;
  const std::size_t channels = data_->channels.size();
  for (std::size_t c = 0; c < channels; ++c) {
    double mixed = 0;
    for (std::size_t s = 0; s < slices.count; ++s)
      mixed += slices.weight[s] * data_->bands.eval(x, y, {{slices.index[s] * channels + c}, {1}, 1});
    const double value = mixed * scale;
    out[c] = value < 0 ? 0 : value;  // NaN stays NaN
  }
}

bool recognises(const Content& content) {
  return content.bytes.starts_with(std::string_view("tensor_file\0", 12));
}

namespace {

// Returns the azimuths of incidence at which a file is sampled: every 30 degrees of the part that an
// anisotropic file holds.
std::vector<double> azimuths_of(const Measurement& measurement) {
  if (measurement.isotropic()) return {180};
  std::vector<double> azimuths;
  const int last = measurement.symmetry() == 4 ? 90 : 360 / measurement.symmetry() - 30;
  for (int turn = 0; turn <= last; turn += 30) azimuths.push_back(180 + turn);
  return azimuths;
}

}  // namespace

SampleTable read(const Content& content, const Supplied& supplied) {
  require_f_r(content.name, supplied);
  const Measurement measurement(content);
  SampleTable table;
  table.source = content.name;
  table.format = "rgl";
  table.set_channels(measurement.channels());
  table.add_comment("sample", measurement.description());
  table.add_comment("instrument", "RGL gonio-photometer, adaptive tensor file");
  std::vector<double> values(table.channels.size());
  const auto add = [&](double theta_i, double phi_i, double theta_o, double phi_o) {
    const Vec3<double> wi = unit_vector(theta_i, phi_i), wo = unit_vector(theta_o, phi_o);
    measurement.eval_cos_o(wi, wo, values);
    if (!std::ranges::all_of(values, [&](double v) { return std::isfinite(v / wo.z); })) {
      ++table.skipped;
      return;
    }
    table.add_directions(theta_i, phi_i, theta_o, phi_o);
    for (std::size_t c = 0; c < values.size(); ++c) table.values[c].push_back(values[c] / wo.z);
  };
  // Half of the hemisphere is sufficient for an isotropic file.
  const int last = measurement.isotropic() ? 180 : 345, step = measurement.isotropic() ? 10 : 15;
  for (const double phi_i : azimuths_of(measurement)) {
    for (const double theta_i : {5, 15, 30, 45, 60, 75}) {
      add(theta_i, phi_i, 0, 0);
      for (int theta_o = 4; theta_o <= 80; theta_o += 4)
        for (int phi_o = 0; phi_o <= last; phi_o += step) add(theta_i, phi_i, theta_o, phi_o);
    }
  }
  if (table.rows() == 0) throw InputError(table.source + ": RGL file: holds no finite value");
  table.warnings.push_back("the tensor was sampled at " + plural(table.rows(), "direction"));
  if (table.skipped > 0)
    table.warnings.push_back(plural(table.skipped, "direction") +
                             " left out, because the value is undefined");
  return table;
}

}  // namespace brdf::io::rgl
