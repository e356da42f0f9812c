// The inputs of the materials of other programs that textures drive, and the numbers that textures hold.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "interop/programs.h"

namespace brdf::maps {

// The numbers of a texture: 32-bit floats, or 8 bits of a share of a factor, linear or with the sRGB curve.
enum class Storage { real, linear_byte, srgb_byte };

// Returns the share in 0..1 that a texture reads back after `share` was rounded for it.
double rounded(Storage storage, double share);
// Returns the byte that such a texture stores.
unsigned char byte_of(Storage storage, double share);

// A scale between a parameter of the target and the number that the program's input takes.
struct Scale {
  double (*written)(double);
  double (*read)(double);  // the inverse
};

// An input of a program's material.
struct Input {
  std::string_view name;
  Role role;  // of the target's parameter; of metallic, `metallic`
  bool metallic = false;
  bool coloured = false;  // one number for each colour
  Storage storage = Storage::real;
  Scale scale;
};

// The inputs of one target. Parameters of the target without an input have one value for all texels.
struct TexturedTarget {
  std::string_view target;  // name of the form
  std::vector<Input> inputs;
  double least_width = 0;  // a smaller alpha would be shown as a mirror
};

// Returns the inputs of a target, or null if no textures are written for it.
const TexturedTarget* find_textured(std::string_view target);

// Returns the names of the programs that textures are written for.
std::vector<std::string_view> textured_programs();

// Access to one parameter of a term of a target.
class Knob {
 public:
  Knob(const Reflectance& target, const Input& input);
  double get(const Term& term, std::size_t colour) const;
  // Sets the parameter; both widths are set together. `term.shape` must have a set for each channel.
  void set(Term& term, std::size_t colour, double value) const;

 private:
  bool weight_ = false;
  std::vector<std::size_t> places_;
};

}  // namespace brdf::maps
