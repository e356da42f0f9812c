// What a texel costs: on one thread, by processor time.
#include <gtest/gtest.h>

#include <ctime>
#include <iostream>

#include "fit/fit.h"
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

// Microseconds for each texel: read, from the neighbour's solution, from the grid, and as a table of its own.
struct Cost {
  double read, warm, grid, table;
};

Cost cost_of(synth::TexelOptions o, bool fits_normal) {
  o.noise = 0.03;
  const TemporaryFolder folder;
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
                  fitter.fit(std::span(&pixels[k * values], values),
                             fits_normal ? Vec3<double>{0, 0, 1} : normal(k), nullptr);
              }) /
              (1e-6 * some);
  fit::FitOptions options;
  options.cross_validation = false;
  cost.table = seconds_of([&] {
                 for (std::size_t k = 0; k < some; ++k)
                   fit::fit(maps::texel_table(stack, std::span(&pixels[k * values], values), normal(k)),
                            {settings.forms}, options);
               }) /
               (1e-6 * some);
  std::cout << stack.images.size() << " images, normals " << (fits_normal ? "fitted" : "given") << ": "
            << cost.warm << " us for each texel from its neighbour, " << cost.grid << " from the grid, "
            << cost.table << " as a table of its own, " << cost.read << " to read\n";
  return cost;
}

// Against the same machine's fit of the texel's table, so that what else the machine does falls out.
TEST(MapsSpeed, ATexelOf151ImagesCostsATwentiethOfItsTable) {
  const Cost given = cost_of(small_stack(64, 151), false);
  EXPECT_LT(given.warm, 0.05 * given.table);
  EXPECT_LT(given.grid, 0.25 * given.table);
  const Cost fitted = cost_of(small_stack(64, 151), true);
  EXPECT_LT(fitted.warm, 0.1 * fitted.table);
}

}  // namespace
}  // namespace brdf
