// Few of many.
#pragma once

#include <utility>
#include <vector>

namespace brdf::io {

// At most `most` of a list, evenly from its first to its last.
template <class T>
std::vector<T> evenly(std::vector<T> all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<T> out;
  for (std::size_t k = 0; k < most; ++k)
    out.push_back(std::move(all[most == 1 ? 0 : k * (all.size() - 1) / (most - 1)]));
  return out;
}

}  // namespace brdf::io
