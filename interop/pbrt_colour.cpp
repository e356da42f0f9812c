#include "interop/pbrt_colour.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "brdf/fresnel.h"
#include "io/colour/spectrum.h"

namespace brdf::interop {
namespace {

using Rgb = std::array<double, 3>;

constexpr double kShortest = 380, kLongest = 780, kApart = 5;  // nm
constexpr double kFrom = 360, kTo = 830;                       // nm, pbrt's range

struct Band {
  double wavelength, place;  // nm; position in pbrt's range, 0 to 1
  Rgb weight;                // contribution of this wavelength's reflectance to linear sRGB under D65
};

const std::vector<Band>& bands() {
  static const std::vector<Band> all = [] {
    std::vector<double> nm;
    for (double x = kShortest; x <= kLongest; x += kApart) nm.push_back(x);
    const std::vector<io::Tristimulus> weights = io::srgb_weights(nm);
    std::vector<Band> out;
    for (std::size_t k = 0; k < nm.size(); ++k)
      out.push_back({nm[k], (nm[k] - kFrom) / (kTo - kFrom), weights[k]});
    return out;
  }();
  return all;
}

double sigmoid(double q) {
  return 0.5 + q / (2 * std::sqrt(1 + q * q));
}

Eigen::Vector3d colour_of(const Eigen::Vector3d& c, Eigen::Matrix3d* slope) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  if (slope) slope->setZero();
  for (const Band& band : bands()) {
    const double t = band.place, q = (c[0] * t + c[1]) * t + c[2];
    const Eigen::Vector3d weight(band.weight[0], band.weight[1], band.weight[2]);
    sum += weight * sigmoid(q);
    if (slope) *slope += 0.5 * std::pow(1 + q * q, -1.5) * weight * Eigen::RowVector3d(t * t, t, 1);
  }
  return sum;
}

// Approaches the target in steps. Each step uses the Gauss-Newton method with step halving.
Eigen::Vector3d coefficients_of(const Eigen::Vector3d& target) {
  const double grey = std::clamp(target.mean(), 0.02, 0.98),
               q = (2 * grey - 1) / (2 * std::sqrt(grey * (1 - grey)));
  Eigen::Vector3d c(0, 0, q);
  constexpr int kSteps = 10, kRounds = 30;
  for (int step = 1; step <= kSteps; ++step) {
    const Eigen::Vector3d goal = Eigen::Vector3d::Constant(grey) +
                                 (target - Eigen::Vector3d::Constant(grey)) * (double(step) / kSteps);
    for (int round = 0; round < kRounds; ++round) {
      Eigen::Matrix3d slope;
      const Eigen::Vector3d off = colour_of(c, &slope) - goal;
      if (off.norm() < 1e-12) break;
      const Eigen::Vector3d full = slope.fullPivLu().solve(off);
      double share = 1;
      while (share > 1e-4 && !((colour_of(c - share * full, nullptr) - goal).norm() < off.norm()))
        share *= 0.5;
      if (share <= 1e-4) break;
      c -= share * full;
    }
  }
  return c;
}

constexpr std::size_t kNodes = 257;  // nodes over the cosine between a direction and the half vector

// Fresnel reflectance as a colour, interpolated linearly between nodes (error 4e-5).
class FresnelColour {
 public:
  FresnelColour(const Rgb& n, const Rgb& k) : nodes_(kNodes) {
    const ColourSpectrum index(n), extinction(k);
    for (const Band& band : bands()) {
      const double eta = index.at(band.wavelength), kappa = extinction.at(band.wavelength);
      for (std::size_t j = 0; j < kNodes; ++j) {
        const double f = fresnel_conductor(eta, kappa, double(j) / double(kNodes - 1));
        for (std::size_t c = 0; c < 3; ++c) nodes_[j][c] += band.weight[c] * f;
      }
    }
  }
  double at(double cosine, std::size_t channel) const {
    const double x = std::clamp(cosine, 0.0, 1.0) * double(kNodes - 1);
    const std::size_t j = std::min(std::size_t(x), kNodes - 2);
    return nodes_[j][channel] + (x - double(j)) * (nodes_[j + 1][channel] - nodes_[j][channel]);
  }

 private:
  std::vector<Rgb> nodes_;
};

// The form with this colour in place of its own Fresnel factor.
class ShownByPbrt : public ReflectanceModel {
 public:
  ShownByPbrt(Reflectance form, FresnelColour fresnel)
      : form_(std::move(form)), fresnel_(std::move(fresnel)) {
    info_ = form_.info();
    info_.lobes = {};
    info_.differentiable = info_.has_glsl = false;
    info_.albedos = {};
  }
  const ReflectanceInfo& info() const override { return info_; }

  void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override {
    const std::size_t kd = std::size_t(info_.weight_index(Role::diffuse)),
                      ks = std::size_t(info_.weight_index(Role::specular));
    // The lobe is evaluated with a known Fresnel factor, which is divided out below.
    constexpr double kIndex = 1, kExtinction = 20;
    std::vector<double> shape(p.shape.begin(), p.shape.end()), weights(p.weights.size(), 0.0);
    shape[std::size_t(info_.shape_index(Role::index))] = kIndex;
    shape[std::size_t(info_.shape_index(Role::extinction))] = kExtinction;
    weights[ks] = 1;
    form_->eval({weights, weights, shape, p.channel}, d, out);
    for (std::size_t k = 0; k < d.count; ++k) {
      if (!(std::min(d.wi_z[k], d.wo_z[k]) >= 0)) continue;
      const Vec3<double> wi = d.wi(k), h = wi + d.wo(k);
      const double length = std::sqrt(dot(h, h));
      const double cosine = length > 0 ? std::min(dot(wi, h) / length, 1.0) : 0;
      out[k] = p.weights[kd] / kPi + p.weights[ks] * out[k] / fresnel_conductor(kIndex, kExtinction, cosine) *
                                         fresnel_.at(cosine, p.channel);
    }
  }

 private:
  Reflectance form_;
  FresnelColour fresnel_;
  ReflectanceInfo info_;
};

}  // namespace

ColourSpectrum::ColourSpectrum(const Rgb& rgb) : scale_(2 * *std::ranges::max_element(rgb)) {
  if (!(scale_ > 0)) return;
  const Eigen::Vector3d target = Eigen::Vector3d(rgb[0], rgb[1], rgb[2]) / scale_;
  if (rgb[0] == rgb[1] && rgb[1] == rgb[2]) return;  // 1/2 everywhere
  const Eigen::Vector3d c = coefficients_of(target);
  coefficients_ = {c[0], c[1], c[2]};
  residual_ = 2 * (colour_of(c, nullptr) - target).norm();
}

double ColourSpectrum::at(double wavelength) const {
  const double t = (wavelength - kFrom) / (kTo - kFrom);
  return scale_ * sigmoid((coefficients_[0] * t + coefficients_[1]) * t + coefficients_[2]);
}

Material shown_by_pbrt(const Material& of_conductors) {
  const Term& term = of_conductors.terms.front();
  if (term.shape.size() != 3) return of_conductors;
  const std::size_t n = std::size_t(info(term.form).shape_index(Role::index)),
                    k = std::size_t(info(term.form).shape_index(Role::extinction));
  Rgb index, extinction;
  for (std::size_t c = 0; c < 3; ++c) index[c] = term.shape[c][n], extinction[c] = term.shape[c][k];
  const auto grey = [](const Rgb& c) { return c[0] == c[1] && c[1] == c[2]; };
  if (grey(index) && grey(extinction)) return of_conductors;  // the same at every wavelength
  Material shown = of_conductors;
  shown.terms[0].form =
      Reflectance(std::make_shared<const ShownByPbrt>(term.form, FresnelColour(index, extinction)));
  return shown;
}

}  // namespace brdf::interop
