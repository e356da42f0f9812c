// Rows whose unit is a frame of the renderer: shading modes, bits of the G-buffer, forward or deferred light,
// the lookup texture, and the shader itself.
#pragma once

#include <functional>

#include "trade/ledger.h"

namespace brdf::trade {

struct FrameOptions {
  bool quick = false;
  std::function<void(const std::string&)> tick = [](const std::string&) {};
};

// Throws EnvironmentError without a Vulkan driver.
std::vector<LedgerRow> frame_rows(const FrameOptions& options);

}  // namespace brdf::trade
