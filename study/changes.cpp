#include "study/changes.h"

#include <algorithm>
#include <cmath>

#include "io/files/content.h"
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

// A row without estimates has a fault, or was written by an older version.
bool can_be_compared(const Json& row) {
  return row.contains("form") && row.contains("estimates");
}

// Bytes: a sample takes about 4,000.
constexpr std::size_t kLargestOverview = std::size_t{1} << 28;

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

std::vector<Change> changes_from(const Json& results, const Json& row) {
  try {
    for (const Json& older : results.at("results"))
      if (older.at("name") == row.at("name"))
        return can_be_compared(older) ? changes_between(older, row) : std::vector<Change>();
  } catch (const Json::exception&) {  // edited by hand
  }
  return {};
}

Earlier::Earlier(const std::filesystem::path& against) {
  if (against.empty()) return;
  const std::filesystem::path file = against / kResults;
  std::string why;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    why = "it holds no study.json";
  } else {
    try {
      Json json = io::read_json(io::read_result(file, kLargestOverview), kLargestOverview);
      for (Json& row : json.at("results"))
        if (can_be_compared(row)) rows_.emplace(row.at("name"), std::move(row));
      if (rows_.empty()) why = "no sample in it can be compared";
    } catch (const InputError&) {
      why = "its study.json cannot be read";
    } catch (const Json::exception&) {
      why = "its study.json was not written by brdf study";
    }
  }
  if (!why.empty())
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
