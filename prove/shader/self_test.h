// Attacks the prover with shaders that have planted violations, and samples its enclosures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/files/parallel.h"

namespace brdf::prove {

struct SelfTestOptions {
  long planted = 300, sound = 60;  // random shaders
  long samples = 500'000;          // of enclosures, at least, in each precision
  double seconds = 1;              // of search for each property
  std::uint64_t seed = 1;
};

struct SelfTest {
  long planted = 0, falsely_proved = 0;  // verdicts that a planted violation contradicts
  long sound = 0, sound_proved = 0;      // shaders with proofs of all four properties
  long samples_float = 0, samples_double = 0;
  long outside = 0;                      // values outside their enclosure
  long undefined_inside = 0;             // undefined values in boxes with a finite enclosure
  std::vector<std::string> faults = {};  // the first of each kind, with the shader's text
  bool good() const { return falsely_proved == 0 && outside == 0 && undefined_inside == 0; }
};

// Proves `finite` and `non_negative` in both precisions for random shaders. Encloses random boxes of the
// shaders and evaluates the interpreter in them, at random parameters, directions and common turns of both
// directions. The result depends on the seed only. Throws InputError if a shader does not compile, which
// would be a fault of the self-test.
SelfTest self_test(const SelfTestOptions& options, const io::Progress& progress = {});

}  // namespace brdf::prove
