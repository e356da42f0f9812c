#include "micro/height_field.h"

#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "brdf/scalar.h"

namespace brdf::micro {
namespace {

using Spectrum = std::vector<std::complex<double>>;

void transpose(Spectrum& s, int n) {
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < j; ++i)
      std::swap(s[static_cast<std::size_t>(j) * n + i], s[static_cast<std::size_t>(i) * n + j]);
  }
}

void inverse_rows(Spectrum& s, int n) {
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::Unscaled);
  Spectrum row(n);
  for (int j = 0; j < n; ++j) {
    std::complex<double>* begin = s.data() + static_cast<std::size_t>(j) * n;
    fft.inv(row.data(), begin, n);
    std::copy(row.begin(), row.end(), begin);
  }
}

// Returns the wave number of index k in radians per cell, in [-pi, pi).
double wave_number(int k, int n) {
  return 2 * kPi * (k < n / 2 ? k : k - n) / n;
}

}  // namespace

Surface make_height_field(const HeightField& settings, Random& random) {
  const int n = settings.size;
  const double length = settings.correlation_length;
  Spectrum spectrum(static_cast<std::size_t>(n) * n);
  // The real part of sum_k s_k e^{ikx} with independent complex normal s_k of variance 2 p_k per point has
  // the variance sum p_k. Differences of neighbours along x have the variance
  // sum p_k |e^{ikx} - 1|^2 = sum p_k 4 sin^2(kx/2).
  double difference_variance = 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double kx = wave_number(i, n), ky = wave_number(j, n);
      double power = std::exp(-(kx * kx + ky * ky) * length * length / 4);
      if (i == 0 && j == 0) power = 0;  // the mean height has no effect
      const double half_sine = std::sin(kx / 2);
      difference_variance += power * 4 * half_sine * half_sine;
      const double amplitude = std::sqrt(power), re = random.normal(), im = random.normal();
      spectrum[static_cast<std::size_t>(j) * n + i] = {amplitude * re, amplitude * im};
    }
  }
  inverse_rows(spectrum, n);
  transpose(spectrum, n);
  inverse_rows(spectrum, n);
  transpose(spectrum, n);

  Surface surface;
  surface.nx = surface.ny = n;
  surface.dx = std::sqrt(settings.alpha_y / settings.alpha_x);
  surface.dy = 1 / surface.dx;
  const double scale = std::sqrt(settings.alpha_x * settings.alpha_y / (2 * difference_variance));
  surface.heights.reserve(spectrum.size());
  for (const std::complex<double>& s : spectrum)
    surface.heights.push_back(static_cast<float>(scale * s.real()));
  surface.find_tops();
  return surface;
}

}  // namespace brdf::micro
