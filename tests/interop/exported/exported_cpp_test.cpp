// Tests compiled C++ from `brdf export --to cpp`: its float values equal the library's bit for bit.
#include <gtest/gtest.h>

#include "brdf/material.h"
#include "brdf/random.h"
#include "cook_torrance.h"
#include "oren_nayar_energy.h"
#include "phong.h"
#include "ward.h"

namespace brdf {
namespace {

template <class Exported>
void expect_same_bits(const char* form, const char* weight, Exported&& exported) {
  Material m = make_material(*find_form(form), {"f"});
  m.terms[0].weights[0][std::size_t(m.terms[0].form.info().weight_index(weight))] = 0.3;
  Random random(9);
  for (int k = 0; k < 2000; ++k) {
    const auto draw = [&] {
      const Vec3<double> w = direction(degrees(random.uniform(0, 89)), degrees(random.uniform(0, 360)));
      return Vec3<float>{float(w.x), float(w.y), float(w.z)};
    };
    const Vec3<float> wi = draw(), wo = draw();
    float ours = 0;
    eval_batch(m.terms[0], 0, one_pair(wi, wo), &ours);
    EXPECT_EQ(exported(wi, wo), ours) << form << " " << k;
  }
}

TEST(ExportedCpp, HasTheLibrarysBits) {
  expect_same_bits("ward", "ks", [](auto i, auto o) {
    return ::ward::brdf_material({i.x, i.y, i.z}, {o.x, o.y, o.z}).g;
  });
  expect_same_bits("cook_torrance", "ks", [](auto i, auto o) {
    return ::cook_torrance::brdf_material({i.x, i.y, i.z}, {o.x, o.y, o.z}).g;
  });
  expect_same_bits("phong", "ks", [](auto i, auto o) {
    return ::phong::brdf_material({i.x, i.y, i.z}, {o.x, o.y, o.z}).g;
  });
  expect_same_bits("oren_nayar_energy", "rho", [](auto i, auto o) {
    return ::oren_nayar_energy::brdf_material({i.x, i.y, i.z}, {o.x, o.y, o.z}).g;
  });
}

}  // namespace
}  // namespace brdf
