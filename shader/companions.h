// Finds the functions of a file that belong to its reflectance: the sampler of directions and the density of
// these directions. Names and results decide, as for the reflectance itself.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "shader/entry.h"

namespace brdf::shader {

// A value that a sampler returns with the direction; `kind` if its name states the quantity.
struct SampledValue {
  std::string name;
  ResultPart part;
  std::optional<SampleValue> kind = {};
};

struct FoundSampler {
  const spirv::Function* function = nullptr;  // null: the file has no sampler that is understood
  ResultPart direction;
  std::string direction_name = {};  // empty: the returned value
  std::optional<ResultPart> pdf = {}, valid = {};
  std::string pdf_name = {};
  std::vector<SampledValue> values = {};
  std::set<int> written = {}, accumulated = {};
  std::set<spirv::Id> generators = {};  // functions that return random numbers
  std::string missing = {};             // the reason if a function looks like a sampler but is not used
};

struct FoundDensity {
  const spirv::Function* function = nullptr;  // null: the file has no density
  ResultPart part = {-1, 0, 1};
  std::set<int> written = {}, accumulated = {};
  std::string missing = {};
};

// Return the function that `source` names; otherwise the function with a telling name that fits the name of
// the reflectance: brdf, brdfSample, brdfPdf; DisneyEval, DisneySample, DisneyPdf; evaluate, sample, pdf. A
// reflectance that writes its density as an argument named pdf is its own density. Throw InputError if a
// named function does not exist or does not have the results.
FoundSampler find_sampler(const spirv::Module& module, const Source& source,
                          const spirv::Function& reflectance);
FoundDensity find_density(const spirv::Module& module, const Source& source,
                          const spirv::Function& reflectance);

// Returns the functions that return random numbers: numbers from no arguments, or from the state of a
// generator, which they change.
std::set<spirv::Id> generators_of(const spirv::Module& module);

}  // namespace brdf::shader
