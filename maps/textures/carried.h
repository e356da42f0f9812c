// Maps carried into the formula of another program, as textures, with the loss in every texel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interop/loss.h"
#include "io/files/json.h"
#include "io/files/parallel.h"
#include "maps/textures/inputs.h"
#include "maps/textures/texel_materials.h"

namespace brdf::maps {

// The numbers of one input in every texel.
struct InputMap {
  Input input;
  // One factor for each colour; a texture holds shares of the factor. If the input is constant, the factor
  // is its value.
  std::vector<double> factors;
  bool constant = true;
  std::vector<std::vector<double>> shares{};  // [colour][texel] as a texture stores them; 0 without a fit
};

// The loss of the texels: quantiles over the carried texels, and the texel of the largest.
struct TexelLoss {
  double median = 0, most = 0 /* 95 % */, largest = 0;
  std::size_t where = 0;
};

// The losses of a texel. They are NaN in texels that are not carried.
struct TexelLosses {
  // Root mean square of ln(1 + f cos_i) - ln(1 + g cos_i) over the pairs of interop::Pairs::judged.
  std::vector<float> rms;
  std::vector<float> of_formula;  // the same, if the texture held real numbers and the normal exactly
  std::vector<float> largest;     // largest relative difference of f + 0.001/sr over the same pairs
  std::vector<float> turned;      // angle in degrees between the normal and the normal of the texture
};

struct Carried {
  const interop::Program* program = nullptr;
  Reflectance target;
  std::vector<InputMap> inputs{};
  // The index of refraction of all texels, if the target has one and no input drives it.
  std::optional<double> index{};
  bool has_normals = false;
  // The normals of the texture with the numbers x: 2 x - 1, not normalised.
  std::vector<Vec3<double>> normals{};
  std::vector<bool> held{};  // the texels that the program shows
  std::size_t without_fit = 0, refused = 0;
  std::string reason{};  // of the first refused texel
  TexelLosses losses{};

  const InputMap& input(std::string_view name) const;
  bool is_whole() const { return without_fit + refused == 0; }
};

// Carries the maps into the nearest target of the program. Throws interop::Refused if the program gets no
// textures or if no texel can be carried.
Carried carry(const TexelMaterials& maps, const interop::Program& program, const io::Progress& progress = {});

// Returns the material that the textures mean in a texel that is held, in the frame of its normal.
Material carried_material(const Carried& carried, const TexelMaterials& maps, std::size_t texel);

// Returns the figures over the texels that are held.
TexelLoss summary_of(const std::vector<float>& losses);

// Returns sentences about texels, losses and rounding, for people and for the header of the file.
std::vector<std::string> sentences(const Carried& carried, const TexelMaterials& maps);
io::Json to_json(const Carried& carried, const TexelMaterials& maps);
// Returns the losses as planes `rms`, `rms_of_formula`, `largest` and `normal_turned`, NaN in other texels.
texel::Planes loss_planes(const Carried& carried, const TexelMaterials& maps);

}  // namespace brdf::maps
