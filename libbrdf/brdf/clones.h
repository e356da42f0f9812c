// Loops that are compiled once per CPU generation. The right version is chosen when the program is loaded.
#pragma once

#include <cstddef>

// Attribute of a function that writes a text: only its size counts, in the page for browsers.
#ifdef __clang__
#define BRDF_SMALL [[clang::minsize]]
#else
#define BRDF_SMALL
#endif

// The library needs macros here because an attribute cannot be named in any other way. `flatten` inlines the
// functions that a loop calls into the clones; without it the loops are 8 times slower. clang rejects
// target_clones combined with flatten; the code is correct there, but slow. Under the sanitizers the macro
// produces plain code, because instrumented clones take minutes to compile and cannot be resolved before the
// sanitizer's runtime starts. BRDF_FEW_CLONES omits the newest generation, which is a third of the compiler's
// work. Use it on machines without AVX-512 and in files with loops that are not critical for performance.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#ifdef BRDF_FEW_CLONES
#define BRDF_CLONES [[gnu::target_clones("default", "arch=x86-64-v3"), gnu::flatten]]
#else
#define BRDF_CLONES [[gnu::target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"), gnu::flatten]]
// Attribute of a loop compiled for the widest vectors, next to a version for narrower ones. Use only
// together with has_widest_vectors().
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

// Calls body(i) for i in [0, count). No two calls may access the same memory location.
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
