// Checks of outside code and of samplers in a build with an empty BRDF_OUTSIDE, such as the page for
// browsers, in place of the folders outside and joint: refused by name.
#include "io/files/error.h"
#include "validate/joint/judge_sampler.h"
#include "validate/outside/outside_checks.h"
#include "validate/outside/rare_branches.h"

namespace brdf::validate {
namespace {

[[noreturn]] void refuse(const Subject& subject, const char* checks) {
  throw InputError(subject.name() + ": this build has no checks of " + checks + ": use `brdf validate`");
}

}  // namespace

std::vector<Finding> judge_sampler(const Subject& subject, const DirectionSampler&, const CheckOptions&,
                                   std::size_t) {
  refuse(subject, "samplers");
}

Finding check_undefined(const Subject& subject, const CheckOptions&) {
  refuse(subject, "shaders");
}

Finding check_float(const Subject& subject, const CheckOptions&) {
  refuse(subject, "shaders");
}

Finding check_outside_finite(const Subject& subject, const CheckOptions&) {
  refuse(subject, "shaders");
}

void apply_voids(const Subject& subject, std::span<Finding>) {
  refuse(subject, "shaders");
}

void apply_rare_branches(const Subject& subject, const CheckOptions&, std::span<Finding>) {
  refuse(subject, "shaders");
}

}  // namespace brdf::validate
