// Materials as tables that Mitsuba and pbrt import.
#pragma once

#include <cstdint>
#include <string>

#include "brdf/material.h"

namespace brdf::interop {

inline constexpr std::uint64_t kUsualTable = 4'000'000;  // bytes

// An RGL file (io/formats/rgl_writer.h) of about this size. Throws Refused for an anisotropic material, whose
// azimuths it would not hold, InputError for channels that it has no place for.
std::string rgl_of(const Material& material, const std::string& description,
                   std::uint64_t bytes = kUsualTable);

}  // namespace brdf::interop
