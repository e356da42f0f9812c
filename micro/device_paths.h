// Paths over mirrors, followed on a Vulkan device.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "micro/surface.h"

namespace brdf::micro {

// The place at which a path begins: shares of the period.
struct Start {
  double u, v;
};

// The device runs the functions of march.glsl in double. A device that rounds divisions and square roots
// correctly (Mesa's software driver does) returns the bits of this processor; Vulkan permits others.
class DevicePaths {
 public:
  // Tests pass their negative control as `shader`; empty: paths.comp. Throws EnvironmentError if no Vulkan
  // device computes in double.
  explicit DevicePaths(std::span<const std::uint32_t> shader = {});
  ~DevicePaths();
  // Returns the device's name.
  const std::string& device() const;
  // Returns whether the device is the processor itself (Mesa's software driver).
  bool is_software() const;
  // Follows paths from the direction wi; as March::path_over_mirrors. Calls visit(path) in the order of the
  // starts. Threads may share the object.
  void follow(const Surface& surface, const Vec& wi, double eta, int limit, std::span<const Start> starts,
              const std::function<void(const Path&)>& visit);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace brdf::micro
