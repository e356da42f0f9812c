// What the arguments of other people's functions are called.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace brdf::shader {

// Vectors of the local frame.
enum class Axis { light, view, normal, half, tangent, bitangent };

// What an argument stands for, told by its name: a vector, the product of two, light of intensity 1; nothing:
// a parameter.
struct Meaning {
  enum class Kind { vector, product, white } kind = Kind::vector;
  Axis a = Axis::normal, b = Axis::normal;
};

// `name`: of the argument, members of structs as "light.direction". `vector`: it has three components.
std::optional<Meaning> meaning_of(std::string_view name, bool vector);

}  // namespace brdf::shader
