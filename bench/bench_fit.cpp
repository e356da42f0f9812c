// Times fits of Cook-Torrance to 1.46 million RGB samples, for the solvers of this library and for the usual
// alternatives, interleaved in one run. The ratios are the result (docs/fitting.md).
//
//   bench_fit [--quick] [--repeats N] [--no-python]
//
// --quick takes every 16th sample and has no other effect. The scipy and numpy baselines of
// bench/fit_baselines.py run on the same samples unless --no-python is given; they take most of the minute.
#include <ceres/ceres.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/machine.h"
#include "brdf/facets.h"
#include "brdf/fresnel.h"
#include "brdf/material.h"
#include "brdf/random.h"
#include "fit/model/data.h"
#include "fit/solve/minima.h"
#include "fit/solve/varpro.h"
#include "trade/measure/timing.h"

namespace brdf::fit {
namespace {

// Returns the processor time: every method runs on one thread, and other programs must not count.
double now() {
  return timing::seconds_now(timing::Clock::process);
}

// Returns the largest resident size so far, in MB. The memory of a method is the growth while the method
// runs.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

constexpr double kAlpha = 0.2;

// Cook-Torrance: the catalogue's first form with GGX facets and Smith's masking.
Reflectance form_to_fit() {
  return find_form_if(
             [](const ReflectanceInfo& f) { return f.facets == &Facets<GgxSlopes, SmithGgx>::facts; })
      .value();
}

// Returns the half-difference cells of a measured table, 90 x 90 x 180, with Cook-Torrance values and 5 %
// noise.
FitData samples(bool quick) {
  Material truth = make_material(form_to_fit());
  truth.terms[0].shape[0] = {kAlpha, kAlpha};
  truth.terms[0].weights = {{0.3, 0.6, 0.1}, {0.2, 0.6, 0.2}, {0.1, 0.6, 0.5}};
  FitData data;
  data.channels = truth.channels;
  data.values.resize(3);
  Random random(1);
  std::vector<double> f(3);
  std::size_t index = 0;
  for (int h = 0; h < 90; ++h)
    for (int d = 0; d < 90; ++d)
      for (int p = 0; p < 180; ++p) {
        if (quick && index++ % 16 != 0) continue;
        const double th = kPi / 2 * (h + 0.5) * (h + 0.5) / 8100, td = kPi / 2 * (d + 0.5) / 90,
                     pd = kPi * (p + 0.5) / 180;
        const Vec3<double> diff = direction(radians(td), radians(pd));
        const double c = std::cos(th), s = std::sin(th);
        const Vec3<double> wi{diff.x * c + diff.z * s, diff.y, diff.z * c - diff.x * s};
        const Vec3<double> wo{-diff.x * c + diff.z * s, -diff.y, diff.z * c + diff.x * s};
        // Cells below the horizon, or too steep, are replaced by other directions to keep the number of 1.46
        // million.
        const double lowest = std::min(wi.z, wo.z);
        const Vec3<double> a = lowest > 0.17 ? wi : direction(radians(th), radians(pd));
        const Vec3<double> b = lowest > 0.17 ? wo : direction(radians(std::min(td, 1.39)), radians(2 * pd));
        const Vec3<double> i = a.z > 0.17 ? a : direction(radians(1.3), radians(pd));
        eval(truth, i, b, f);
        data.wi_x.push_back(i.x), data.wi_y.push_back(i.y), data.wi_z.push_back(i.z);
        data.wo_x.push_back(b.x), data.wo_y.push_back(b.y), data.wo_z.push_back(b.z);
        for (std::size_t k = 0; k < 3; ++k)
          data.values[k].push_back(f[k] * std::exp(0.05 * random.normal() - 0.00125));
        data.row.push_back(std::uint32_t(data.row.size()));
        data.incidence.push_back(0);
      }
  return data;
}

FitOptions options_for(Metric metric) {
  FitOptions options;
  options.metric = metric;
  options.cross_validation = false;
  options.aperture = 0.0;
  return options;
}

double fit_ours(const FitData& data, const Model& model, Metric metric) {
  Residual residual;
  residual.metric = metric;
  const FitOptions options = options_for(metric);
  const SearchResult found = find_minima(data, model, residual, options);
  return model.shape(found.minima.front().p, 0, 0)[0];
}

// Fits without variable projection, with Ceres on the streamed normal equations of all parameters.
double fit_streamed(const FitData& data, const Model& model) {
  Residual residual;
  residual.metric = Metric::cosine_l2;
  const SampleStream stream(data, model, residual, 0);
  std::vector<double> start = model.initial();
  for (std::size_t k = model.shape_slots(); k < start.size(); ++k) start[k] = 0.3;
  const Objective objective = [&](std::span<const double> p) { return stream.normal_equations(p); };
  SolveOptions o;
  o.tolerance = 1e-8;
  return model.shape(solve(objective, start, model.low(), model.high(), o).p, 0, 0)[0];
}

// The usual first solution by a user of Ceres: one residual block per sample, automatic derivatives.
struct SampleResidual {
  Vec3<double> wi, wo;
  double g[3];
  template <class T>
  bool operator()(const T* p, T* r) const {
    const Geometry<double> geo = geometry(wi, wo);
    const T alpha = math::exp(p[0]);
    const Roughness<T> widths{alpha, alpha};
    const T vd = quotient(d_ggx(widths, geo), v_smith_ggx(widths, geo));
    const std::array<T, 3> lobes{T(1 / kPi), vd, vd * schlick(geo)};
    for (int c = 0; c < 3; ++c)
      r[c] = (p[1 + 3 * c] * lobes[0] + p[2 + 3 * c] * lobes[1] + p[3 + 3 * c] * lobes[2] - T(g[c])) *
             T(geo.cos_i);
    return true;
  }
};

double fit_blocks(const FitData& data) {
  double p[10];
  std::fill(p, p + 10, 0.3);
  p[0] = std::log(0.3);
  ceres::Problem problem;
  for (std::size_t k = 0; k < data.rows(); ++k)
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<SampleResidual, 3, 10>(new SampleResidual{
                                 {data.wi_x[k], data.wi_y[k], data.wi_z[k]},
                                 {data.wo_x[k], data.wo_y[k], data.wo_z[k]},
                                 {data.values[0][k], data.values[1][k], data.values[2][k]}}),
                             nullptr, p);
  ceres::Solver::Options o;
  o.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  o.function_tolerance = 1e-8;
  o.logging_type = ceres::SILENT;
  o.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(o, &problem, &summary);
  return std::exp(p[0]);
}

struct Method {
  const char* name;
  std::function<double()> run;
  int repeats;
  double best = 1e300, memory = 0, alpha = 0;
};

void write_binary(const FitData& data, const std::filesystem::path& path) {
  std::ofstream out(path, std::ios::binary);
  for (const auto* column : {&data.wi_x, &data.wi_y, &data.wi_z, &data.wo_x, &data.wo_y, &data.wo_z,
                             &data.values[0], &data.values[1], &data.values[2]})
    out.write(reinterpret_cast<const char*>(column->data()),
              std::streamsize(column->size() * sizeof(double)));
}

// Returns the first of `python3` and Debian's python3 that has scipy, or an empty string if neither has.
std::string python_with_scipy() {
  for (const std::string python : {"python3", "/usr/bin/python3"})
    if (std::system((python + " -c 'import numpy, scipy' 2>/dev/null").c_str()) == 0) return python;
  return {};
}

// Runs bench/fit_baselines.py, which prints one row per method, and returns the seconds of the methods in
// the same order: numpy, scipy. Throws std::runtime_error if the script fails.
std::vector<double> run_python(const std::string& python, const FitData& data, double ours) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("bench_fit_" + std::to_string(getpid()) + ".bin");
  write_binary(data, file);
  std::fflush(stdout);
  const std::string command = "OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 " + python +
                              " '" BRDF_BENCH_DIR "/fit_baselines.py' '" + file.string() + "' " +
                              std::to_string(ours);
  FILE* pipe = popen(command.c_str(), "r");
  std::vector<double> seconds;
  for (char line[256]; pipe != nullptr && std::fgets(line, sizeof line, pipe) != nullptr;) {
    std::fputs(line, stdout);
    std::fflush(stdout);
    seconds.push_back(std::atof(line + 38));
  }
  const int status = pipe == nullptr ? -1 : pclose(pipe);
  std::filesystem::remove(file);
  if (status != 0 || seconds.size() != 2) throw std::runtime_error("bench/fit_baselines.py failed");
  return seconds;
}

void measure(std::vector<Method>& methods, int repeats) {
  for (int k = 0; k < repeats; ++k)
    for (Method& m : methods) {
      if (k >= m.repeats) continue;
      const double before = peak_memory(), begin = now();
      m.alpha = m.run();
      m.best = std::min(m.best, now() - begin);
      m.memory = std::max(m.memory, peak_memory() - before);
    }
}

int run(int argc, char** argv) {
  bool quick = false, with_python = true;
  int repeats = 7;
  for (int k = 1; k < argc; ++k) {
    if (!std::strcmp(argv[k], "--quick")) quick = true;
    if (!std::strcmp(argv[k], "--repeats") && k + 1 < argc) repeats = std::atoi(argv[++k]);
    if (!std::strcmp(argv[k], "--no-python")) with_python = false;
  }
  const FitData data = samples(quick);
  const Model model({form_to_fit()}, data.channels, {});
  std::printf("%s\n%zu RGB samples, Cook-Torrance, one thread\n", bench::machine().c_str(), data.rows());
  std::vector<Method> methods{
      {"variable projection (cosine_l2)", [&] { return fit_ours(data, model, Metric::cosine_l2); }, repeats},
      {"log residual, grid of starts", [&] { return fit_ours(data, model, Metric::log); }, repeats},
      {"Ceres on streamed normal equations", [&] { return fit_streamed(data, model); }, repeats},
      {"Ceres, one block per sample", [&] { return fit_blocks(data); }, std::min(repeats, 2)}};
  measure(methods, repeats);
  std::printf("%-38s %9s %9s %9s %10s\n", "method", "seconds", "ratio", "MB more", "width");
  for (const Method& m : methods)
    std::printf("%-38s %9.4f %9.1f %9.1f %10.6f\n", m.name, m.best, m.best / methods[0].best, m.memory,
                m.alpha);
  const double ours = methods[0].best;
  std::vector<double> python_seconds;
  const std::string python = with_python ? python_with_scipy() : "";
  if (!python.empty())
    python_seconds = run_python(python, data, ours);
  else if (with_python)
    std::printf("no numpy and scipy rows: no python3 with scipy (Debian: python3-scipy)\n");
  if (quick) return 0;
  std::printf("goals\n");
  bench::print_goal("variable projection, seconds", ours, false, 0.1);
  bench::print_goal("variable projection, MB beyond the data", methods[0].memory, false, 10);
  bench::print_goal("log residual, seconds", methods[1].best, false, 1);
  if (!python_seconds.empty()) {
    bench::print_goal("numpy over variable projection", python_seconds[0] / ours, true, 4);
    bench::print_goal("scipy over variable projection", python_seconds[1] / ours, true, 80);
  }
  return 0;
}

}  // namespace
}  // namespace brdf::fit

int main(int argc, char** argv) {
  try {
    return brdf::fit::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_fit: %s\n", error.what());
    return 1;
  }
}
