// Strict reading and exact writing of JSON.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "brdf/names.h"
#include "io/files/content.h"
#include "io/files/provenance.h"

namespace brdf::io {

// Keeps the order of keys, so that files are written back in the order in which they were read.
using Json = nlohmann::ordered_json;

// Parses strictly. Throws InputError, which names the file and the place, on syntax errors, duplicate keys,
// numbers out of range, a NUL byte, nesting deeper than kDeepestJson and texts larger than `largest` bytes.
Json read_json(const std::filesystem::path& path);
Json read_json(const Content& content, std::size_t largest = kLargestJson);
Json parse_json(const std::string& text, const std::string& file, std::size_t largest = kLargestJson);

// Writes JSON: to_text() indents by two spaces and puts arrays of numbers on one line, to_line() writes a
// single line. Numbers read back exactly. Invalid UTF-8, for example in a file's name, is replaced instead
// of refused: one wrong letter is better than a lost result.
std::string to_text(const Json& json);
std::string to_line(const Json& json);

// Converts a provenance record to the keys "brdf_version", "command" and "seed".
Json to_json(const Provenance& made);

// Converts a number; JSON cannot represent infinite or undefined numbers, they become null.
Json finite_or_null(double x);

// A value in a JSON document with its path, for messages ("FILE: $.weights.kd: ...") and strict reading.
// The accessors throw InputError if the value does not have the required type or range.
class JsonPlace {
 public:
  JsonPlace(const Json& value, std::string file, std::string path = "$")
      : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

  const Json& value() const { return *value_; }
  const std::string& file() const { return file_; }
  const std::string& path() const { return path_; }

  // Throws InputError "FILE: PATH: VALUE RULE".
  [[noreturn]] void fail(const std::string& rule) const;
  // Throws InputError unless the value is an object that has only these keys.
  void allow_keys(std::initializer_list<std::string_view> keys) const;
  bool has(std::string_view key) const { return value_->contains(key); }
  JsonPlace at(std::string_view key) const;  // throws if the key is missing
  JsonPlace at(std::size_t index) const;
  std::size_t size() const;  // of an array; throws for anything else
  double number() const;     // finite
  double number(double min, double max) const;
  double whole(double min, double max) const;  // without a fractional part
  std::string text() const;
  // Returns the enumerator with this name; the message has the known names.
  template <class Enum>
  Enum named() const {
    const std::optional<Enum> found = find_named<Enum>(text());
    if (!found) fail("must be one of " + known_names<Enum>());
    return *found;
  }

 private:
  const Json* value_;
  std::string file_, path_;
};

}  // namespace brdf::io
