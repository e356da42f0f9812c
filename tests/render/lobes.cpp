// Plots of lobes with the measured points in them, and the position of the split.
#include <gtest/gtest.h>

#include "io/csv/csv.h"
#include "io/files/error.h"
#include "io/files/temporary.h"
#include "io/samples/degrees.h"
#include "render/compare/lobe_body.h"
#include "render/compare/lobe_plot.h"
#include "render/compare/lobe_points.h"
#include "render/compare/slice_plot.h"
#include "render/job.h"
#include "render/scene/prepared.h"

namespace brdf::render {
namespace {

io::SampleTable table_of(const Material& material, const std::vector<double>& theta_i,
                         const std::vector<double>& phi_o, double phi_i = 180) {
  io::SampleTable table;
  table.channels = material.channels;
  table.values.resize(material.channels.size());
  std::vector<double> f(material.channels.size());
  for (const double ti : theta_i) {
    for (double to = 0; to <= 80; to += 10) {
      for (const double phi : phi_o) {
        eval(material, io::unit_vector(ti, phi_i), io::unit_vector(to, phi), f);
        table.add_directions(ti, phi_i, to, phi);
        for (std::size_t c = 0; c < f.size(); ++c) table.values[c].push_back(f[c]);
      }
    }
  }
  return table;
}

TEST(Lobes, PointsAreTheRowsNearThePlaneAndTheLight) {
  const Material material = make_material(*find_form("cook_torrance"));
  const io::SampleTable table = table_of(material, {20, 40.8, 60}, {0, 3, 90, 180, 358});
  const std::vector<LobePoint> plane = points_in_plane(table, 40);
  // Points within half a degree of the plane count. Azimuth 3 leaves the plane by this much at the viewing
  // angle 9.6 degrees, azimuth 358 at 14.5 degrees.
  std::size_t forward = 0, backward = 0;
  for (const LobePoint& p : plane) {
    EXPECT_EQ(table.theta_i[p.row], 40.8);
    EXPECT_EQ(p.phi, 0);
    EXPECT_FALSE(table.phi_o[p.row] == 90 && table.theta_o[p.row] > 0);
    EXPECT_EQ(std::abs(p.theta), table.theta_o[p.row]);
    (p.theta >= 0 ? forward : backward) += 1;
    EXPECT_EQ(p.theta < 0, table.phi_o[p.row] == 180 && table.theta_o[p.row] > 0) << "towards the light";
  }
  EXPECT_EQ(backward, 8u);
  EXPECT_EQ(forward, 9u + 2 + 1 + 1 + 1);
  EXPECT_EQ(points_of_light(table, 40).size(), 45u);
  EXPECT_TRUE(points_in_plane(table, 30).empty());
  EXPECT_EQ(nearest_light(table, 45), 40.8);
  EXPECT_TRUE(std::isnan(nearest_light(io::SampleTable{}, 45)));
}

TEST(Lobes, OfATurnedSampleOnlyThePlotsOwnAzimuthCounts) {
  const Material material = make_material(*find_form("cook_torrance"));
  io::SampleTable table = table_of(material, {40}, {0}, 180);
  const io::SampleTable turned = table_of(material, {40}, {270}, 90);
  for (std::size_t k = 0; k < turned.rows(); ++k) {
    table.add_directions(40, 90, turned.theta_o[k], 270);
    for (std::size_t c = 0; c < 3; ++c) table.values[c].push_back(turned.values[c][k]);
  }
  EXPECT_EQ(points_in_plane(table, 40).size(), 9u);
  EXPECT_EQ(points_in_plane(turned, 40).size(), 9u);  // all rows are turned alike: their plane counts
}

TEST(Lobes, DotsOfTheMaterialItselfLieOnItsCurve) {
  Material material = make_material(*find_form("cook_torrance"), {"b", "g", "r"});
  material.terms[0].weights[2][0] *= 0.25;
  const io::SampleTable table = table_of(material, {45}, {0, 180});
  const std::vector<LobeCurve> curves = lobe_curves(material, "A", 45);
  const std::vector<LobeDot> dots = lobe_dots(table, 45);
  ASSERT_EQ(dots.size(), 3u * 18);
  for (const LobeDot& dot : dots) {
    const auto curve = std::find_if(curves.begin(), curves.end(),
                                    [&](const LobeCurve& c) { return c.channel == dot.channel; });
    ASSERT_NE(curve, curves.end());
    EXPECT_EQ(dot.color, curve->color) << dot.channel;
    const float on_curve = curve->values[std::size_t(int(std::lround(dot.theta_o)) + kSteepest)];
    EXPECT_NEAR(dot.value, on_curve, 1e-5f * on_curve) << dot.theta_o;
  }
  EXPECT_EQ(lobe_plot(curves, 45, -1, dots).dots.size(), dots.size());
  EXPECT_EQ(lobe_plot(curves, 45, 1, dots).dots.size(), dots.size() / 3);
  // Values above the curve increase the range of the plot.
  std::vector<LobeDot> bright = dots;
  bright[5].value = 1000;
  EXPECT_EQ(lobe_plot(curves, 45, -1, bright).largest, 1000);
}

TEST(Slice, DotsOfTheMaterialItselfLieOnItsCurvesBetweenWholeDecades) {
  const Material material = make_material(*find_form("cook_torrance"));
  const std::vector<LobeDot> dots = lobe_dots(table_of(material, {45}, {0, 180}), 45);
  const std::vector<LobeCurve> curves = lobe_curves(material, "A", 45);
  const SlicePlot plot = slice_plot(curves, -1, dots);
  ASSERT_EQ(plot.dots.size(), dots.size());
  ASSERT_LT(plot.low, plot.high);
  const auto value_at = [&](float y) {
    return std::pow(10.0f, float(plot.low) + y * float(plot.high - plot.low));
  };
  for (std::size_t k = 0; k < dots.size(); ++k) {
    const glm::vec2 at = plot.dots[k].at;
    EXPECT_NEAR(at.x, (dots[k].theta_o + 90) / 180, 1e-6);
    EXPECT_NEAR(value_at(at.y), dots[k].value, 1e-4f * dots[k].value);
  }
  // The last paths are the curves, with one point per degree.
  const LobePath& first = plot.paths[plot.paths.size() - curves.size()];
  EXPECT_EQ(first.color, curves[0].color);
  const std::size_t at_30 = std::size_t(kSteepest + 30);
  EXPECT_NEAR(value_at(first.points[at_30].y), curves[0].values[at_30], 1e-4f * curves[0].values[at_30]);
  EXPECT_EQ(slice_plot(curves, 1, dots).dots.size(), dots.size() / 3);
  // A value of 0 has no logarithm: the point lies at the lower edge and does not change the range.
  std::vector<LobeDot> with_zero = dots;
  with_zero[0].value = 0;
  EXPECT_EQ(slice_plot(curves, -1, with_zero).low, plot.low);
  EXPECT_EQ(slice_plot(curves, -1, with_zero).dots[0].at.y, 0);
}

// Returns the number of pixels for which `is` is true of the colour.
std::size_t count(const BytePicture& picture,
                  const std::function<bool(const std::array<std::uint8_t, 3>&)>& is) {
  return std::size_t(std::count_if(picture.pixels.begin(), picture.pixels.end(), is));
}

TEST(Lobes, TheBodyShowsTheColourAndThePointsOnIt) {
  Material red = make_material(*find_form("lambert"));
  red.terms[0].weights = {{0.8}, {0.1}, {0.1}};
  const auto is_red = [](const auto& p) { return p[0] > 60 && p[0] > 2 * p[1]; };
  const auto is_dot = [](const auto& p) { return p == std::array<std::uint8_t, 3>{255, 140, 40}; };
  const BytePicture bare = lobe_body_picture(red, "red", 40, nullptr, 320);
  EXPECT_GT(count(bare, is_red), 8000u);
  EXPECT_EQ(count(bare, is_dot), 0u);
  const io::SampleTable table = table_of(red, {40}, {0, 60, 120, 180, 240, 300});
  const BytePicture with_dots = lobe_body_picture(red, "red", 40, &table, 320);
  EXPECT_GT(count(with_dots, is_dot), 100u);
  // A lobe as narrow as a needle still gives a picture.
  EXPECT_NO_THROW(lobe_body_picture(make_material(*find_form("phong")), "narrow", 0, nullptr, 64));
}

TEST(Lobes, TheSplitCutsThroughTheHighlight) {
  Material material = make_material(*find_form("cook_torrance"));
  for (double& width : material.terms[0].shape[0]) width = 0.03;
  for (const glm::vec3 light : {glm::vec3(1, -1, -1), glm::vec3(-1, 0, -2), glm::vec3(0, -1, -1)}) {
    Scene scene = material_scene({{"m", material}});
    scene.camera.width = scene.camera.height = 128;
    scene.lights[0].vector = light;
    scene.ambient = glm::vec3(0);
    const Picture picture = render_reference(prepare(scene));
    std::size_t brightest = 0;
    for (std::size_t k = 0; k < picture.pixels.size(); ++k)
      if (picture.pixels[k].a > 0.5f && picture.pixels[k].g > picture.pixels[brightest].g) brightest = k;
    const float at = (float(brightest % 128) + 0.5f) / 128;
    EXPECT_NEAR(split_at_highlight(scene, 0), at, 0.02f) << light.x << ' ' << light.y;
  }
  Scene dark = material_scene({{"m", material}});
  dark.lights.clear();
  EXPECT_EQ(split_at_highlight(dark, 0), 0.5f);
}

TEST(Lobes, NoLightIsSwitchedOffInSilence) {
  ViewState state;
  state.scene = material_scene({{"m", make_material(*find_form("lambert"))}});
  EXPECT_EQ(left_out_note(state), "");
  state.other = Other::samples;
  EXPECT_EQ(left_out_note(state), "");  // not displayed
  state.display = Display::split;
  EXPECT_NE(left_out_note(state).find("ambient"), std::string::npos);
  state.scene.ambient = glm::vec3(0);
  EXPECT_EQ(left_out_note(state), "");
}

TEST(Lobes, SamplesAmongTheMaterialsAreTold) {
  const io::TemporaryFolder folder;
  const auto samples = folder.path() / "samples.json";  // detected by the content, not by the name
  io::write_samples(samples, table_of(make_material(*find_form("lambert")), {30}, {0}));
  Job job;
  job.materials = {samples};
  const Job told = with_samples_told(job);
  EXPECT_TRUE(told.materials.empty());
  EXPECT_EQ(told.measured, samples);
  const ViewState state = state_of(job);
  EXPECT_EQ(state.other, Other::samples);
  EXPECT_EQ(state.display, Display::flip);
  job.measured = samples;
  EXPECT_THROW(with_samples_told(job), InputError);
}

}  // namespace
}  // namespace brdf::render
