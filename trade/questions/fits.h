// Rows that need a fit: families against each other, and fits from few samples to many.
#pragma once

#include "brdf/material.h"
#include "io/samples/samples.h"
#include "trade/questions/evaluations.h"

namespace brdf::trade {

// `rows` samples of a material of one channel, directions spread evenly over both hemispheres up to
// `most_theta` degrees with every second pair near the mirror direction; lognormal noise of mean 1.
io::SampleTable sample_material(const Material& material, std::size_t rows, double noise,
                                double most_theta = 80);

// The form fitted to the table, by relative differences.
Material fitted(const Reflectance& form, const io::SampleTable& table, bool anisotropic = false);

struct FitRowsOptions {
  bool quick = false;
  const PicturePoints* picture = nullptr;
};
// Every fittable form fitted to a material of a canonical one: "families for a material of NAME".
std::vector<LedgerRow> family_rows(const Reflectance& family, const EvaluationTimes& times,
                                   const FitRowsOptions& options);
std::vector<LedgerRow> sample_count_rows(const FitRowsOptions& options);

// The forms that are fitted, as evaluation_times() takes them.
std::vector<Reflectance> fittable_forms();
std::string families_question(const Reflectance& family);

}  // namespace brdf::trade
