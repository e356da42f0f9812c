#include "io/formats/json_metadata.h"

#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

constexpr std::size_t kMostMembers = 200, kLongestMember = 2000;  // comments, and bytes of each

std::string comment_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return to_text(value.get<double>());
  if (!value.is_array()) return "";
  std::vector<std::string> words;
  for (const Json& item : value)
    if (item.is_string()) words.push_back(item.get<std::string>());
  return joined(words, "; ");
}

}  // namespace

void add_metadata(SampleTable& table, const Json& object) {
  if (!object.is_object()) return;
  std::size_t count = 0;
  for (const auto& [key, value] : object.items()) {
    const std::string text = comment_of(value);
    if (text.empty() || key.starts_with('$') || ++count > kMostMembers) continue;
    table.add_comment(printable(key, kLongestMember), printable(text, kLongestMember));
  }
}

}  // namespace brdf::io
