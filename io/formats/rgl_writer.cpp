#include "io/formats/rgl_writer.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "brdf/scalar.h"
#include "io/colour/channel_colours.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/formats/tensor_file.h"

namespace brdf::io::rgl {
namespace {

constexpr double kSteepest = 89.5 * kPi / 180;
constexpr std::size_t kProfile = 1024, kSigma = 256;  // numbers of nodes of ndf and sigma
constexpr double kFaint = 1e-7;                       // lower bound of ndf and luminance, over their maximum
constexpr std::uint64_t kLeastBytes = 200'000;
constexpr double kAnglesPerNode = 0.4;  // polar angles of incidence per node of a side

Vec3<double> at(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}
double theta_of_unit(double u) {
  return u * u * (kPi / 2);
}
double phi_of_unit(double u) {
  return (2 * u - 1) * kPi;
}

// Interpolates a table over [0, 1] linearly at u.
double between_nodes(const std::vector<float>& nodes, double u) {
  const double x = u * double(nodes.size() - 1);
  const std::size_t k = std::min(std::size_t(x), nodes.size() - 2);
  return nodes[k] + (x - double(k)) * (double(nodes[k + 1]) - nodes[k]);
}

class Tables {
 public:
  Tables(const Values& values, std::size_t channels, std::size_t side, std::size_t angles)
      : values_(values), f_(channels), side_(side), ndf_(kProfile), sigma_(kSigma) {
    for (std::size_t k = 0; k < angles; ++k)
      theta_i_.push_back(float(kSteepest * double(k) / double(angles - 1)));
    make_profile();
    make_sigma();
    make_slices();
  }

  std::string file(const std::vector<double>& wavelengths, const std::string& description) const {
    const std::size_t n = theta_i_.size(), c = spectra_.size() / (n * side_ * side_);
    TensorWriter out;
    out.add("description", description);
    out.add("phi_i", {1}, {0.0f});
    out.add("theta_i", {n}, theta_i_);
    out.add("ndf", {2, kProfile}, twice(ndf_));
    out.add("sigma", {2, kSigma}, twice(sigma_));
    out.add("vndf", {1, n, 2, 2}, std::vector<float>(4 * n, 1));
    out.add("luminance", {1, n, side_, side_}, luminance_);
    out.add(wavelengths.empty() ? "rgb" : "spectra", {1, n, c, side_, side_}, spectra_);
    if (!wavelengths.empty())
      out.add("wavelengths", {c}, std::vector<float>(wavelengths.begin(), wavelengths.end()));
    out.add("jacobian", std::string(1, '\1'));
    return out.bytes();
  }

 private:
  static std::vector<float> twice(std::vector<float> row) {
    row.insert(row.end(), row.begin(), row.end());
    return row;
  }

  // Fills f_ with f cos_o for the half vector m. Returns the mean, or 0 if the viewing direction is below
  // the horizon.
  double reflected(const Vec3<double>& wi, const Vec3<double>& m) {
    const Vec3<double> wo = m * (2 * dot(m, wi)) - wi;
    std::ranges::fill(f_, 0.0);
    if (!(wo.z > 0)) return 0;
    values_(wi, wo, f_);
    for (double& f : f_) f = std::max(f * wo.z, 0.0);
    return std::accumulate(f_.begin(), f_.end(), 0.0) / double(f_.size());
  }

  // Tabulates f cos_i cos_o, averaged over incidence and azimuth up to a constant factor, as a function of
  // the polar angle of the half vector.
  void make_profile() {
    std::vector<double> mean(kProfile);
    for (std::size_t k = 0; k < kProfile; ++k) {
      const double theta = theta_of_unit(double(k) / double(kProfile - 1));
      for (int light = 0; light < 12; ++light) {
        const Vec3<double> wi = at(kSteepest * (light + 0.5) / 12, 0);
        for (int turn = 0; turn < 12; ++turn)
          mean[k] += wi.z * reflected(wi, at(theta, kPi * (turn + 0.5) / 12));
      }
    }
    const double least = std::max(kFaint * *std::ranges::max_element(mean), 1e-30);
    for (std::size_t k = 0; k < kProfile; ++k) ndf_[k] = float(std::max(mean[k], least));
  }

  // Tabulates 1/4 of the profile's value at 0 over the mean f cos_o in the mirror direction, as a function
  // of the polar angle of incidence.
  void make_sigma() {
    for (std::size_t k = 0; k < kSigma; ++k) {
      const Vec3<double> wi = at(std::min(theta_of_unit(double(k) / double(kSigma - 1)), kSteepest), 0);
      const double mirrored = reflected(wi, {0, 0, 1});
      sigma_[k] = mirrored > 0 ? float(0.25 * ndf_[0] / mirrored) : 0.25f;
    }
  }

  void make_slices() {
    const std::size_t area = side_ * side_, channels = f_.size();
    spectra_.resize(theta_i_.size() * channels * area);
    luminance_.resize(theta_i_.size() * area);
    for (std::size_t k = 0; k < theta_i_.size(); ++k) {
      const Vec3<double> wi = at(theta_i_[k], 0);
      const double scale = 4 * between_nodes(sigma_, std::sqrt(theta_i_[k] * (2 / kPi)));
      for (std::size_t row = 0; row < side_; ++row)
        for (std::size_t column = 0; column < side_; ++column) {
          const double u = double(column) / double(side_ - 1), theta = theta_of_unit(u);
          const Vec3<double> m = at(theta, phi_of_unit(double(row) / double(side_ - 1)));
          const double mean = reflected(wi, m), over = scale / between_nodes(ndf_, u);
          const std::size_t cell = row * side_ + column;
          for (std::size_t c = 0; c < channels; ++c)
            spectra_[(k * channels + c) * area + cell] = float(f_[c] * over);
          const double solid = 2 * kPi * kPi * u * std::sin(theta) * 4 * std::max(dot(wi, m), 0.0);
          luminance_[k * area + cell] = float(mean * solid);
        }
      normalise(luminance_.data() + k * area);
    }
  }

  // Scales a slice to a mean of 1 over the square, as importers expect a density. Rows of 0 would have no
  // distribution and are raised to a small value.
  void normalise(float* slice) const {
    const std::size_t area = side_ * side_;
    const double least = kFaint * double(*std::max_element(slice, slice + area)) + 1e-30;
    double sum = 0;
    for (std::size_t row = 0; row < side_; ++row)
      for (std::size_t column = 0; column < side_; ++column) {
        float& cell = slice[row * side_ + column];
        cell = float(std::max(double(cell), least));
        const double edges =
            double(row == 0 || row + 1 == side_) + double(column == 0 || column + 1 == side_);
        sum += cell * std::pow(0.5, edges);
      }
    const double scale = double((side_ - 1) * (side_ - 1)) / sum;
    for (std::size_t cell = 0; cell < area; ++cell) slice[cell] = float(slice[cell] * scale);
  }

  const Values& values_;
  std::vector<double> f_;
  std::size_t side_;
  std::vector<float> theta_i_, ndf_, sigma_, spectra_, luminance_;
};

// Returns the wavelengths of a spectrum's channels in nm, which must ascend; an empty vector for colours.
// Throws InputError for other channels.
std::vector<double> wavelengths_of(const std::vector<std::string>& channels) {
  std::vector<double> nm;
  for (const std::string& channel : channels)
    if (const auto length = wavelength_of(channel)) nm.push_back(*length);
  if (nm.size() == channels.size() && nm.size() >= 2) {
    if (!std::ranges::is_sorted(nm, std::less_equal<>()))
      throw InputError("RGL file: the wavelengths must ascend");
    return nm;
  }
  if (channels.size() != 1 && channels.size() != 3)
    throw InputError("RGL file: stores one channel, red, green and blue, or wavelengths; not " +
                     plural(channels.size(), "channel") + " without wavelengths");
  return {};
}

}  // namespace

std::string file_of(const Values& values, const std::vector<std::string>& channels,
                    const FileOptions& options) {
  const std::vector<double> wavelengths = wavelengths_of(channels);
  if (options.bytes < kLeastBytes)
    throw InputError("RGL file: " + std::to_string(options.bytes) + " bytes are fewer than " +
                     std::to_string(kLeastBytes));
  const auto colours = channel_colours(channels);
  std::vector<double> own(channels.size());
  // Colours always become three channels in the order red, green, blue.
  const Values in_order = [&](const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> f) {
    values(wi, wo, own);
    for (std::size_t c = 0; c < f.size(); ++c) f[c] = own[wavelengths.empty() ? colours->of[c] : c];
  };
  const std::size_t count = wavelengths.empty() ? 3 : channels.size();
  const double nodes = double(options.bytes) / (4 * double(count + 1));
  const auto side = std::size_t(std::max(std::cbrt(nodes / kAnglesPerNode), 8.0));
  const auto angles = std::max<std::size_t>(std::size_t(nodes / double(side * side)), 4);
  return Tables(in_order, count, side, angles).file(wavelengths, options.description);
}

}  // namespace brdf::io::rgl
