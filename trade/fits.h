// Rows that need a fit: families against each other, and fits from few samples to many.
#pragma once

#include "brdf/material.h"
#include "io/samples.h"
#include "trade/question.h"

namespace brdf::trade {

// Seconds of one evaluation in a float batch, one channel, interleaved over the forms given.
std::vector<Cost> evaluation_costs(const std::vector<AnyForm>& forms, int rounds);

// `rows` samples of a material of one channel, directions spread evenly over both hemispheres up to
// `most_theta` degrees with every second pair near the mirror direction; lognormal noise of mean 1.
io::SampleTable sample_material(const Material& material, std::size_t rows, double noise,
                                double most_theta = 80);

// The form fitted to the table (cosine-weighted differences: what a picture shows), table order of
// parameters.
Material fitted(const AnyForm& form, const io::SampleTable& table, bool anisotropic = false);

struct FitRowsOptions {
  bool quick = false;
  const PicturePoints* picture = nullptr;
  std::function<void(const std::string&)> tick = [](const std::string&) {};
};
std::vector<LedgerRow> family_rows(const FitRowsOptions& options);
std::vector<LedgerRow> sample_count_rows(const FitRowsOptions& options);
std::vector<LedgerRow> batch_rows(const FitRowsOptions& options);

}  // namespace brdf::trade
