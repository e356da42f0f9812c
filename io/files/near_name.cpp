#include "io/files/near_name.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

constexpr std::size_t kMostFiles = 10000;  // most entries of a folder that are compared

std::string plain(std::string_view word) {
  std::string letters = lower_case(word);
  std::erase_if(letters, [](char c) { return c == '-' || c == '_' || c == ' '; });
  return letters;
}

// Returns the number of letters to change, add, leave out, or exchange with the next one (optimal string
// alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t(0));
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = above;
    std::swap(above, row);
  }
  return above.back();
}

}  // namespace

std::string near_name(std::string_view word, const std::vector<std::string>& known) {
  const std::string letters = plain(word);
  if (letters.empty()) return "";
  for (const std::string_view name : familiar_names(letters))
    if (std::ranges::find(known, name) != known.end()) return std::string(name);
  const std::string* nearest = nullptr;
  std::size_t least = std::max<std::size_t>(1, letters.size() / 3) + 1;
  for (const std::string& name : known) {
    const std::string other = plain(name);
    // A name that begins with the word ranks like a name with one typing error. If several do, the first is
    // the plainest.
    const bool begins = letters.size() > 2 && other.starts_with(letters);
    const std::size_t d =
        begins ? std::min<std::size_t>(distance(letters, other), 1) : distance(letters, other);
    if (d < least && (begins || d < letters.size())) {
      least = d;
      nearest = &name;
    }
  }
  return nearest ? *nearest : "";
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string name = near_name(word, known);
  return name.empty() ? "" : "did you mean " + name + "? ";
}

std::string known_names_text(std::string_view word, const std::vector<std::string>& known) {
  return did_you_mean(word, known) + "known: " + joined(known);
}

std::string did_you_mean_file(std::string_view path) {
  namespace fs = std::filesystem;
  const fs::path file(path);
  std::error_code error;
  std::vector<std::string> beside;
  for (fs::directory_iterator entry(file.has_parent_path() ? file.parent_path() : ".", error), end;
       !error && entry != end && beside.size() < kMostFiles; entry.increment(error))
    if (entry->path().filename() != file.filename()) beside.push_back(entry->path().filename().string());
  // The same name then wins in whatever order the folder lists its entries.
  std::ranges::sort(beside);
  const std::string name = file.stem().string().size() < 3 ? "" : near_name(file.filename().string(), beside);
  return name.empty() ? "" : "; did you mean " + (file.parent_path() / name).string() + "?";
}

}  // namespace brdf::io
