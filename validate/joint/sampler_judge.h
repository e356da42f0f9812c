// The judge of a sampler and its density: the state of judge_sampler() (judge_sampler.h) between the cases.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "brdf/integrals.h"
#include "validate/joint/catalogue_noise.h"
#include "validate/joint/cells.h"
#include "validate/joint/density_cause.h"
#include "validate/joint/holes.h"
#include "validate/joint/jacobian.h"
#include "validate/joint/judge_sampler.h"
#include "validate/joint/pointwise.h"
#include "validate/joint/weights.h"

namespace brdf::validate {

inline constexpr double kMassBound = 1e-4, kLostAlbedo = 1e-4;

class SamplerJudge {
 public:
  // Places in kSamplerChecks.
  enum Place : std::size_t {
    mass,
    match,
    value,
    jacobian,
    distribution,
    mean,
    support,
    range,
    single,
    places
  };
  static_assert(std::size(kSamplerChecks) == places);

  SamplerJudge(const Subject& subject, const DirectionSampler& sampler, const CheckOptions& options,
               std::size_t draws_of_a_case);

  std::vector<Finding> run();

 private:
  bool has_pdf() const { return facts_.has_density || facts_.gives_pdf; }
  std::uint64_t seed(std::size_t k) const { return options_.seed * 1000003 + k; }
  std::size_t draws() const { return draws_; }

  // Keeps the worst place of a check. `severity`: larger is worse.
  struct Worst {
    double severity = -1;
    std::string text = {};
    Witness witness = {};
  };
  void worse(Place place, double severity, const std::string& text, const Trio& trio,
             const Vec3<double>* wi = nullptr, std::span<const double> u = {});
  void one_case(std::size_t k);
  void judge_support(const Trio& trio, const Integrals& integrals, std::size_t k);
  void judge_holes(const Trio& trio, const Holes& holes);
  void judge_impossible(const Trio& trio, const ComparedDraws& draws);
  std::vector<DensityRow> judge_jacobian(const Trio& trio, std::size_t k);
  void judge_mass(const Trio& trio, const Integrals& in, long all, long lost,
                  const std::vector<DensityRow>& rows);
  void judge_draws(const Trio& trio, std::size_t k, const Cells& cells, std::optional<Integrals> integrals,
                   const std::vector<DensityRow>& rows);
  long most_evaluations() const { return full_ ? 1'000'000 : 200'000; }

  // Returns whether a cell, or the rest that is lost, has a number of samples that its integral does not
  // explain by chance alone.
  static bool looks_different(const Integrals& in, const std::vector<long>& observed, long lost,
                              std::size_t all);
  void judge_points(const Trio& trio, const Pointwise& p);
  void judge_ranges(const Trio& trio, const Pointwise& p);
  void keep_exceptions(Place place, const ComparedDraws& draws);

  // Returns whether the first value is the quotient f / pdf in the place of the weight.
  bool lacks_cosine(const Pointwise& p) const;
  std::string no_cosine_text() const;
  std::string value_name() const;
  std::string value_text(const Pointwise& p) const;
  void judge_distribution(const Trio& trio, const Cells& cells, const Integrals& in,
                          const std::vector<long>& observed, long lost, std::size_t all);

  // The chi-square value at the level of the test.
  double threshold(int degrees) const;

  // The deviation of the mean, in standard errors, that a test at the level allows; std::nullopt if a few
  // large weights dominate.
  std::optional<double> limit_of(const Moments& m, double error) const;
  void judge_mean(const Trio& trio, const Weights& weights);
  void judge_edges(const Trio& trio);
  void judge_single(const Trio& trio, std::size_t k);

  // Sets the outcome of a check that looked at something.
  void conclude_one(Place place, bool looked, const std::string& why_not, const std::string& if_good);
  std::string with_reasons(std::string text) const;
  void conclude();
  std::string values_text() const;
  // The clause on differences that rounding explains; empty without such differences.
  std::string exceptions_text(Place place) const;
  std::string range_text() const;
  std::string mass_text() const;
  std::string support_text() const;
  std::string jacobian_text() const;
  std::string single_text() const;

  // Samples per pixel for a noise of 1 %.
  std::string noise_text() const;

  const Subject& subject_;
  const DirectionSampler& sampler_;
  const SamplerFacts& facts_;
  CheckOptions options_;
  std::vector<SampledCase> cases_;
  std::vector<Finding> findings_;
  Quantities quantities_;
  int tests_ = 1;
  double level_ = 0;
  std::size_t draws_ = 0;
  bool full_ = false, too_many_ = false;
  std::array<Worst, places> worst_;
  std::array<long, places> done_{}, compared_{};
  std::array<double, places> power_{};
  // Samples that differ without failing the check, and the largest of these differences.
  std::array<long, places> exceptions_{};
  std::array<double, places> largest_exception_{};
  long probes_ = 0, decided_ = 0, branches_ = 0, lost_below_ = 0;
  int combinations_ = 0;
  CatalogueNoise best_;
  double largest_mass_error_ = 0, largest_ratio_error_ = 0, noise_ = 0, largest_weight_ = 0;
  std::string cause_, cause_of_value_;  // of the running case: a constant differs from case to case
  // Directions at which density_support looked, and directions without a density among them.
  long supported_ = 0, dark_ = 0;
  std::string jacobian_why_, mass_unknown_, support_unknown_, distribution_why_, mean_why_;
};

// The words about the viewing direction of a case.
std::string degrees_text(const SampledCase& c);

}  // namespace brdf::validate
