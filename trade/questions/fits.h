// Rows that need a fit: families against each other, and fits with few to many samples.
#pragma once

#include "brdf/material.h"
#include "io/samples/samples.h"
#include "trade/questions/evaluations.h"

namespace brdf::trade {

// Returns `rows` samples of a material of one channel. Directions are spread evenly over both hemispheres up
// to `most_theta` degrees, with every second pair near the mirror direction. The noise is lognormal with
// mean 1.
io::SampleTable sample_material(const Material& material, std::size_t rows, double noise,
                                double most_theta = 80);

// Returns the form fitted to the table by relative differences.
Material fitted(const Reflectance& form, const io::SampleTable& table, bool anisotropic = false);

struct FitRowsOptions {
  bool quick = false;
  const PicturePoints* picture = nullptr;
};
// Fits every fittable form to a material of a canonical form: "families for a material of NAME".
std::vector<LedgerRow> family_rows(const Reflectance& family, const EvaluationTimes& times,
                                   const FitRowsOptions& options);
// Fits the reference form to few and to many samples.
std::vector<LedgerRow> sample_count_rows(const FitRowsOptions& options);

// Returns the forms that are fitted, as input of evaluation_times().
std::vector<Reflectance> fittable_forms();
std::string families_question(const Reflectance& family);

}  // namespace brdf::trade
