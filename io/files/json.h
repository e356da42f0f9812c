#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "io/files/content.h"
#include "io/files/provenance.h"

namespace brdf::io {

using Json = nlohmann::ordered_json;  // keeps the order of keys: files read as they were written

// Parses strictly: syntax errors, keys given twice, numbers out of range and what is nested too deeply are
// refused with the file and the place. Throws InputError.
Json read_json(const std::filesystem::path& path);
Json read_json(const Content& content);
Json parse_json(const std::string& text, const std::string& file);

// Indented by two, arrays of numbers on one line. Numbers read back exactly. Text that is not UTF-8 (a file's
// name) has its bytes replaced: that costs a letter, not the work.
std::string to_text(const Json& json);
std::string to_line(const Json& json);

Json to_json(const Provenance& made);

// A place in a JSON document, for messages and strict reading: "FILE: $.weights.kd: ...".
class JsonPlace {
 public:
  JsonPlace(const Json& value, std::string file, std::string path = "$")
      : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

  const Json& value() const { return *value_; }
  const std::string& file() const { return file_; }
  const std::string& path() const { return path_; }

  // Throws InputError "FILE: PATH: VALUE RULE".
  [[noreturn]] void fail(const std::string& rule) const;
  // The value must be an object that has only these keys.
  void allow_keys(std::initializer_list<std::string_view> keys) const;
  bool has(std::string_view key) const { return value_->contains(key); }
  JsonPlace at(std::string_view key) const;  // refuses where the key is missing
  JsonPlace at(std::size_t index) const;
  std::size_t size() const;  // of an array; refuses anything else
  double number() const;     // finite
  double number(double min, double max) const;
  double whole(double min, double max) const;  // a number without a fraction
  std::string text() const;

 private:
  const Json* value_;
  std::string file_, path_;
};

}  // namespace brdf::io
