// Tests the rows that need the renderer, on any available Vulkan driver.
#include "trade/questions/frames.h"

#include <gtest/gtest.h>

#include "io/files/error.h"
#include "render/proof/shader_proof.h"
#include "trade/questions/ball.h"
#include "trade/questions/evaluations.h"

namespace brdf::trade {
namespace {

class Frames : public testing::Test {
 protected:
  void SetUp() override {
    try {
      device_ = std::make_unique<render::Device>();
    } catch (const EnvironmentError& e) {
      GTEST_SKIP() << e.what();
    }
  }
  // Returns the rows of a question from a single round, because these tests check errors and not costs.
  std::vector<LedgerRow> rows_of(const std::string& name) {
    for (FrameQuestion& q : frame_questions(FrameDetail::quick))
      if (q.name == name) return measure_frames(*device_, q, 1);
    ADD_FAILURE() << "no question " << name;
    return {};
  }
  static const LedgerRow& row(const std::vector<LedgerRow>& rows, const std::string& choice) {
    for (const LedgerRow& r : rows)
      if (r.choice == choice) return r;
    throw InputError("no row " + choice);
  }
  static double image(const std::vector<LedgerRow>& rows, const std::string& choice) {
    return row(rows, choice).image_error.value();
  }
  std::unique_ptr<render::Device> device_;
};

TEST(PictureError, IsOfSurfacePixelsOfBothPicturesAlone) {
  render::Picture exact(3, 1), picture(3, 1);
  exact.pixels = {{1, 1, 1, 1}, {2, 2, 2, 1}, {9, 9, 9, 0}};
  picture.pixels = {{1, 1, 1, 1}, {1.5f, 1.5f, 1.5f, 1}, {0, 0, 0, 1}};
  const PictureError e = picture_error(picture, exact, [](int, int) { return true; });
  EXPECT_DOUBLE_EQ(e.error.max, 0.5);
  EXPECT_EQ(e.error.where, "pixel 1, 0");
  EXPECT_DOUBLE_EQ(e.error.mean, 0.25);
  EXPECT_DOUBLE_EQ(e.image, 0.5 / 3);
  EXPECT_DOUBLE_EQ(e.root_mean_square, 0.5 / std::sqrt(2.0));
  EXPECT_EQ(picture_error(picture, exact, [](int x, int) { return x == 0; }).error.max, 0);
}

TEST_F(Frames, UnitNormalsBeatGouraudAndTrianglesBeatBoth) {
  const auto rows = rows_of("where to shade: diffuse");
  EXPECT_EQ(rows[0].error.max, 0);
  for (const char* triangles : {"320 triangles, ", "5120 triangles, "}) {
    const std::string at = triangles;
    EXPECT_LT(image(rows, at + "Phong"), image(rows, at + "Phong as coded"));
    EXPECT_LT(image(rows, at + "Phong as coded"), image(rows, at + "Gouraud"));
    EXPECT_LT(image(rows, at + "Gouraud"), image(rows, at + "flat"));
    EXPECT_LT(image(rows, at + "flat"), image(rows, at + "vertex colours"));
  }
  // The error is of second order in the length of the edges. 16 times the triangles reduce it to a
  // sixteenth, and to less than that at the terminator.
  const double gain = image(rows, "320 triangles, Gouraud") / image(rows, "5120 triangles, Gouraud");
  EXPECT_GT(gain, 8);
  EXPECT_LT(gain, 18);
  for (const LedgerRow& r : rows) EXPECT_EQ(r.extremes.size(), 2u);
}

TEST_F(Frames, AHighlightPerVertexNeedsManyMoreTriangles) {
  const auto rows = rows_of("where to shade: highlight");
  EXPECT_GT(image(rows, "320 triangles, highlight per vertex"),
            3 * image(rows, "320 triangles, highlight per pixel"));
  EXPECT_GT(image(rows, "5120 triangles, highlight as coded"), 0.1);
}

TEST_F(Frames, BitsOfTheGBuffer) {
  const auto rows = rows_of("bits of the G-buffer, alpha 0.05");
  EXPECT_LT(image(rows, "16 bits"), 1e-3);
  EXPECT_GT(image(rows, "16 bits"), 1e-6);
  EXPECT_GT(image(rows, "8 bits"), 10 * image(rows, "16 bits"));
}

TEST_F(Frames, ForwardAndDeferredDrawTheSamePicture) {
  const auto rows = rows_of("forward or deferred, 4 lights");
  EXPECT_LT(row(rows, "deferred, 32 bits").error.max, 1e-5);
}

TEST_F(Frames, TheLookupTexturesFrameHasTheKernelsImageError) {
  const auto rows = rows_of("lookup texture in a frame");
  // The row of the kernel for the same texture has 0.0084 over the whole sphere, including the limb.
  EXPECT_NEAR(image(rows, "512^2, 8 bit, bilinear, per pixel"), 0.0084, 0.2 * 0.0084);
  EXPECT_GT(image(rows, "32^2, 8 bit, nearest, per pixel"), image(rows, "512^2, 8 bit, nearest, per pixel"));
  for (const char* bits : {"16 bit", "32 bit"})  // deeper texels change the picture a little
    EXPECT_NE(image(rows, std::string("512^2, ") + bits + ", bilinear, per pixel"),
              image(rows, "512^2, 8 bit, bilinear, per pixel"));
  EXPECT_GT(image(rows, "512^2, 8 bit, bilinear, per vertex, 320 triangles"),
            2 * image(rows, "512^2, 8 bit, bilinear, per vertex"));
  EXPECT_GT(image(rows, "512^2, 8 bit, bilinear, per pixel, the slip"), 0.1);
}

TEST_F(Frames, TheShaderHasTheLibrarysValues) {
  const int size = 32;
  const PicturePoints picture =
      picture_points(render::lit_points(render::prepare(material_ball(size))), size);
  const EvaluationOptions options{true, &picture, device_.get()};
  const double bound = render::is_software(*device_) ? 0 : 1e-3;
  for (const LedgerRow& r : shader_rows(options)) {
    EXPECT_LE(r.error.max, bound) << r.choice;
    EXPECT_LE(r.image_error.value(), bound) << r.choice;
    EXPECT_GT(r.cost.seconds, 0);
  }
  const auto rows = batch_rows(options);
  EXPECT_LT(row(rows, "shader on the driver").error.max, 1e-5);
  EXPECT_EQ(row(rows, "batch, double").error.max, 0);  // the same bits as pair by pair
}

}  // namespace
}  // namespace brdf::trade
