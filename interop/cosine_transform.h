// Linearly transformed cosines: the tables with which renderers integrate a lobe over a polygonal light.
// Source: Heitz, Dupuy, Hill and Neubelt, Real-Time Polygonal-Light Shading with Linearly Transformed
// Cosines, ACM Trans. Graph. 35(4), 2016; layout of selfshadow/ltc_code, which three.js, Unity and PlayCanvas
// read.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "brdf/vec3.h"
#include "io/files/json.h"

namespace brdf::interop {

// The inverse of the matrix that turns a cosine lobe into this one, with 1 as its middle element: rows
// (x, 0, z), (0, 1, 0), (y, 0, w). The viewer lies in the plane of x and z, at positive x.
struct CosineTransform {
  double x = 1, y = 0, z = 0, w = 1;

  // Returns the density of the transformed lobe per solid angle of `wi`, 1/sr. Its integral over the whole
  // sphere is 1; a part of it can lie below the horizon.
  double density(const Vec3<double>& wi) const;
};

// A value and the place at which it occurs.
struct AtPlace {
  double value = 0, cosine = 0, roughness = 0;  // roughness is the root of alpha
};

// A table of transforms: texel (i, j) has the roughness i/(side - 1) and the cosine 1 - (j/(side - 1))^2.
struct CosineTable {
  std::size_t side = 64;
  std::vector<CosineTransform> transforms;  // row by row
  std::vector<double> white, bias;          // albedo = f0 white + (f90 - f0) bias
  std::string content;                      // a phrase: which lobe
  double albedo_bound = 0;                  // the largest bound of an albedo's integral
  std::size_t not_converged = 0;            // albedos, counted without a meaning for the bound
  // Light that a texel's transform sends into wrong directions, as a share of the reflected light: half the
  // integral of the difference of both densities.
  double misplaced_median = 0;
  AtPlace misplaced{};
  // The same of the bilinear reading in the middle of each cell.
  double between_median = 0;
  AtPlace between{};
};

// Fits the transforms to the lobe of the material's form by least squares in the densities, relative to the
// density of a proposal that covers the lobe. Polar angles above 89.9 degrees and alphas below 1e-4 are held
// there.
// Throws InputError for materials that `TableFunction` refuses.
CosineTable cosine_table(const Material& material, std::size_t side = 64);

// Returns the share of light that this transform sends into wrong directions, for the material's lobe at a
// cosine in 0..1 and an alpha in 0..1, by `rings`^2 nodes and a quarter as many more.
double misplaced_share(const Material& material, const CosineTransform& transform, double cosine,
                       double alpha, std::size_t rings = 48);

std::vector<std::string> sentences(const CosineTable& table);
io::Json to_json(const CosineTable& table);

}  // namespace brdf::interop
