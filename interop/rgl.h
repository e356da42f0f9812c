// Materials as tables that Mitsuba and pbrt import.
#pragma once

#include <cstdint>
#include <string>

#include "brdf/material.h"

namespace brdf::interop {

inline constexpr std::uint64_t kUsualTable = 4'000'000;  // bytes

// Returns an RGL file (io/formats/rgl_writer.h) of about this many bytes. Throws Refused for an anisotropic
// material, since the file would not hold its azimuths. Throws InputError for channels that the format
// cannot store.
std::string rgl_of(const Material& material, const std::string& description,
                   std::uint64_t bytes = kUsualTable);

}  // namespace brdf::interop
