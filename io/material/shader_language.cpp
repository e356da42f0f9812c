#include "io/material/shader_language.h"

#include <algorithm>

#include "io/files/identifier.h"

namespace brdf::io {

std::vector<std::string> argument_names(std::span<const ParameterInfo> shape,
                                        std::span<const ParameterInfo> weights) {
  std::vector<std::string> names;
  for (const auto table : {shape, weights})
    for (const ParameterInfo& p : table) {
      const std::string plain = identifier(std::string(p.name), NameIn::argument);
      std::string name = plain;
      for (int copy = 2; std::ranges::find(names, name) != names.end(); ++copy)
        name = plain + "_" + std::to_string(copy);
      names.push_back(name);
    }
  return names;
}

}  // namespace brdf::io
