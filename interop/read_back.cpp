#include "interop/read_back.h"

#include <algorithm>

#include "brdf/reflectance.h"
#include "interop/wanted.h"
#include "io/formats/merl.h"
#include "io/formats/rgl.h"
#include "io/samples/degrees.h"

namespace brdf::interop {
namespace {

class ValuesModel : public ReflectanceModel {
 public:
  ValuesModel(Values values, std::vector<std::string> channels)
      : values_(std::move(values)), channels_(std::move(channels)) {
    info_.name = info_.family = "table";
    info_.channels = channels_;
    info_.outside = true;
  }
  const ReflectanceInfo& info() const override { return info_; }
  void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override {
    std::vector<double> f(channels_.size());
    for (std::size_t k = 0; k < d.count; ++k) {
      out[k] = 0;
      if (!(std::min(d.wi_z[k], d.wo_z[k]) > 0)) continue;
      values_(d.wi(k), d.wo(k), f);
      out[k] = f[p.channel];
    }
  }

 private:
  Values values_;
  std::vector<std::string> channels_;
  ReflectanceInfo info_;
};

}  // namespace

Material material_of(Values values, std::vector<std::string> channels) {
  const std::vector<std::string> names = channels;
  return make_material(
      Reflectance(std::make_shared<const ValuesModel>(std::move(values), std::move(channels))), names);
}

Material in_float(const Material& material) {
  const auto values = [material](const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> f) {
    DirectionArrays<float> one(1);
    one.set(0, {float(wi.x), float(wi.y), float(wi.z)}, {float(wo.x), float(wo.y), float(wo.z)});
    std::ranges::fill(f, 0);
    for (const Term& term : material.terms)
      for (std::size_t c = 0; c < f.size(); ++c) {
        float value = 0;
        eval_batch(term, c, one.view(), &value);
        f[c] += double(value);
      }
  };
  return material_of(values, material.channels);
}

Material read_back_merl(const io::Content& file) {
  const io::SampleTable table = io::merl::read(file);
  auto planes = std::make_shared<std::vector<std::array<float, 3>>>(io::merl::kCells);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const std::size_t cell =
        io::merl::find_cell(table.theta_i[k], table.phi_i[k], table.theta_o[k], table.phi_o[k]);
    for (std::size_t c = 0; c < 3; ++c) (*planes)[cell][c] = float(table.values[c][k]);
  }
  const auto values = [planes](const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> f) {
    const io::Polar light = io::polar_degrees(wi), viewer = io::polar_degrees(wo);
    const std::size_t cell = io::merl::find_cell(light.theta, light.phi, viewer.theta, viewer.phi);
    for (std::size_t c = 0; c < f.size(); ++c) f[c] = double((*planes)[cell][c]);
  };
  return material_of(values, table.channels);
}

Material read_back_rgl(const io::Content& file) {
  const auto measurement = std::make_shared<const io::rgl::Measurement>(file);
  const auto values = [measurement](const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> f) {
    measurement->eval_cos_o(wi, wo, f);
    for (double& value : f) value /= wo.z;
  };
  return material_of(values, measurement->channels());
}

std::optional<Loss> loss_of_table(const Material& wanted, const Material& table) {
  // Cells and interpolation squares make the table's function non-smooth, hence the loose tolerance.
  const AlbedoOptions albedos{.tolerance = 1e-2, .max_evaluations = 100'000};
  Material of_one = table;
  if (wanted.channels.size() == 1) {
    of_one.channels.resize(1);
    for (Term& term : of_one.terms) term.weights.resize(1);
    return Comparison(wanted, albedos).loss_of(of_one);
  }
  if (table.channels == std::vector<std::string>{"r", "g", "b"}) {
    const auto colours = in_colours(wanted);
    return colours ? std::optional(Comparison(*colours, albedos).loss_of(table)) : std::nullopt;
  }
  if (table.channels.size() != wanted.channels.size()) return std::nullopt;
  return Comparison(wanted, albedos).loss_of(table);
}

}  // namespace brdf::interop
