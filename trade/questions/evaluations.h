// Rows with the unit "evaluation" that compare methods of running the same formula (pair by pair, in
// batches, in the shader), and the cost of the families.
#pragma once

#include "brdf/material.h"
#include "render/vulkan/device.h"
#include "trade/measure/question.h"

namespace brdf::trade {

// Time of a batch of `count` evaluations in float, one channel, at the tables' defaults. The given forms are
// interleaved.
struct EvaluationTimes {
  std::vector<timing::Timing> timings;
  double count = 0;
};
EvaluationTimes evaluation_times(const std::vector<Reflectance>& forms, int rounds);

// Returns f_r of the first channel of a material, which must outlive the result.
Values values_of(const Material& material);

struct EvaluationOptions {
  bool quick = false;
  const PicturePoints* picture = nullptr;
  render::Device* device = nullptr;  // null: the shader's rows are left out
};
// Compares methods of evaluating the reference form: pair by pair, in batches, in the shader.
std::vector<LedgerRow> batch_rows(const EvaluationOptions& options);
// Returns rows for the canonical families in the shader, each compared with the library's float evaluation.
std::vector<LedgerRow> shader_rows(const EvaluationOptions& options);

}  // namespace brdf::trade
