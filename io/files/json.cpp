#include "io/files/json.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// Receives the parser's events, refuses documents that the parser would accept silently, and keeps the
// current path for messages.
class Follower {
 public:
  bool operator()(int, Json::parse_event_t event, Json& parsed) {
    using Event = Json::parse_event_t;
    if (event == Event::object_end || event == Event::array_end) open_.pop_back();
    if (event == Event::key) enter(parsed.get<std::string>());
    if (event == Event::object_start || event == Event::array_start) {
      if (open_.size() == kDeepestJson)
        throw InputError("is nested more than " + std::to_string(kDeepestJson) + " levels deep");
      open_.push_back({event == Event::array_start});
    } else if (event != Event::key && !open_.empty()) {
      ++open_.back().index;
    }
    return true;
  }
  // "$.weights.kd[2]"
  std::string place() const {
    std::string path = "$";
    for (const Level& level : open_)
      path += level.is_array      ? "[" + std::to_string(level.index) + "]"
              : level.key.empty() ? ""
                                  : "." + level.key;
    return printable(path, 60);
  }

 private:
  struct Level {
    bool is_array;
    std::size_t index = 0;
    std::string key = {};  // the last key
    std::set<std::string> keys = {};
  };
  // nlohmann::json keeps the last of two equal keys; a strict reader must refuse them.
  void enter(std::string key) {
    open_.back().key.clear();
    if (!open_.back().keys.insert(key).second)
      throw InputError("key \"" + printable(key, 60) + "\" is given twice");
    open_.back().key = std::move(key);
  }
  std::vector<Level> open_;
};

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
    if (json.is_object()) out += to_line(Json(key)) + ": ";
    write(value, inner, out);
  }
  out += "\n" + indent + (json.is_array() ? "]" : "}");
}

}  // namespace

Json parse_json(const std::string& text, const std::string& file) {
  if (text.size() > kLargestJson)
    throw InputError(file + ": is larger than " + std::to_string(kLargestJson >> 20) + " MiB");
  if (const std::size_t nul = text.find('\0'); nul != text.npos)  // the parser would stop there
    throw InputError(file + ", line " + std::to_string(line_of(text, nul)) + ": contains a NUL byte");
  constexpr std::size_t kLongest = 300;
  Follower follower;
  try {
    return Json::parse(text, std::ref(follower));
  } catch (const InputError& error) {
    throw InputError(file + ": " + follower.place() + ": " + error.what());
  } catch (const Json::out_of_range& error) {
    // "[json.exception.out_of_range.406] number overflow parsing '1e400'"
    const std::string message = error.what();
    throw InputError(file + ": " + follower.place() + ": " +
                     printable(message.substr(std::min(message.find('\''), message.size())), kLongest) +
                     " exceeds the range of numbers");
  } catch (const Json::parse_error& error) {
    // "[json.exception.parse_error.101] parse error at line 1, column 3: ...": the file's name replaces the
    // bracket.
    std::string message = error.what();
    if (const std::size_t stop = message.find("] "); stop != message.npos) message.erase(0, stop + 2);
    std::ranges::replace(message, '\n', ' ');
    throw InputError(file + ": " + printable(message, kLongest));
  }
}

Json read_json(const Content& content) {
  return parse_json(content.bytes, content.name);
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
