#include "io/formats/klems_bases.h"

#include "brdf/scalar.h"
#include "io/samples/degrees.h"

namespace brdf::io::klems {

const std::vector<Basis>& known_bases() {
  static const std::vector<Basis> bases{
      {"LBNL/Klems Full",
       {{0, 5, 1},
        {5, 15, 8},
        {15, 25, 16},
        {25, 35, 20},
        {35, 45, 24},
        {45, 55, 24},
        {55, 65, 24},
        {65, 75, 16},
        {75, 90, 12}}},
      {"LBNL/Klems Half",
       {{0, 6.5, 1},
        {6.5, 19.5, 8},
        {19.5, 32.5, 12},
        {32.5, 46.5, 16},
        {46.5, 61.5, 20},
        {61.5, 76.5, 12},
        {76.5, 90, 4}}},
      {"LBNL/Klems Quarter", {{0, 9, 1}, {9, 27, 8}, {27, 46, 12}, {46, 66, 12}, {66, 90, 8}}}};
  return bases;
}

std::vector<Patch> patches_of(const std::vector<Ring>& rings) {
  std::vector<Patch> patches;
  for (const auto& [lower, upper, count] : rings) {
    const double low = sin_degrees(lower), high = sin_degrees(upper);
    const bool is_pole = lower == 0 && count == 1;
    const auto n = static_cast<double>(count);
    for (std::size_t j = 0; j < count; ++j)
      patches.push_back({is_pole ? 0 : (lower + upper) / 2, 360 * static_cast<double>(j) / n, lower, upper,
                         360 / n, kPi * (high * high - low * low) / n});
  }
  return patches;
}

}  // namespace brdf::io::klems
