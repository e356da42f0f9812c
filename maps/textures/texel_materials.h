// The materials of a file of fitted maps, one for each texel.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "brdf/vec3.h"
#include "texel/planes.h"

namespace brdf::maps {

class TexelMaterials {
 public:
  // Reads maps.exr of `brdf fit STACK`. Throws InputError if the file is no image of fitted parameters, if it
  // holds a sum of forms or shapes for each channel, if a parameter is outside its range, if the surface is
  // anisotropic in a texel, or if no texel has a fit.
  explicit TexelMaterials(const std::filesystem::path& path);

  std::size_t width() const { return planes_.width; }
  std::size_t height() const { return planes_.height; }
  std::size_t size() const { return planes_.width * planes_.height; }
  const Reflectance& form() const { return form_; }
  const std::vector<std::string>& channels() const { return channels_; }
  const std::string& name() const { return name_; }  // of the file, for messages

  // Returns true if every parameter of the texel is a number. Texels are numbered row by row from the top.
  bool fitted(std::size_t texel) const { return fitted_[texel]; }
  std::size_t fitted_count() const;
  // Returns the number of fitted texels with a verdict that is no usable fit.
  std::size_t unusable_count() const { return unusable_; }
  // Returns the material of a fitted texel in the frame of its normal.
  Material at(std::size_t texel) const;
  // Returns the unit normal of a fitted texel: x to the right of the picture, y upwards.
  Vec3<double> normal(std::size_t texel) const;
  // Returns true if the normal of some fitted texel is not z.
  bool has_normals() const;
  // Returns "texel X,Y".
  std::string place(std::size_t texel) const;

 private:
  const std::vector<float>& plane(const std::string& parameter, const std::string& channel = "") const;
  void find_planes();
  void check_texel(std::size_t texel);

  texel::Planes planes_;
  std::string name_;
  Reflectance form_;
  std::vector<std::string> channels_;
  std::vector<const std::vector<float>*> shape_, weights_, normal_;  // weights_: by channel, then parameter
  std::vector<bool> fitted_;
  std::size_t unusable_ = 0;
};

}  // namespace brdf::maps
