// Compares deferred rendering with Embree, form by form: direct light, pixel centres, one sphere.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "render/picture/picture.h"
#include "render/vulkan/device.h"

namespace brdf::render {

struct ParityRow {
  std::string form;
  // "defaults", or "width 0.05" (and the corresponding value of other parameters).
  std::string parameters;
  int gbuffer_bits = 16;
  Difference difference;
};

inline constexpr double kMostCoverageMismatch = 1e-4;
// Returns the bound that the relative mean square error must stay below: 1e-11 with 32-bit, 1e-6 with
// 16-bit targets.
double parity_bound(int gbuffer_bits);
// Returns whether the error is below parity_bound() and the coverage mismatch at most
// kMostCoverageMismatch.
bool passes(const ParityRow& row);

// Compares each form, of the catalogue or not, with the default parameters and, if the form has a width, at
// width 0.05 (roughness sqrt(0.05), exponent 2/width^2 - 2), each with 16 and 32 bits. `report` is called
// after each row.
std::vector<ParityRow> parity(Device& device, const std::vector<Reflectance>& forms, int size = 512,
                              const std::function<void(const ParityRow&)>& report = {});

}  // namespace brdf::render
