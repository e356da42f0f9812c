#include "fit/model/smooth.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "brdf/scalar.h"
#include "io/columns/wavelengths.h"
#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

// Returns 1000 nm / wavelength of each channel.
std::vector<double> wavenumbers(std::span<const std::string> channels) {
  std::vector<double> out;
  for (const std::string& channel : channels) {
    const auto nm = io::wavelength_of(channel);
    if (!nm)
      throw InputError("--shape smooth: channel " + io::shown(channel) +
                       " has no wavelength in its name (such as 465nm), so the shape cannot vary smoothly "
                       "with it: use --shape shared or free");
    out.push_back(1000 / *nm);
  }
  return out;
}

// Evaluates Lagrange's polynomial of one node.
double share_at(const std::vector<double>& nodes, std::size_t node, double x) {
  double share = 1;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (k != node) share *= (x - nodes[k]) / (nodes[node] - nodes[k]);
  return share;
}

}  // namespace

Matrix SmoothBasis::coefficients() const {
  const std::size_t n = nodes.size();
  Matrix out(n, n);
  for (std::size_t node = 0; node < n; ++node) {
    std::vector<double> power{1};  // coefficients of the product so far, by powers
    for (std::size_t k = 0; k < n; ++k) {
      if (k == node) continue;
      const double scale = 1 / (nodes[node] - nodes[k]);
      power.push_back(0);
      for (std::size_t i = power.size(); i-- > 0;)
        power[i] = scale * ((i > 0 ? power[i - 1] : 0) - nodes[k] * power[i]);
    }
    for (std::size_t i = 0; i < n; ++i) out(i, node) = power[i];
  }
  return out;
}

SmoothBasis smooth_basis(std::span<const std::string> channels, int degree) {
  const std::vector<double> x = wavenumbers(channels);
  const std::size_t wavelengths = std::set<double>(x.begin(), x.end()).size();
  if (wavelengths <= std::size_t(degree))
    throw InputError("--shape smooth:" + std::to_string(degree) + ": a polynomial of degree " +
                     std::to_string(degree) + " needs at least " + std::to_string(degree + 1) +
                     " wavelengths; the table has " + std::to_string(wavelengths));
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const double middle = 0.5 * (*low + *high), half = 0.5 * (*high - *low);
  SmoothBasis basis;
  for (int k = 0; k <= degree; ++k)
    basis.nodes.push_back(middle - half * std::cos(kPi * double(k) / double(degree)));
  basis.nodes.front() = *low;
  basis.nodes.back() = *high;
  for (std::size_t node = 0; node < basis.nodes.size(); ++node) {
    std::vector<double>& share = basis.share.emplace_back();
    for (const double at : x) share.push_back(share_at(basis.nodes, node, at));
  }
  return basis;
}

}  // namespace brdf::fit
