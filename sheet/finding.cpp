#include "sheet/finding.h"

namespace brdf::sheet {
namespace {

io::Json to_json(const Witness& w) {
  io::Json json = io::Json::object();
  for (const auto& [name, value] : w.parameters) json[name] = value;
  for (const auto& [name, value] : w.angles) json[name] = value;
  if (!w.channel.empty()) json["channel"] = w.channel;
  json["command"] = w.command;
  return json;
}

io::Json to_json(const NamedRow& row) {
  io::Json json{
      {"row", row.row + 1},           {"line", row.line > 0 ? io::Json(row.line) : io::Json(nullptr)},
      {"theta_i", row.theta_i},       {"phi_i", row.phi_i},
      {"theta_o", row.theta_o},       {"phi_o", row.phi_o},
      {"beyond_max_theta", row.apart}};
  if (row.channel.empty()) return json;
  json["channel"] = row.channel;
  json["value"] = row.value;
  json["expected"] = row.expected;
  return json;
}

}  // namespace

io::Json to_json(const Finding& f) {
  io::Json json{{"subject", f.subject}, {"check", f.check}, {"verdict", name_of(f.outcome)}};
  json["value"] = io::finite_or_null(f.value);
  json["bound"] = f.bound;
  json["statement"] = f.statement;
  json["witness"] = f.witness ? to_json(*f.witness) : io::Json(nullptr);
  if (f.tied) json["tied"] = {{"value", f.tied->value}, {"witness", to_json(f.tied->witness)}};
  for (const auto& [name, value] : f.channels) json["channels"][name] = io::finite_or_null(value);
  if (!f.proof.empty()) json["proof"] = f.proof;
  json["evaluations"] = f.evaluations;
  for (const NamedRow& row : f.rows) json["rows"].push_back(to_json(row));
  return json;
}

io::Json to_json(const std::vector<Finding>& findings) {
  io::Json json{{"findings", io::Json::array()}};
  for (const Finding& f : findings) json["findings"].push_back(to_json(f));
  return json;
}

}  // namespace brdf::sheet
