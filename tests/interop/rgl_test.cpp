// Tests a material that is written to an RGL file and read back: a fit to the samples recovers its width.
#include "interop/rgl.h"

#include <gtest/gtest.h>

#include "fit/fit.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/formats/read.h"
#include "io/samples/samples.h"

namespace brdf::interop {
namespace {

Material glossy(double alpha_x, double alpha_y) {
  Material m = make_material(*find_form("cook_torrance"), {"r", "g", "b"});
  m.terms[0].shape[0] = {alpha_x, alpha_y};
  for (auto& weights : m.terms[0].weights) weights = {0.2, 0.6, 0.3};
  return m;
}

TEST(RglExport, WidthsComeBackWithinHalfAPercent) {
  for (const double alpha : {0.05, 0.15, 0.5}) {
    fit::FitOptions options;
    options.cross_validation = false;
    const io::SampleTable table = io::read_samples(io::Content{"x.bsdf", rgl_of(glossy(alpha, alpha), "x")});
    const fit::FormFit f = fit::fit(table, {{*find_form("cook_torrance")}}, options).ranking.front();
    EXPECT_NEAR(f.material.terms[0].shape[0][0] / alpha, 1, 0.005) << alpha;
  }
}

TEST(RglExport, RefusesAnAnisotropicMaterial) {
  EXPECT_THROW(rgl_of(glossy(0.1, 0.3), "x"), InputError);
}

}  // namespace
}  // namespace brdf::interop
