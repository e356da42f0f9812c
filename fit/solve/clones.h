// Marks a function to be compiled once per instruction set, the right one chosen at load time.
#pragma once

// clang has no clones of flattened functions: correct there,
// and slow. The address sanitizer cannot resolve them.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define BRDF_FIT_CLONES [[gnu::target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"), gnu::flatten]]
#else
#define BRDF_FIT_CLONES
#endif
