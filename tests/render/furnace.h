// A sphere in uniform light of radiance 1: every pixel shows the directional albedo, which libbrdf computes
// by quadrature.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "brdf/integrals.h"
#include "render/reference/reference.h"

namespace brdf::render {

// Returns the forms that declare no violation of energy conservation.
inline std::vector<Reflectance> conserving_forms() {
  std::vector<Reflectance> forms;
  for (const Reflectance& form : catalogue())
    if (!form.info().violates("energy")) forms.push_back(form);
  return forms;
}

// Returns a scene of `size` x `size` pixels that show a sphere from its middle to 77 degrees, lit by
// `picture` alone. `fov` in degrees; 30 shows the whole sphere.
inline PreparedScene sphere_in(const Material& material, const std::string& picture, int size = 10,
                               float fov = 19) {
  Scene scene = material_scene({{"m", material}});
  scene.camera.width = scene.camera.height = size;
  scene.camera.vertical_fov = fov;
  scene.objects[0].mesh = "sphere:5000";
  scene.lights.clear();
  scene.ambient = glm::vec3(0);
  scene.environment = Environment{picture};
  return prepare(scene);
}

inline std::vector<double> furnace_truth(const PreparedScene& scene) {
  const Term& term = scene.scene.objects[0].material.terms[0];
  // A light at the viewer reaches every visible point.
  PreparedScene seen = scene;
  seen.scene.lights = {{false, {0, 0, -1}}};
  std::vector<double> truth;
  for (const LitPoint& at : lit_points(seen)) {
    const Angle theta = radians(std::acos(std::min(1.0, double(at.wo.z)))),
                phi = radians(std::atan2(double(at.wo.y), double(at.wo.x)));
    truth.push_back(
        directional_albedo(term, 0, theta, phi, {.fixed = Fixed::viewer, .tolerance = 1e-6}).value);
  }
  return truth;
}

// The mean of pictures with independent random numbers, and the standard error of the mean, estimated from
// their scatter.
struct Replicates {
  std::vector<double> mean, error;
};
template <class Draw>
Replicates replicates(int count, Draw&& draw) {
  Replicates r;
  std::vector<double> squares;
  for (int seed = 1; seed <= count; ++seed) {
    const Picture picture = draw(std::uint32_t(seed));
    r.mean.resize(picture.pixels.size());
    squares.resize(picture.pixels.size());
    for (std::size_t k = 0; k < r.mean.size(); ++k) {
      const auto value = double(picture.pixels[k].r);
      r.mean[k] += value / count;
      squares[k] += value * value / count;
    }
  }
  for (std::size_t k = 0; k < r.mean.size(); ++k)
    r.error.push_back(std::sqrt(std::max(squares[k] - r.mean[k] * r.mean[k], 0.0) / (count - 1)));
  return r;
}

struct FurnaceFindings {
  double largest_error = 0;         // standard error divided by the albedo
  int pixels = 0, beyond_3 = 0;     // pixels farther from the truth than 3 standard errors
  double farthest = 0;              // in standard errors
  double mean = 0, mean_error = 0;  // relative error over all pixels, and the standard error of this mean
};

inline FurnaceFindings furnace_findings(const Replicates& r, const std::vector<double>& truth) {
  FurnaceFindings f;
  EXPECT_EQ(truth.size(), r.mean.size());
  double squares = 0;
  const auto n = double(truth.size());
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const double off = r.mean[k] / truth[k] - 1;
    const double error =
        std::max(r.error[k] / truth[k], 5e-6);  // rounding in float and the error of the truth
    f.largest_error = std::max(f.largest_error, error);
    f.beyond_3 += std::abs(off) > 3 * error;
    f.farthest = std::max(f.farthest, std::abs(off) / error);
    f.mean += off / n;
    squares += error * error;
  }
  f.pixels = int(truth.size());
  f.mean_error = std::sqrt(squares) / n;
  return f;
}

inline std::string in_words(const FurnaceFindings& f) {
  char text[160];
  std::snprintf(text, sizeof text,
                "error at most %.4f %%, beyond 3: %d of %d, farthest %.2f, mean %+.5f +- %.5f %%",
                100 * f.largest_error, f.beyond_3, f.pixels, f.farthest, 100 * f.mean, 100 * f.mean_error);
  return text;
}

// Adds up over all forms the pixels that lie beyond 3 standard errors. At most 1 % of all pixels may.
class WhiteFurnace {
 public:
  explicit WhiteFurnace(double most_error) : most_error_(most_error) {}
  ~WhiteFurnace() { EXPECT_LE(beyond_, 0.01 * pixels_) << "of " << pixels_; }

  void add(const std::string& what, const FurnaceFindings& f) {
    EXPECT_LE(f.largest_error, most_error_) << what;
    EXPECT_LE(f.farthest, 5) << what;
    EXPECT_LE(std::abs(f.mean), 3 * f.mean_error) << what << ": " << in_words(f);
    beyond_ += f.beyond_3;
    pixels_ += f.pixels;
  }

 private:
  double most_error_, beyond_ = 0, pixels_ = 0;
};

inline FurnaceFindings reference_furnace(const PreparedScene& scene, int pictures, int samples) {
  const auto draw = [&](std::uint32_t seed) {
    return render_reference(scene, {.samples = samples, .seed = seed});
  };
  return furnace_findings(replicates(pictures, draw), furnace_truth(scene));
}

}  // namespace brdf::render
