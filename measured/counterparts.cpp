#include "measured/counterparts.h"

#include <algorithm>

#include "io/colour/channel_colours.h"

namespace brdf::measured {

std::vector<int> counterparts(const std::vector<std::string>& of_table,
                              const std::vector<std::string>& of_material) {
  std::vector<int> out(of_table.size(), -1);
  const auto table = io::channel_colours(of_table), material = io::channel_colours(of_material);
  for (std::size_t c = 0; c < of_table.size(); ++c) {
    const auto same = std::ranges::find(of_material, of_table[c]);
    if (same != of_material.end()) {
      out[c] = int(same - of_material.begin());
    } else if (of_material.size() == 1) {
      out[c] = 0;
    } else if (table && material) {
      for (std::size_t k = 0; k < 3; ++k)
        if (table->of[k] == c) out[c] = int(material->of[k]);
    }
  }
  return out;
}

}  // namespace brdf::measured
