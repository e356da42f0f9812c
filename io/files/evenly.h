// Selects a few elements of a long list.
#pragma once

#include <utility>
#include <vector>

namespace brdf::io {

// Returns at most `most` elements of a list, evenly spaced by index from the first to the last. If `most`
// is 1, the first element is returned.
template <class T>
std::vector<T> evenly(std::vector<T> all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<T> out;
  for (std::size_t k = 0; k < most; ++k)
    out.push_back(std::move(all[most == 1 ? 0 : k * (all.size() - 1) / (most - 1)]));
  return out;
}

}  // namespace brdf::io
