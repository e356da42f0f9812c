#include "io/json.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "io/error.h"
#include "io/text.h"

namespace brdf::io {
namespace {

// nlohmann::json keeps the last of two equal keys without a word; a strict reader must not.
class DuplicateKeys {
 public:
  bool operator()(int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start)
      open_.emplace_back();
    else if (event == Json::parse_event_t::object_end)
      open_.pop_back();
    else if (event == Json::parse_event_t::key && !open_.back().insert(parsed.get<std::string>()).second)
      throw InputError("key \"" + parsed.get<std::string>() + "\" is given twice");
    return true;
  }

 private:
  std::vector<std::set<std::string>> open_;
};

void write(const Json& json, const std::string& indent, std::string& out) {
  const bool is_flat = json.is_array() && std::none_of(json.begin(), json.end(),
                                                       [](const Json& item) { return item.is_structured(); });
  if (!json.is_structured() || json.empty() || is_flat) {
    std::string text = json.dump();
    if (is_flat && std::all_of(json.begin(), json.end(), [](const Json& item) { return item.is_number(); })) {
      for (std::size_t k = 0; (k = text.find(',', k)) != text.npos; k += 2) text.insert(k + 1, " ");
    }
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
    if (json.is_object()) out += Json(key).dump() + ": ";
    write(value, inner, out);
  }
  out += "\n" + indent + (json.is_array() ? "]" : "}");
}

}  // namespace

Json parse_json(const std::string& text, const std::string& file) {
  try {
    return Json::parse(text, DuplicateKeys());
  } catch (const InputError& error) {
    throw InputError(file + ": " + error.what());
  } catch (const Json::parse_error& error) {
    // "[json.exception.parse_error.101] parse error at line
    // 1, column 3: ...": the file takes the bracket's place
    std::string message = error.what();
    if (const std::size_t stop = message.find("] "); stop != message.npos) message.erase(0, stop + 2);
    std::replace(message.begin(), message.end(), '\n', ' ');
    throw InputError(file + ": " + message);
  }
}

Json read_json(const std::filesystem::path& path) {
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path, error)) throw InputError(path.string() + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return parse_json(text, path.string());
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
  std::string shown = value_->dump();
  constexpr std::size_t kLongest = 60;
  if (shown.size() > kLongest) shown = shown.substr(0, kLongest) + "...";
  throw InputError(file_ + ": " + path_ + ": " + shown + " " + rule);
}

void JsonPlace::allow_keys(std::initializer_list<std::string_view> keys) const {
  if (!value_->is_object()) fail("must be an object");
  for (const auto& [key, value] : value_->items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    std::string known;
    for (const std::string_view name : keys) (known += known.empty() ? "" : ", ") += name;
    throw InputError(file_ + ": " + path_ + ": unknown key \"" + key + "\" (known: " + known + ")");
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
  return {value_->at(index), file_, path_ + "[" + std::to_string(index) + "]"};
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

std::string JsonPlace::text() const {
  if (!value_->is_string()) fail("must be a string");
  return value_->get<std::string>();
}

}  // namespace brdf::io
