// Certificates. Each input is sealed anew, so that the fuzzer reaches the checks behind the seal.
#include "prove/check/certificate.h"
#include "io/files/json.h"
#include "tests/fuzz/fuzz.h"

namespace brdf::fuzz {
namespace {

const Registered certificates("certificate", [](std::string_view input) {
  const io::Json given = io::parse_json(std::string(input), "certificate");
  const bool has_results = given.is_object() && given.contains("results");
  const auto anew = [](const io::Json& of) {
    return prove::sealed(of["results"], of.contains("materials") ? of["materials"] : io::Json::array());
  };
  const std::string text = has_results ? anew(given) : std::string(input);
  const prove::Checked first = prove::check({"certificate", text});
  require(first.results.size() >= first.faults.size(), "a result has one fault at most");
  const io::Json read = io::parse_json(text, "certificate");
  const prove::Checked again = prove::check({"certificate", anew(read)});
  require(again.results.size() == first.results.size() && again.leaves == first.leaves &&
              again.faults == first.faults,
          "what is written again is judged as it was");
  if (first.results.empty() || !first.faults.empty()) return;
  for (const io::Json& row : read["results"])
    if (row.contains("cover"))
      require(row["low"].get<double>() <= row["high"].get<double>(), "bounds that hold are in order");
  for (const prove::CheckedResult& r : first.results)
    require(r.verdict != prove::Verdict::no_method && !r.statement.empty(), "what holds shows something");
});

}  // namespace
}  // namespace brdf::fuzz
