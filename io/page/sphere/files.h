// Style, fragment shader and script of the spheres of a page, embedded by the build.
#pragma once

namespace brdf::io::sphere {

extern const char* const kStyle;
extern const char* const kShader;  // follows the functions of a material
extern const char* const kScript;

}  // namespace brdf::io::sphere
