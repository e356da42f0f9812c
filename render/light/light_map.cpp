#include "render/light/light_map.h"

#include <algorithm>
#include <cmath>

#include "brdf/scalar.h"

namespace brdf::render {
namespace {

// Returns the cosine of the angle from the zenith at this height of the picture.
double height_cosine(double y, int height) {
  return std::cos(kPi * y / double(height));
}

double solid_angle(int y, int width, int height) {
  return 2 * kPi / double(width) * (height_cosine(y, height) - height_cosine(y + 1, height));
}

// Computes the cumulative distribution of these weights at the ends of the cells; the last value is 1.
void set_distribution(std::span<const double> weights, std::span<float> ends) {
  double total = 0;
  for (const double w : weights) total += w;
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    sum += weights[k];
    ends[k] = total > 0 ? float(sum / total) : float(k + 1) / float(weights.size());
  }
  ends.back() = 1;
}

struct Cell {
  int index;
  double within;  // in [0, 1)
};
Cell cell_at(std::span<const float> ends, double u) {
  // The value stays below 1, so that cells without probability are never found.
  const float below = std::min(float(u), 1 - 0x1p-24f);
  const auto found = std::ranges::upper_bound(ends, below);
  const auto index = found - ends.begin();
  const double low = index > 0 ? double(ends[std::size_t(index - 1)]) : 0, high = double(*found);
  return {int(index), std::clamp((u - low) / std::max(high - low, 1e-30), 0.0, 1 - 0x1p-24)};
}
double probability(std::span<const float> ends, int k) {
  return double(ends[std::size_t(k)]) - (k > 0 ? double(ends[std::size_t(k - 1)]) : 0);
}

}  // namespace

LightMap::LightMap(int width, int height, const std::vector<glm::vec3>& radiance)
    : width_(width), height_(height), columns_(radiance.size()), rows_(std::size_t(height)) {
  const auto w = std::size_t(width);
  const auto row_of = [&](std::size_t y) { return std::span(columns_).subspan(y * w, w); };
  std::vector<double> row(w), sums(std::size_t(height), 0.0);
  for (std::size_t y = 0; y < sums.size(); ++y) {
    for (std::size_t x = 0; x < w; ++x) {
      const glm::vec3& l = radiance[y * w + x];
      row[x] = double(l.r) + double(l.g) + double(l.b);
      sums[y] += row[x] * solid_angle(int(y), width, height);
    }
    set_distribution(row, row_of(y));
  }
  if (std::ranges::all_of(sums, [](double s) { return s == 0; }))
    for (std::size_t y = 0; y < sums.size(); ++y) sums[y] = solid_angle(int(y), width, height);
  set_distribution(sums, rows_);
  texels_.reserve(radiance.size());
  for (std::size_t y = 0; y < sums.size(); ++y) {
    const double share = probability(rows_, int(y)) / solid_angle(int(y), width, height);
    for (std::size_t x = 0; x < w; ++x)
      texels_.emplace_back(radiance[y * w + x], float(share * probability(row_of(y), int(x))));
  }
}

glm::vec2 LightMap::place_of(const glm::vec3& d) const {
  const float across = std::atan2(d.x, -d.z) / float(2 * kPi) + 0.5f;
  const float down = std::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y) / float(kPi);
  return {across * float(width_), down * float(height_)};
}

const glm::vec4& LightMap::texel_towards(const glm::vec3& direction) const {
  const glm::ivec2 at(place_of(direction));
  return texel(std::clamp(at.x, 0, width_ - 1), std::clamp(at.y, 0, height_ - 1));
}

glm::vec3 LightMap::shown(const glm::vec3& direction) const {
  const glm::vec2 at = place_of(direction) - 0.5f, low = glm::floor(at), t = at - low;
  const auto value = [&](int dx, int dy) {
    const int x = (int(low.x) + dx + width_) % width_, y = std::clamp(int(low.y) + dy, 0, height_ - 1);
    return glm::vec3(texel(x, y));
  };
  return glm::mix(glm::mix(value(0, 0), value(1, 0), t.x), glm::mix(value(0, 1), value(1, 1), t.x), t.y);
}

LightSample LightMap::sample(double u1, double u2) const {
  const Cell row = cell_at(rows_, u1);
  const auto w = std::size_t(width_);
  const Cell column = cell_at(std::span(columns_).subspan(std::size_t(row.index) * w, w), u2);
  const double top = height_cosine(row.index, height_), bottom = height_cosine(row.index + 1, height_);
  const double cosine = top + (bottom - top) * row.within,
               sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const double phi = 2 * kPi * ((double(column.index) + column.within) / double(width_) - 0.5);
  const glm::vec4& texel = this->texel(column.index, row.index);
  return {
      {float(sine * std::sin(phi)), float(cosine), float(-sine * std::cos(phi))}, glm::vec3(texel), texel.a};
}

LightMap light_map_of(Formula formula) {
  constexpr int kHeight = 512;
  const int height = formula == Formula::uniform ? 1 : kHeight,
            width = formula == Formula::uniform ? 1 : 2 * height;
  std::vector<glm::vec3> radiance;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double theta = kPi * (y + 0.5) / height, phi = 2 * kPi * ((x + 0.5) / width - 0.5);
      radiance.push_back(radiance_of(formula, {float(std::sin(theta) * std::sin(phi)), float(std::cos(theta)),
                                               float(-std::sin(theta) * std::cos(phi))}));
    }
  }
  return {width, height, radiance};
}

}  // namespace brdf::render
