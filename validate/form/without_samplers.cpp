// Samplers in a build that has no shaders, such as the page for browsers: no check of a sampler is made.
#include "io/files/error.h"
#include "validate/joint/judge_sampler.h"

namespace brdf::validate {

std::vector<Finding> judge_sampler(const Subject& subject, const DirectionSampler&, const CheckOptions&,
                                   std::size_t) {
  throw InputError(subject.name() + ": this build has no checks of samplers: use `brdf validate`");
}

}  // namespace brdf::validate
