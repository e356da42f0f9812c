// Measures the processor time of a texel on one thread.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <iostream>

#include "brdf/frame.h"
#include "fit/fit.h"
#include "synth/random.h"
#include "tests/maps/stack.h"

namespace brdf {
namespace {

double processor_seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

template <class Work>
double seconds_of(Work&& work) {
  const double before = processor_seconds();
  work();
  return processor_seconds() - before;
}

// Microseconds for each texel: to read it, to fit it from the neighbour's solution, from the grid, and as a
// table of its own.
struct Cost {
  double read, warm, grid, table;
};

Cost cost_of(synth::TexelOptions o, bool fits_normal) {
  o.noise = 0.03;
  const io::TemporaryFolder folder;
  const Material material = lacquer();
  synth::write_stack(folder.path(), material, o);
  const texel::Stack stack = texel::open_stack(folder.path());
  const texel::Planes truth = texel::read_planes(folder.path() / "truth" / "truth.exr");
  const maps::Settings settings = settings_of(material, fits_normal);
  const double texels = 1e-6 * double(o.width * o.height);
  Cost cost{};
  std::vector<float> pixels;
  cost.read = seconds_of([&] { pixels = texel::read_region(stack, {0, 0, o.width, o.height}); }) / texels;
  cost.warm = seconds_of([&] {
                maps::fit_stack(stack, settings, fits_normal ? nullptr : &truth, {std::size_t{1} << 29, 1});
              }) / texels -
              cost.read;
  maps::TexelFitter fitter(stack, settings);
  const std::size_t values = stack.channels.size() * stack.images.size(), some = 8;
  const auto normal = [&](std::size_t k) {
    return Vec3<double>{double((*truth.find("normal.x"))[k]), double((*truth.find("normal.y"))[k]),
                        double((*truth.find("normal.z"))[k])};
  };
  cost.grid = seconds_of([&] {
                for (std::size_t k = 0; k < some; ++k)
                  fitter.fit({std::span(&pixels[k * values], values)},
                             fits_normal ? Vec3<double>{0, 0, 1} : normal(k), nullptr);
              }) /
              (1e-6 * some);
  fit::FitOptions options;
  options.cross_validation = false;
  cost.table = seconds_of([&] {
                 for (std::size_t k = 0; k < some; ++k)
                   fit::fit(maps::texel_table(stack, {std::span(&pixels[k * values], values)}, normal(k)),
                            {settings.forms}, options);
               }) /
               (1e-6 * some);
  std::cout << stack.images.size() << " images, normals " << (fits_normal ? "fitted" : "given") << ": "
            << cost.warm << " us for each texel from its neighbour, " << cost.grid << " from the grid, "
            << cost.table << " as a table of its own, " << cost.read << " to read\n";
  return cost;
}

// The bound is relative to the fit of the texel's table on the same machine, so that other load of the
// machine cancels.
TEST(MapsSpeed, ATexelOf151ImagesCostsATwentiethOfItsTable) {
  const Cost given = cost_of(small_stack(64, 151), false);
  EXPECT_LT(given.warm, 0.05 * given.table);
  EXPECT_LT(given.grid, 0.25 * given.table);
  const Cost fitted = cost_of(small_stack(64, 151), true);
  EXPECT_LT(fitted.warm, 0.1 * fitted.table);
}

// 151 lights by 151 viewers. The values come from memory, because files would cost more than the fits of so
// few texels.
TEST(MapsSpeed, ATexelOf22801ImagesCostsATenthOfItsTable) {
  synth::TexelOptions o = small_stack(8, 151);
  o.viewers = 151;
  o.vary = {{"alpha", 0.2, 0.3}, {"kd", 0.1, 0.6}};
  o.tilt = 10;
  const Material material = lacquer();
  const synth::Surface surface(material, o);
  texel::Stack stack;
  stack.width = stack.height = 8;
  stack.channels = {"r", "g", "b"};
  stack.lights = synth::stack_directions(o);
  const DirectionArrays<double> arrays = io::unit_directions(stack.lights);
  const std::size_t images = arrays.size(), texels = 24;
  synth::NormalPairs random(7);
  std::vector<std::vector<float>> pixels(texels, std::vector<float>(3 * images));
  std::vector<double> value(3);
  for (std::size_t t = 0; t < texels; ++t) {
    const double x = double(t % 8), y = double(t / 8);
    const Material here = surface.material(x, y);
    const Vec3<double> n = surface.normal(x, y);
    for (std::size_t k = 0; k < images; ++k) {
      eval_cos(here, in_frame_of(n, arrays.view().wi(k)), in_frame_of(n, arrays.view().wo(k)), value);
      for (std::size_t c = 0; c < 3; ++c)
        pixels[t][c * images + k] = float(value[c] * std::exp(0.03 * random.next().first));
    }
  }
  maps::Settings settings = settings_of(material, false);
  settings.options.metric = fit::Metric::log_relative;
  maps::TexelFitter fitter(stack, settings);
  maps::TexelFit last;
  const auto fit_all = [&](std::size_t first, bool warm) {
    for (std::size_t t = first; t < texels; ++t)
      last = fitter.fit({pixels[t], t % 8, t / 8}, surface.normal(double(t % 8), double(t / 8)),
                        warm && !last.empty() ? &last : nullptr);
  };
  fit_all(texels - 2, false);
  const double warm = 1e3 * seconds_of([&] { fit_all(0, true); }) / double(texels);
  const double grid = 1e3 * seconds_of([&] { fit_all(texels - 4, false); }) / 4;
  fit::FitOptions options = settings.options;
  options.cross_validation = false;
  const io::SampleTable table = maps::texel_table(stack, {pixels[1], 1, 0}, surface.normal(1, 0));
  fit::FitResult found;
  const double alone = 1e3 * seconds_of([&] { found = fit::fit(table, {settings.forms}, options); });
  const maps::TexelFit neighbour = fitter.fit({pixels[0], 0, 0}, surface.normal(0, 0), nullptr),
                       texel = fitter.fit({pixels[1], 1, 0}, surface.normal(1, 0), &neighbour);
  EXPECT_FALSE(texel.from_grid);
  EXPECT_EQ(texel.verdict, found.ranking[0].verdict);
  for (std::size_t k = 0; k < texel.estimates.size(); ++k) {
    const fit::Estimate &a = texel.estimates[k], &b = found.ranking[0].estimates[k];
    EXPECT_EQ(a.status, b.status) << b.name;
    if (b.status == fit::Status::free && b.standard_error < 0.3 * std::abs(b.value)) {
      EXPECT_NEAR(a.value, b.value, 1e-6 * std::abs(b.value)) << b.name << b.channel;
    }
  }
  const fit::Model model(settings.forms, stack.channels, options);
  const fit::FitData data = fit::prepare(table, options);
  const fit::SampleStream stream(data, model, fit::chosen_residual(data, options), 0);
  const double pass = 1e3 * seconds_of([&] {
                        for (int k = 0; k < 20; ++k) stream.normal_equations(model.initial());
                      }) /
                      20;
  std::cout << images << " images: " << warm << " ms for each texel from its neighbour, " << grid
            << " from the grid, " << alone << " as a table of its own; a pass of the solver " << pass << '\n';
  EXPECT_LT(warm, 0.1 * alone);
  EXPECT_LT(warm, 14 * pass);
}

}  // namespace
}  // namespace brdf
