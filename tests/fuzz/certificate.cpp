// Certificates: sealed anew, so that what is inside is looked at.
#include "prove/check/certificate.h"
#include "io/json.h"
#include "tests/fuzz/fuzz.h"

namespace brdf::fuzz {
namespace {

const Registered certificates("certificate", [](std::string_view input) {
  const io::Json given = io::parse_json(std::string(input), "certificate");
  const bool has_results = given.is_object() && given.contains("results");
  const std::string text = has_results ? prove::sealed(given["results"]) : std::string(input);
  const prove::Checked first = prove::check({"certificate", text});
  require(first.results >= long(first.faults.size()), "a result has one fault at most");
  const io::Json read = io::parse_json(text, "certificate");
  const prove::Checked again = prove::check({"certificate", prove::sealed(read["results"])});
  require(again.results == first.results && again.leaves == first.leaves && again.faults == first.faults,
          "what is written again is judged as it was");
  if (first.results == 0 || !first.faults.empty()) return;
  for (const io::Json& row : read["results"])
    require(
        row.value("property", "") == "reciprocity" || row["low"].get<double>() <= row["high"].get<double>(),
        "bounds that hold are in order");
});

}  // namespace
}  // namespace brdf::fuzz
