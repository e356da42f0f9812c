// Random numbers of the simulations. Each combination of seed, surface and purpose has independent numbers;
// the work can therefore be distributed over any number of threads.
#pragma once

#include <cstdint>

#include "brdf/random.h"

namespace brdf::micro {

enum class Purpose : std::uint32_t { geometry, scatter, radiance, exchange, masking };

inline Random random_for(std::uint64_t seed, std::uint64_t surface, Purpose purpose) {
  std::seed_seq seeds{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                      static_cast<std::uint32_t>(surface), static_cast<std::uint32_t>(purpose)};
  return Random(seeds);
}

}  // namespace brdf::micro
