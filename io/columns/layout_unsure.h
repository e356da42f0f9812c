// The places of a layout that describe-table was unsure of.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/json.h"

namespace brdf::io {

class UnsurePlaces {
 public:
  // Reads the key `unsure`, if the layout has it: a list of objects with `path` and `reason`. The place must
  // outlive this object. Throws InputError for a path that leads to no place of the layout.
  explicit UnsurePlaces(const JsonPlace& layout);
  // Throws InputError for the first null of the layout, with the reason that `unsure` gives for it.
  void refuse_nulls() const;
  // Returns a sentence for each place that has a value.
  std::vector<std::string> guesses() const;

 private:
  bool exists(std::string_view path) const;

  const JsonPlace& root_;
  std::map<std::string, std::string> reasons_;  // by path
};

}  // namespace brdf::io
