// Loops compiled once per generation of the CPU, the right one chosen when the program is loaded.
#pragma once

#include <cstddef>

// The macros of the library: an attribute cannot be named otherwise. Without `flatten` what a loop calls
// would not be inlined into the clones, which costs a factor of 8. clang refuses the two together: correct
// there, and slow. Under the sanitizers plain code: instrumented clones take minutes to compile, and cannot
// be resolved before their runtime starts. BRDF_FEW_CLONES leaves out the last generation, a third of the
// compiler's work: on a machine that has no AVX-512, and in a file whose loops hardly anybody waits for.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#ifdef BRDF_FEW_CLONES
#define BRDF_CLONES [[gnu::target_clones("default", "arch=x86-64-v3"), gnu::flatten]]
#else
#define BRDF_CLONES [[gnu::target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"), gnu::flatten]]
// What a loop of the widest vectors is compiled as, beside one of narrower ones: for has_widest_vectors()
// only.
#define BRDF_WIDEST [[gnu::target("arch=x86-64-v4"), gnu::flatten]]
#endif
#elif defined(__clang__)
#define BRDF_CLONES [[gnu::flatten]]
#else
#define BRDF_CLONES
#endif

namespace brdf {

#ifdef BRDF_WIDEST
inline bool has_widest_vectors() {
  return __builtin_cpu_supports("x86-64-v4");
}
#endif

// body(i) for i in [0, count). No two calls may touch the same place.
template <class Body>
BRDF_CLONES void repeat(const Body body, const std::size_t count) {
#if defined(__clang__)
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
  for (std::size_t i = 0; i < count; ++i) body(i);
}

}  // namespace brdf
