// Recognises the roles of arguments from the names that are common in shaders.
#pragma once

#include <optional>
#include <string_view>

namespace brdf::shader {

// Vectors of the local frame.
enum class Axis { light, view, normal, half, tangent, bitangent };

// Returns the coordinate along an axis of the frame; -1 for other axes.
constexpr int frame_coordinate(Axis a) {
  return a == Axis::tangent ? 0 : a == Axis::bitangent ? 1 : a == Axis::normal ? 2 : -1;
}

// The meaning of an argument according to its name: a vector, the product of two vectors, or the colour of
// a light with intensity 1.
struct Meaning {
  enum class Kind { vector, product, white } kind = Kind::vector;
  Axis a = Axis::normal, b = Axis::normal;
};

// Returns the meaning of an argument; std::nullopt for a parameter. `name`: of the argument; members of
// structs as "light.direction". `vector`: the argument has three components.
std::optional<Meaning> meaning_of(std::string_view name, bool vector);

// Returns whether an argument of a sampler with this name and number of components (1 to 4) is random
// numbers: u, xi, rnd, urand, u1, xi_2, sample1 and similar names.
bool is_random(std::string_view name, std::size_t components);

}  // namespace brdf::shader
