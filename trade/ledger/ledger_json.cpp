#include <algorithm>

#include "io/files/output.h"
#include "io/files/text.h"
#include "trade/ledger/ledger.h"

namespace brdf::trade {
namespace {

using io::Json;
using io::JsonPlace;

int count(const JsonPlace& place) {
  return int(place.whole(0, 1e6));
}

Json row_json(const LedgerRow& row) {
  Json extremes = Json::array();
  for (const Extreme& e : row.extremes) extremes.push_back({{"domain", e.domain}, {"max", e.max}});
  return {{"question", row.question},
          {"choice", row.choice},
          {"exact", row.exact},
          {"unit", name_of(row.unit)},
          {"cost_ratio", row.cost_ratio},
          {"cost_ratio_spread", row.cost.ratio_spread},
          {"cost_ns", row.cost.seconds * 1e9},
          {"cost_spread", row.cost.spread},
          {"rounds", row.cost.rounds},
          {"error",
           {{"max", row.error.max},
            {"mean", row.error.mean},
            {"p99", row.error.p99},
            {"measure", name_of(row.error.measure)},
            {"of", row.quantity},
            {"where", row.error.where}}},
          {"image_error", row.image_error ? Json(*row.image_error) : Json(nullptr)},
          {"domain", row.domain},
          {"extremes", extremes},
          {"dominated_by", row.dominated_by.empty() ? Json(nullptr) : Json(row.dominated_by)},
          {"note", row.note}};
}

LedgerRow row_from(const JsonPlace& place) {
  LedgerRow row;
  row.question = place.at("question").text();
  row.choice = place.at("choice").text();
  row.exact = place.at("exact").text();
  row.unit = place.at("unit").named<Unit>();
  row.cost_ratio = place.at("cost_ratio").number();
  row.cost = {place.at("cost_ns").number() / 1e9, place.at("cost_spread").number(), count(place.at("rounds")),
              place.at("cost_ratio_spread").number()};
  const JsonPlace error = place.at("error");
  row.error = {error.at("max").number(), error.at("mean").number(), error.at("p99").number(),
               error.at("measure").named<Measure>(), error.at("where").text()};
  row.quantity = error.at("of").text();
  if (!place.at("image_error").value().is_null()) row.image_error = place.at("image_error").number();
  row.domain = place.at("domain").text();
  const JsonPlace extremes = place.at("extremes");
  for (std::size_t k = 0; k < extremes.size(); ++k)
    row.extremes.push_back({extremes.at(k).at("domain").text(), extremes.at(k).at("max").number()});
  if (!place.at("dominated_by").value().is_null()) row.dominated_by = place.at("dominated_by").text();
  row.note = place.at("note").text();
  return row;
}

Json claim_json(const Claim& c) {
  return {{"source", c.source},   {"claim", c.claim},       {"standing", name_of(c.standing)},
          {"verdict", c.verdict}, {"evidence", c.evidence}, {"question", c.question},
          {"choice", c.choice}};
}

// Returns the rows on the front of each question, cheapest first.
Json fronts_json(const Ledger& ledger) {
  Json fronts = Json::array();
  std::vector<std::string> questions;
  for (const LedgerRow& row : ledger.rows)
    if (std::ranges::find(questions, row.question) == questions.end()) questions.push_back(row.question);
  for (const std::string& question : questions) {
    std::vector<const LedgerRow*> front;
    for (const LedgerRow& row : ledger.rows)
      if (row.question == question && row.dominated_by.empty()) front.push_back(&row);
    std::ranges::sort(front, [](const auto* a, const auto* b) { return a->cost.seconds < b->cost.seconds; });
    Json choices = Json::array();
    for (const LedgerRow* row : front) choices.push_back(row->choice);
    if (!front.empty())
      fronts.push_back(
          {{"unit", name_of(front[0]->unit)}, {"question", question}, {"choices", std::move(choices)}});
  }
  return fronts;
}

bool is_current(const JsonPlace& place) {
  if (!place.value().is_object() || !place.has("format") || place.at("format").text() != "brdf-ledger")
    place.fail("is not a ledger of `brdf trade` (\"format\": \"brdf-ledger\")");
  return place.at("version").number() == 1;
}

}  // namespace

Json to_json(const Ledger& ledger) {
  Json rows = Json::array(), claims = Json::array();
  for (const LedgerRow& row : ledger.rows) rows.push_back(row_json(row));
  for (const Claim& claim : ledger.claims) claims.push_back(claim_json(claim));
  return {{"format", "brdf-ledger"},
          {"version", 1},
          {"made", io::to_json(io::provenance(0))},
          {"quick", ledger.quick},
          {"machine",
           {{"processor", ledger.machine.processor},
            {"threads", ledger.machine.threads},
            {"compiler", ledger.machine.compiler},
            {"flags", ledger.machine.flags}}},
          {"left_out", ledger.left_out},
          {"rows", std::move(rows)},
          {"fronts", fronts_json(ledger)},
          {"claims", std::move(claims)}};
}

Ledger ledger_from_json(const JsonPlace& place) {
  if (!is_current(place)) place.at("version").fail("must be 1");
  Ledger ledger;
  ledger.quick = place.at("quick").value().is_boolean() && place.at("quick").value().get<bool>();
  const JsonPlace machine = place.at("machine");
  ledger.machine = {machine.at("processor").text(), machine.at("compiler").text(), machine.at("flags").text(),
                    unsigned(count(machine.at("threads")))};
  ledger.left_out = place.at("left_out").text();
  const JsonPlace rows = place.at("rows");
  for (std::size_t k = 0; k < rows.size(); ++k) ledger.rows.push_back(row_from(rows.at(k)));
  const JsonPlace claims = place.at("claims");
  for (std::size_t k = 0; k < claims.size(); ++k) {
    const JsonPlace c = claims.at(k);
    ledger.claims.push_back({c.at("source").text(), c.at("claim").text(), c.at("standing").named<Standing>(),
                             c.at("verdict").text(), c.at("evidence").text(), c.at("question").text(),
                             c.at("choice").text()});
  }
  return ledger;
}

void write_ledger(const std::filesystem::path& path, const Ledger& ledger) {
  io::write_file_atomically(path, io::to_text(to_json(ledger)) + "\n");
}

Ledger read_ledger(const std::filesystem::path& path) {
  const Json json = io::read_json(path);
  return ledger_from_json(JsonPlace(json, path.string()));
}

std::optional<Ledger> read_current_ledger(const std::filesystem::path& path) {
  const Json json = io::read_json(path);
  const JsonPlace place(json, path.string());
  return is_current(place) ? std::optional(ledger_from_json(place)) : std::nullopt;
}

std::string to_csv(const Ledger& ledger) {
  std::string text =
      "unit,question,choice,exact,cost_ns,cost_ratio,cost_spread,error_max,error_mean,error_p99,measure,of,"
      "where,image_error,domain,dominated_by\n";
  for (const LedgerRow& r : ledger.rows) {
    text += io::csv_quoted(name_of(r.unit)) + "," + io::csv_quoted(r.question) + "," +
            io::csv_quoted(r.choice) + "," + io::csv_quoted(r.exact);
    for (double x :
         {r.cost.seconds * 1e9, r.cost_ratio, r.cost.spread, r.error.max, r.error.mean, r.error.p99})
      text += "," + io::to_text(x);
    text += "," + io::csv_quoted(name_of(r.error.measure)) + "," + io::csv_quoted(r.quantity) + "," +
            io::csv_quoted(r.error.where) + "," + (r.image_error ? io::to_text(*r.image_error) : "") + "," +
            io::csv_quoted(r.domain) + "," + io::csv_quoted(r.dominated_by) + "\n";
  }
  return text;
}

}  // namespace brdf::trade
