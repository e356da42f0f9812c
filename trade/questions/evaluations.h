// Rows whose unit is an evaluation and whose choices are ways to run the same formula: pair by pair, in
// batches, in the shader; and what the families cost.
#pragma once

#include "brdf/material.h"
#include "render/vulkan/device.h"
#include "trade/measure/question.h"

namespace brdf::trade {

// Time of a batch of `count` evaluations in float, one channel,
// at the tables' defaults; interleaved over the forms given.
struct EvaluationTimes {
  std::vector<timing::Timing> timings;
  double count = 0;
};
EvaluationTimes evaluation_times(const std::vector<Reflectance>& forms, int rounds);

// f_r of the first channel of a material, which must outlive them.
Values values_of(const Material& material);

struct EvaluationOptions {
  bool quick = false;
  const PicturePoints* picture = nullptr;
  render::Device* device = nullptr;  // null: the shader's rows are left out
};
std::vector<LedgerRow> batch_rows(const EvaluationOptions& options);
// The canonical families in the shader, each against the library's float evaluation.
std::vector<LedgerRow> shader_rows(const EvaluationOptions& options);

}  // namespace brdf::trade
