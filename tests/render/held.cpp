// Parameters in excess of a shader's slots are held with the form. Values in a slot beyond the table are
// ignored.
#include "render/gpu/held.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "io/material/material_json.h"
#include "render/gpu/gpu_layout.h"

namespace brdf::render {
namespace {

TEST(Held, TakesAsManyValuesAsItsTableHas) {
  Material whole = make_material(*find_form("gltf_metallic_roughness"), {"f"});
  ASSERT_GT(whole.terms[0].shape[0].size(), kMostShape);
  const Reflectance held = with_room(whole).terms[0].form;
  ASSERT_EQ(held.info().shape.size(), kMostShape);
  const std::vector<double> weights{0.6, 1, 7}, shape{0.2, 0.3, 0.4, 7, 7, 7};
  std::copy_n(shape.begin(), kMostShape, whole.terms[0].shape[0].begin());
  whole.terms[0].weights[0][0] = weights[0];
  const Vec3<double> wi = direction(30_deg, 0_deg), wo = direction(50_deg, 170_deg);
  double found = 0, expected = 0;
  held->eval({weights, weights, shape}, one_pair(wi, wo), &found);
  eval(whole, wi, wo, std::span(&expected, 1));
  EXPECT_EQ(found, expected);
}

// A saved file contains all parameters: the held parameters and the parameters that the sliders moved.
TEST(Held, IsSavedWithAllItsParameters) {
  Material whole = make_material(*find_form("gltf_metallic_roughness"), {"f"});
  Material moved = with_room(whole);
  moved.terms[0].shape[0][1] = whole.terms[0].shape[0][1] = 0.37;
  EXPECT_EQ(io::to_json(moved), io::to_json(whole));
  EXPECT_NE(moved.terms[0].shape[0].size(), whole.terms[0].shape[0].size());
}

}  // namespace
}  // namespace brdf::render
