// Python functions of arrays as a reflectance, a sampler and a density that can be judged.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "brdf/direction_sampler.h"
#include "python/binding.h"

namespace brdf::python {

// Functions of python/brdf/callables.py, which check the shapes of the results; an absent function is a null
// object of Python. The thread that judges calls them with the interpreter's lock, one call at a time.
struct Callables {
  py::object eval;     // wi (n, 3), wo (n, 3): the values (n, channels)
  py::object sample;   // u (n, randoms), wo (n, 3): wi (n, 3), pdf (n), value (n, channels), valid (n);
                       // all but the first may be absent
  py::object density;  // wi (n, 3), wo (n, 3): the densities (n)
  std::vector<std::string> channels;  // at most three
  std::size_t randoms;
  bool gives_pdf, gives_value;
  SampleValue returns;  // of eval
  std::optional<SampleValue> value;
  DensityOf measure;
};

// Both results refer to the functions. If `stop` becomes true, the next call throws Stopped.
Material material_of_functions(const Callables& functions, const std::atomic<bool>& stop);
std::unique_ptr<const DirectionSampler> sampler_of_functions(const Callables& functions,
                                                             const std::atomic<bool>& stop);

}  // namespace brdf::python
