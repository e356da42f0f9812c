// Deferred against Embree, form by form: direct light, pixel centres, one sphere.
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
  std::string parameters;  // "defaults", or "width 0.05" (and what stands for it)
  int gbuffer_bits = 16;
  Difference difference;
};

inline constexpr double kMostCoverageMismatch = 1e-4;
// The largest relative mean square error that is good: 1e-11 with 32-bit, 1e-6 with 16-bit targets.
double parity_bound(int gbuffer_bits);
bool passes(const ParityRow& row);

// Every form, of the catalogue or not, at its table's defaults and, where it has a width, at width 0.05
// (roughness sqrt(0.05), exponent 2/width^2 - 2); 16 and 32 bits each. `report` is called after each row.
std::vector<ParityRow> parity(Device& device, const std::vector<Reflectance>& forms, int size = 512,
                              const std::function<void(const ParityRow&)>& report = {});

}  // namespace brdf::render
