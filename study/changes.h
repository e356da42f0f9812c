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

// Returns the differences of the row from the row of the same name in an older study.json. Empty if there is
// no such row, or if it has no values.
std::vector<Change> changes_from(const io::Json& results, const io::Json& row);

// The rows of an older study.
class Earlier {
 public:
  // Reads the rows of this folder; there are none if it is empty. Throws InputError if the folder holds no
  // study.
  explicit Earlier(const std::filesystem::path& against);

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
