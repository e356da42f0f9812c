#include "study/changes.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "study/folder.h"

namespace brdf::study {
namespace {

using io::Json;

constexpr double kSame = 1e-9;  // relative: rounding of another machine or library

std::string label_of(const Json& estimate) {
  const std::string name = estimate.at("name"), channel = estimate.at("channel");
  return channel.empty() ? name : name + " (" + channel + ")";
}

const Json* same_parameter(const Json& estimates, const Json& wanted) {
  const auto found = std::ranges::find_if(estimates, [&](const Json& e) {
    return e.at("name") == wanted.at("name") && e.at("channel") == wanted.at("channel");
  });
  return found == estimates.end() ? nullptr : &*found;
}

bool is_same(double a, double b) {
  return std::abs(a - b) <= kSame * std::max(std::abs(a), std::abs(b));
}

// Returns whether the value is outside the older interval. Without an interval, every change counts.
bool is_outside(const Json& older, double value) {
  if (!older.at("low").is_number() || !older.at("high").is_number()) return true;
  return value < older.at("low").get<double>() || value > older.at("high").get<double>();
}

}  // namespace

std::vector<Change> changes_between(const Json& older, const Json& newer) {
  if (older.at("form") != newer.at("form")) return {{"form", older.at("form"), newer.at("form"), true}};
  std::vector<Change> changes;
  for (const Json& now : newer.at("estimates")) {
    const Json* const then = same_parameter(older.at("estimates"), now);
    if (!then) {
      changes.push_back({label_of(now), "not identifiable", io::short_number(now.at("value")), true});
      continue;
    }
    const double before = then->at("value"), after = now.at("value");
    if (is_same(before, after)) continue;
    changes.push_back(
        {label_of(now), io::short_number(before), io::short_number(after), is_outside(*then, after)});
  }
  for (const Json& then : older.at("estimates"))
    if (!same_parameter(newer.at("estimates"), then))
      changes.push_back({label_of(then), io::short_number(then.at("value")), "not identifiable", true});
  return changes;
}

Earlier::Earlier(const std::filesystem::path& against, const std::filesystem::path& folder) {
  const std::filesystem::path file = (against.empty() ? folder : against) / kResults;
  std::string why;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    why = "it holds no study.json";
  } else {
    try {
      const Json json = io::read_json(file);
      for (const Json& row : json.at("results"))
        // A row without estimates has a fault, or was written by an older version.
        if (row.contains("form") && row.contains("estimates")) rows_.emplace(row.at("name"), row);
      if (rows_.empty()) why = "no sample in it can be compared";
    } catch (const InputError&) {
      why = "its study.json cannot be read";
    } catch (const Json::exception&) {
      why = "its study.json was not written by brdf study";
    }
  }
  if (!against.empty() && !why.empty())
    throw InputError("--against " + against.string() + ": " + why +
                     "; give a folder that brdf study has written");
}

std::vector<Change> Earlier::changes_to(const Json& row) const {
  return changes_between(rows_.at(row.at("name")), row);
}

Json to_json(const std::vector<Change>& changes) {
  Json list = Json::array();
  for (const Change& c : changes)
    list.push_back(
        {{"what", c.what}, {"before", c.before}, {"after", c.after}, {"beyond_interval", c.is_beyond}});
  return list;
}

}  // namespace brdf::study
