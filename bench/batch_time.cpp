// Times the library's batches for a million pairs, for bench/python_batches.py. Prints seconds of processor
// time, the best of all rounds.
//   batch_time FORM double|float ROUNDS
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "brdf/material.h"

namespace {

constexpr std::size_t kPairs = 1'000'000;

template <class T>
double best_time(const brdf::Material& material, int rounds) {
  brdf::DirectionArrays<T> pairs(kPairs);
  for (std::size_t k = 0; k < kPairs; ++k) {
    const auto at = [&](double turn) {
      const double theta = double(k % 89) * turn, phi = double(k % 360);
      return brdf::direction(brdf::degrees(theta), brdf::degrees(phi));
    };
    const brdf::Vec3<double> wi = at(1), wo = at(0.5);
    pairs.set(k, {T(wi.x), T(wi.y), T(wi.z)}, {T(wo.x), T(wo.y), T(wo.z)});
  }
  std::vector<T> out(kPairs);
  double best = 1e9;
  for (int round = 0; round < rounds; ++round) {
    const std::clock_t begin = std::clock();
    for (std::size_t c = 0; c < material.channels.size(); ++c)
      brdf::eval_batch(material.terms[0], c, pairs.view(), out.data());
    best = std::min(best, double(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return best;
}

}  // namespace

int main(int argc, char** argv) {
  const auto form = argc == 4 ? brdf::find_form(argv[1]) : std::nullopt;
  if (!form) return std::fputs("usage: batch_time FORM double|float ROUNDS\n", stderr), 2;
  const brdf::Material material = brdf::make_material(*form, {"fr"});
  const int rounds = std::atoi(argv[3]);
  const bool single = std::string(argv[2]) == "float";
  std::printf("%.9f\n", single ? best_time<float>(material, rounds) : best_time<double>(material, rounds));
}
