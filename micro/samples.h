// Traced microsurfaces as the samples of a measurement, for `brdf synth --microsurface`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/samples/samples.h"
#include "micro/goniometer.h"

namespace brdf::micro {

struct SampleSettings {
  // Name of the surface:
  //   gaussian          height field of slope width alpha (or alpha_x, alpha_y);
  //                     mirrors of index eta (by default perfect reflectors)
  //   lambert_gaussian  the same with Lambertian facets of albedo rho
  //   mirror_grooves    V-grooves with slopes of width alpha; mirrors of index eta
  //   lambert_grooves   V-grooves with Oren and Nayar's angles (sigma, radians); albedo rho
  std::string surface = "gaussian";
  std::vector<std::pair<std::string, double>> parameters;
  std::vector<double> theta_i = {0, 15, 30, 45, 60, 75};  // degrees
  std::vector<double> azimuths = {0};                     // rotations of the sample, degrees
  // Side of the outgoing cells, degrees. 0: small compared with the lobe, 10 for Lambertian facets.
  double cell = 0;
  int bounces = 64;         // reflections that are followed; 1: single reflection only
  bool orders = false;      // one channel for each order: order_1, order_2, order_3_up
  double min_power = 1e-4;  // cells with a smaller share of the incident power are omitted (mirrors)
  int surfaces = 0;         // independent surfaces, at least 8; 0: 16, for mirror_grooves 512
  // Rays per surface and direction. 0: 2^18, for mirror_grooves 2^13, for Lambertian facets 2^12.
  std::int64_t rays = 0;
  int size = 512;    // cells along each side of a height field's period
  bool gpu = false;  // mirrors: follow the rays on a Vulkan device
  std::uint64_t seed = 1;
  int threads = int(io::all_processors());
};

// Traces the surface. Light comes from phi 180 before the sample is rotated, as in the other grids. For
// mirrors the value of a row is the mean of f_r over a cell of the outgoing hemisphere; for Lambertian
// facets it is f_r at the centre of the cell. sigma is the standard error over independent surfaces. The
// direction is the centre of the cell. Throws InputError if a name or value is out of range, and
// EnvironmentError if no Vulkan device computes in double and one is requested.
io::SampleTable trace_samples(const SampleSettings& settings, const Progress& progress = {});

// Returns the permitted names of `surface`.
std::vector<std::string> surface_names();

}  // namespace brdf::micro
