#include "io/formats/json_metadata.h"

#include "io/files/error.h"
#include "io/files/fingerprint.h"
#include "io/files/limits.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
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

std::string identifier_of(const std::string& content) {
  const std::string hash = fingerprint({content}) + fingerprint({content, "second half"});
  std::string digits = std::string(hash.size() < 32 ? 32 - hash.size() : 0, '0') + hash;
  digits[12] = '8';
  digits[16] = 'a';
  return digits.substr(0, 8) + "-" + digits.substr(8, 4) + "-" + digits.substr(12, 4) + "-" +
         digits.substr(16, 4) + "-" + digits.substr(20, 12);
}

void write_json_table(const std::filesystem::path& path, const Json& json, const SampleTable& table) {
  const std::string text = to_text(json);
  if (text.size() > kLargestJson)
    throw InputError(table.name() + ": has too many values for a file of JSON, which is read up to " +
                     std::to_string(kLargestJson >> 20) + " MiB: write .csv");
  write_file_atomically(path, text);
}

}  // namespace brdf::io
