#include "io/columns/layout_unsure.h"

#include <cmath>

#include "io/columns/layout.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// The words that may replace a null.
std::string words_for(std::string_view key) {
  if (key == "is") return "one of " + known_names<Meaning>();
  if (key == "quantity") return "a quantity: " + known_quantities();
  if (key == "unit") return "a unit: deg or rad for angles, nm, um, m, cm-1, GHz, THz or eV for wavelengths";
  if (key == "mirror_side") return "positive or negative";
  return "a value";
}

// Calls `found` with the path and the key of each null.
template <class Found>
void visit_nulls(const Json& value, const std::string& path, std::string_view key, const Found& found) {
  if (value.is_null()) found(path, key);
  if (value.is_object())
    for (const auto& [name, member] : value.items()) visit_nulls(member, path + "." + name, name, found);
  if (value.is_array())
    for (std::size_t k = 0; k < value.size(); ++k)
      visit_nulls(value[k], path + "[" + std::to_string(k) + "]", key, found);
}

}  // namespace

UnsurePlaces::UnsurePlaces(const JsonPlace& layout) : root_(layout) {
  if (!layout.has("unsure")) return;
  const JsonPlace list = layout.at("unsure");
  for (std::size_t k = 0; k < list.size(); ++k) {
    const JsonPlace entry = list.at(k);
    entry.allow_keys({"path", "reason"});
    const std::string path = entry.at("path").text();
    reasons_.emplace(path, entry.at("reason").text());
    if (!exists(path))
      entry.at("path").fail("must be the path of a place in this layout: correct or remove the entry");
  }
}

void UnsurePlaces::refuse_nulls() const {
  std::string first, key;
  std::size_t count = 0;
  visit_nulls(root_.value(), "$", "", [&](const std::string& path, std::string_view of) {
    if (count++ > 0) return;
    first = path;
    key = of;
  });
  if (count == 0) return;
  const auto known = reasons_.find(first);
  const std::string more = count > 1 ? " (" + plural(count - 1, "other place") + " of this layout " +
                                           (count > 2 ? "are" : "is") + " null, too)"
                                     : "";
  throw InputError(root_.file() + ": " + first + ": null must be replaced by " + words_for(key) + more +
                   (known == reasons_.end() ? "" : "; the place is unsure: " + known->second));
}

std::vector<std::string> UnsurePlaces::guesses() const {
  std::vector<std::string> all;
  for (const auto& [path, reason] : reasons_)
    if (path != "$") all.push_back("the layout's " + path + " is a proposal that may be wrong: " + reason);
  return all;
}

// Returns whether a path such as $.columns[2].unit leads to a value.
bool UnsurePlaces::exists(std::string_view path) const {
  if (!path.starts_with('$')) return false;
  const Json* at = &root_.value();
  for (path.remove_prefix(1); !path.empty();) {
    const char sign = path.front();
    path.remove_prefix(1);
    const std::string_view step = path.substr(0, path.find_first_of(sign == '[' ? "]" : ".["));
    path.remove_prefix(step.size());
    if (sign == '.') {
      const auto found = at->is_object() ? at->find(std::string(step)) : at->end();
      if (!at->is_object() || found == at->end()) return false;
      at = &*found;
    } else {
      double index;
      if (sign != '[' || path.empty() || !at->is_array() || !parse_number(step, index) || !(index >= 0) ||
          index != std::floor(index) || index >= double(at->size()))
        return false;
      path.remove_prefix(1);
      at = &(*at)[std::size_t(index)];
    }
  }
  return true;
}

}  // namespace brdf::io
