// One program's text each. What is common to them is in reading.h.
#pragma once

#include <string>

namespace brdf::interop {

struct Written;

// A Python script that makes the node material: make_material(name, tangent).
std::string write_blender(const Written& w);
std::string write_blender_3_4(const Written& w);
// A scene with the bsdf, to be included.
std::string write_mitsuba(const Written& w);
// MakeNamedMaterial.
std::string write_pbrt(const Written& w);
// A file with one material and its extensions.
std::string write_gltf(const Written& w);
// A nodegraph of pbrlib with its surface and material.
std::string write_materialx(const Written& w);
// A surface shader of OSL that adds closures.
std::string write_osl(const Written& w);

}  // namespace brdf::interop
