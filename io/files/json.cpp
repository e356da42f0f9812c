#include "io/files/json.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// Builds a document from the parser's events. Refuses documents that the library would accept silently, and
// keeps the current path for messages. The library's own parser with a callback takes time that grows with
// the square of the number of objects in an array.
class Builder {
 public:
  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(Json::number_integer_t value) { return add(value); }
  bool number_unsigned(Json::number_unsigned_t value) { return add(value); }
  bool number_float(Json::number_float_t value, const std::string&) { return add(value); }
  bool string(std::string& value) {
    count_part();
    return add(std::move(value));
  }
  bool binary(Json::binary_t&) { return false; }  // only formats other than text have it
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  // nlohmann::json keeps the last of two equal keys; a strict reader must refuse them.
  bool key(std::string& name) {
    Level& level = open_.back();
    level.key.clear();
    if (level.keys.size() == kMostKeys)
      throw InputError("has more than " + std::to_string(kMostKeys) + " keys");
    if (!level.keys.insert(name).second)
      throw InputError("key \"" + printable(name, 60) + "\" is given twice");
    level.key = std::move(name);
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const Json::exception& error) {
    constexpr int kOutOfRange = 406;
    // "[json.exception.out_of_range.406] number overflow parsing '1e400'"
    // "[json.exception.parse_error.101] parse error at line 1, column 3: ...": the file's name replaces the
    // bracket.
    std::string message = error.what();
    if (error.id == kOutOfRange)
      throw InputError(
          printable(message.substr(std::min(message.find('\''), message.size())), kLongestMessage) +
          " exceeds the range of numbers");
    if (const std::size_t stop = message.find("] "); stop != message.npos) message.erase(0, stop + 2);
    std::ranges::replace(message, '\n', ' ');
    throw SyntaxError{printable(message, kLongestMessage)};
  }

  // "$.weights.kd[2]"
  std::string place() const {
    std::string path = "$";
    for (const Level& level : open_)
      path += level.value->is_array() ? "[" + std::to_string(level.value->size() - level.is_last_open) + "]"
              : level.key.empty()     ? ""
                                      : "." + level.key;
    return printable(path, 60);
  }
  Json result() { return std::move(root_); }

  // The message has a place of its own.
  struct SyntaxError {
    std::string message;
  };

 private:
  static constexpr std::size_t kLongestMessage = 300;
  static constexpr std::size_t kMostKeys = 100'000;
  // Each of these takes memory of its own: about 100 bytes.
  static constexpr std::size_t kMostParts = 8'000'000;

  struct Level {
    Json* value;
    bool is_last_open = false;  // the last member of an array is not complete
    std::string key = {};       // the last key
    std::unordered_set<std::string> keys = {};
  };

  void count_part() {
    if (++parts_ > kMostParts)
      throw InputError("has more than " + std::to_string(kMostParts) + " texts, arrays and objects");
  }

  // Adds a value to the innermost array or object.
  Json& put(Json value) {
    if (open_.empty()) return root_ = std::move(value);
    Json& parent = *open_.back().value;
    if (parent.is_array()) {
      auto& members = parent.get_ref<Json::array_t&>();
      return members.emplace_back(std::move(value));
    }
    // The keys are known to differ, so that the search of emplace() is not needed.
    Json::object_t::Container& members = parent.get_ref<Json::object_t&>();
    return members.emplace_back(open_.back().key, std::move(value)).second;
  }
  bool add(Json value) {
    put(std::move(value));
    return true;
  }
  bool open(Json value) {
    if (open_.size() == kDeepestJson)
      throw InputError("is nested more than " + std::to_string(kDeepestJson) + " levels deep");
    count_part();
    Json& added = put(std::move(value));
    if (!open_.empty()) open_.back().is_last_open = true;
    open_.push_back({&added});
    return true;
  }
  bool close() {
    open_.pop_back();
    if (!open_.empty()) open_.back().is_last_open = false;
    return true;
  }

  Json root_;
  std::vector<Level> open_;
  std::size_t parts_ = 0;
};

// Keys that need no escape, which are nearly all, are not made into documents of their own.
std::string quoted_key(const std::string& key) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return std::ranges::all_of(key, is_plain) ? '"' + key + '"' : to_line(Json(key));
}

void write(const Json& json, const std::string& indent, std::string& out) {
  const bool is_flat =
      json.is_array() && std::ranges::none_of(json, [](const Json& item) { return item.is_structured(); });
  if (!json.is_structured() || json.empty() || is_flat) {
    std::string text = to_line(json);
    if (is_flat && std::ranges::all_of(json, [](const Json& item) { return item.is_number(); }))
      for (std::size_t k = 0; (k = text.find(',', k)) != text.npos; k += 2) text.insert(k + 1, " ");
    out += text;
    return;
  }
  const std::string inner = indent + "  ";
  out += json.is_array() ? "[" : "{";
  bool first = true;
  for (const auto& [key, value] : json.items()) {
    out += first ? "\n" : ",\n";
    first = false;
    out += inner;
    if (json.is_object()) out += quoted_key(key) + ": ";
    write(value, inner, out);
  }
  out += "\n" + indent + (json.is_array() ? "]" : "}");
}

}  // namespace

Json parse_json(const std::string& text, const std::string& file, std::size_t largest) {
  if (text.size() > largest)
    throw InputError(file + ": is larger than " + std::to_string(largest >> 20) + " MiB");
  if (const std::size_t nul = text.find('\0'); nul != text.npos)  // the parser would stop there
    throw InputError(file + ", line " + std::to_string(line_of(text, nul)) + ": contains a NUL byte");
  Builder builder;
  try {
    Json::sax_parse(text, &builder);
  } catch (const Builder::SyntaxError& error) {
    throw InputError(file + ": " + error.message);
  } catch (const InputError& error) {
    throw InputError(file + ": " + builder.place() + ": " + error.what());
  }
  return builder.result();
}

Json read_json(const Content& content, std::size_t largest) {
  return parse_json(content.bytes, content.name, largest);
}

Json read_json(const std::filesystem::path& path) {
  return read_json(read_content(path, kLargestJson));
}

std::string to_line(const Json& json) {
  return with_escaped_marks(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string to_text(const Json& json) {
  std::string out;
  write(json, "", out);
  return out + '\n';
}

Json to_json(const Provenance& made) {
  Json json;
  json["brdf_version"] = made.version;
  if (!made.command.empty()) json["command"] = made.command;
  if (made.seed) json["seed"] = *made.seed;
  return json;
}

void JsonPlace::fail(const std::string& rule) const {
  throw InputError(file_ + ": " + path_ + ": " + printable(to_line(*value_), 60) + " " + rule);
}

void JsonPlace::allow_keys(std::initializer_list<std::string_view> keys) const {
  if (!value_->is_object()) fail("must be an object");
  for (const auto& [key, value] : value_->items()) {
    if (std::ranges::find(keys, key) != keys.end()) continue;
    std::string known;
    for (const std::string_view name : keys) (known += known.empty() ? "" : ", ") += name;
    throw InputError(file_ + ": " + path_ + ": unknown key \"" + printable(key, 60) + "\" (known: " + known +
                     ")");
  }
}

JsonPlace JsonPlace::at(std::string_view key) const {
  if (!value_->is_object()) fail("must be an object");
  const auto found = value_->find(key);
  if (found == value_->end())
    throw InputError(file_ + ": " + path_ + ": key \"" + std::string(key) + "\" is missing");
  return {*found, file_, path_ + "." + std::string(key)};
}

JsonPlace JsonPlace::at(std::size_t index) const {
  if (index >= size()) fail("must have more than " + std::to_string(index) + " members");
  return {value_->at(index), file_, path_ + "[" + std::to_string(index) + "]"};
}

Json finite_or_null(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

std::size_t JsonPlace::size() const {
  if (!value_->is_array()) fail("must be an array");
  return value_->size();
}

double JsonPlace::number() const {
  if (!value_->is_number()) fail("must be a number");
  const double number = value_->get<double>();
  if (!std::isfinite(number)) fail("must be finite");
  return number;
}

double JsonPlace::number(double min, double max) const {
  const double x = number();
  if (!(x >= min && x <= max)) fail("must be between " + to_text(min) + " and " + to_text(max));
  return x;
}

double JsonPlace::whole(double min, double max) const {
  const double x = number(min, max);
  if (x != std::floor(x)) fail("must be a whole number");
  return x;
}

std::string JsonPlace::text() const {
  if (!value_->is_string()) fail("must be a string");
  return value_->get<std::string>();
}

}  // namespace brdf::io
