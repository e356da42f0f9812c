// Checks of samplers in a build with an empty BRDF_SAMPLERS, such as the page for browsers, in place of the
// folder joint: refused by name.
#include "io/files/error.h"
#include "validate/joint/judge_sampler.h"

namespace brdf::validate {

std::vector<Finding> judge_sampler(const Subject& subject, const DirectionSampler&, const CheckOptions&,
                                   std::size_t) {
  throw InputError(subject.name() + ": this build has no checks of samplers: use `brdf validate`");
}

}  // namespace brdf::validate
