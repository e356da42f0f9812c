// One case of a judged sampler: parameters and a viewing direction, with f, density and draws for it.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "brdf/direction_sampler.h"
#include "brdf/random.h"
#include "validate/search/options.h"
#include "validate/search/subject.h"

namespace brdf::validate {

struct SampledCase {
  Material at;
  Vec3<double> wo;
  double theta = 0, phi = 0;  // of wo, degrees
};

// Returns the cases: the default parameters at 20 and 65 degrees, then points of a cover of the parameters
// and of viewing angles up to 80 degrees. Colours differ between channels.
std::vector<SampledCase> cases_of(const Subject& subject, const SamplerFacts& facts,
                                  const CheckOptions& options);

class Trio {
 public:
  Trio(const DirectionSampler& sampler, const SampledCase& of) : sampler_(sampler), case_(of) {}

  const SamplerFacts& facts() const { return sampler_.facts(); }
  const SampledCase& at() const { return case_; }
  // Returns the same sampler in another case, which must outlive the result.
  Trio with(const SampledCase& other) const { return {sampler_, other}; }
  std::size_t channels() const { return case_.at.channels.size(); }

  // Returns f (or f cos_i) of all directions, channel by channel; 0 below the horizon, and everywhere if f is
  // not available.
  std::vector<double> f(std::span<const Vec3<double>> wi, bool times_cosine) const;
  // Returns the density of each direction, 1/sr. `wo`: another viewing direction.
  std::vector<double> density(std::span<const Vec3<double>> wi, bool single = false) const;
  double density_of(const Vec3<double>& wi, const Vec3<double>& wo) const;
  std::vector<Draw> draw(std::span<const double> u, bool single = false) const;
  Draw draw_one(std::span<const double> u) const;

  // Returns the number of random numbers that draws use: all of facts().randoms, or as many as a generator
  // was asked for in a trial run.
  std::size_t randoms_used() const;

 private:
  const DirectionSampler& sampler_;
  const SampledCase& case_;
};

// Calls `each(u, draws)` for `count` draws with random numbers from the seed, in blocks.
void for_draws(const Trio& trio, std::size_t count, std::uint64_t seed,
               const std::function<void(std::span<const double>, std::span<const Draw>)>& each);

// Returns whether a draw is a direction above the horizon that counts: it is valid and, if the sampler
// returns a density, the density is above 0.
inline bool counts(const SamplerFacts& facts, const Draw& draw) {
  return draw.valid && draw.wi.z > 0 && (!facts.gives_pdf || draw.pdf > 0);
}

// Returns the finding's place: parameters, angles of the viewer and of the sampled direction, random numbers.
Witness witness_of(const Subject& subject, const Trio& trio, std::string_view check,
                   const CheckOptions& options, const Vec3<double>* wi = nullptr,
                   std::span<const double> u = {});

}  // namespace brdf::validate
