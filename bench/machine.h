// Facts about the machine that a benchmark prints.
#pragma once

#include <cstdio>
#include <fstream>
#include <string>
#include <thread>

namespace brdf::bench {

// Returns one line: processor, cores, widest vectors that the batches use, compiler, load.
inline std::string machine() {
  std::string cpu = "unknown processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) {
      cpu = line.substr(line.find(": ") + 2);
      break;
    }
#if defined(__x86_64__)
  const char* vectors = __builtin_cpu_supports("avx512vl") ? "AVX-512"
                        : __builtin_cpu_supports("avx2")   ? "AVX2"
                                                           : "SSE2";
#else
  const char* vectors = "baseline vectors";
#endif
  double load = 0;
  std::ifstream("/proc/loadavg") >> load;
  return cpu + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores, " + vectors +
         ", compiler " + __VERSION__ + ", load " + std::to_string(load).substr(0, 4);
}

// Prints a goal of the project with the value that this run measured.
inline void print_goal(const std::string& what, double measured, bool at_least, double wanted) {
  const bool met = at_least ? measured >= wanted : measured <= wanted;
  std::printf("  %-64s %7.2f  (goal %s %.2f)%s\n", what.c_str(), measured, at_least ? ">=" : "<=", wanted,
              met ? "" : "  MISSED");
}

}  // namespace brdf::bench
