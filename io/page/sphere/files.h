// Style, fragment shader and script of a page's spheres, embedded by the build.
#pragma once

namespace brdf::io::sphere {

extern const char* const kStyle;
extern const char* const kShader;  // after the functions of a material
extern const char* const kScript;

}  // namespace brdf::io::sphere
