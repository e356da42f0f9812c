// Differences between the results of two studies of the same samples.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/files/json.h"

namespace brdf::study {

// A difference between an older and a newer result.
struct Change {
  std::string what;  // "alpha", "ks (r)", "form"
  std::string before, after;
  // The newer value is outside the 95 % interval of the older value, or the newer fit has another form.
  bool is_beyond = false;
};

// Returns the differences of the newer row of study.json from the older row. Two forms cannot be compared
// parameter by parameter: the form is then the only change. Empty if nothing differs.
std::vector<Change> changes_between(const io::Json& older, const io::Json& newer);

// The rows of an older study.
class Earlier {
 public:
  // Reads the rows of `against`; if it is empty, the rows that are in `folder` now, if there are any. Throws
  // InputError if `against` is given and holds no study.
  Earlier(const std::filesystem::path& against, const std::filesystem::path& folder);

  // Returns whether a sample of this name was studied without a fault.
  bool has(const std::string& name) const { return rows_.contains(name); }
  // Returns the differences of a row from the older row of the same name. Precondition: has().
  std::vector<Change> changes_to(const io::Json& row) const;

 private:
  std::map<std::string, io::Json> rows_;
};

// Returns the changes as JSON.
io::Json to_json(const std::vector<Change>& changes);

}  // namespace brdf::study
