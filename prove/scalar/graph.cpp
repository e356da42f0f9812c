#include "prove/scalar/graph.h"

#include <algorithm>
#include <cstdlib>

namespace brdf::prove {
namespace {

thread_local Graph* active = nullptr;

}  // namespace

int Graph::node(std::string_view op, const std::vector<int>& operands, double constant) {
  const auto [it, inserted] = known_.try_emplace(Key{op, operands, constant}, int(known_.size()) + 1);
  if (inserted) keys_.push_back(&it->first);
  return it->second;
}

std::vector<int> Graph::parts(std::string_view op, int node) const {
  const Key& key = *keys_[std::size_t(std::abs(node) - 1)];
  if (rules_ == Rules::bits || key.op != op) return {node};
  std::vector<int> parts = key.operands;
  if (op == "+" && node < 0)
    for (int& part : parts) part = -part;
  return parts;
}

int Graph::compare(int a, int b) {
  const bool turned = a > b;
  const auto [it, asked] = asked_.try_emplace({std::min(a, b), std::max(a, b)}, asked_.size());
  if (asked && answers_.size() < asked_.size()) answers_.push_back(-1);
  const int answer = answers_[it->second];
  return turned ? -answer : answer;
}

bool Graph::next_case() {
  answers_.resize(asked_.size());
  asked_.clear();
  while (!answers_.empty() && answers_.back() == 1) answers_.pop_back();
  if (answers_.empty()) return false;
  ++answers_.back();
  return true;
}

Graph& Graph::current() {
  static thread_local Graph fallback;
  return active ? *active : fallback;
}
Graph::Scope::Scope(Graph& graph) : previous_(active) {
  active = &graph;
}
Graph::Scope::~Scope() {
  active = previous_;
}

Recorded::Recorded(double constant)
    : id_(Graph::current().node("constant", {}, constant < 0 ? -constant : constant)),
      negative_(constant < 0) {}

Recorded Recorded::input(std::string_view name) {
  return {Graph::current().node(name, {}), false};
}

namespace {

bool smaller_node(int a, int b) {
  return std::abs(a) != std::abs(b) ? std::abs(a) < std::abs(b) : a < b;
}

std::vector<int> joined(std::string_view op, int a, int b) {
  std::vector<int> parts = Graph::current().parts(op, a);
  const std::vector<int> others = Graph::current().parts(op, b);
  parts.insert(parts.end(), others.begin(), others.end());
  std::ranges::sort(parts, smaller_node);
  return parts;
}

}  // namespace

// Negating all operands negates the sum: the first operand is kept positive.
Recorded Recorded::sum(std::string_view op, const Recorded& a, const Recorded& b) {
  std::vector<int> terms = joined(op, a.signed_id(), b.signed_id());
  const bool negative = terms.front() < 0;
  if (negative)
    for (int& term : terms) term = -term;
  return {Graph::current().node(op, terms), negative};
}

Recorded operator*(const Recorded& a, const Recorded& b) {
  const int one = Recorded(1.0).id_;
  const bool negative = a.negative_ != b.negative_;
  if (a.id_ == one) return {b.id_, negative};
  if (b.id_ == one) return {a.id_, negative};
  return {Graph::current().node("*", joined("*", a.id_, b.id_)), negative};
}
Recorded operator/(const Recorded& a, const Recorded& b) {
  return {Graph::current().node("/", {a.id_, b.id_}), a.negative_ != b.negative_};
}

bool operator<(const Recorded& a, const Recorded& b) {
  if (a == b) return false;
  return Graph::current().compare(a.signed_id(), b.signed_id()) < 0;
}

Recorded Recorded::extreme(std::string_view op, const Recorded& a, const Recorded& b) {
  const int x = a.signed_id(), y = b.signed_id();
  return {Graph::current().node(op, {std::min(x, y), std::max(x, y)}), false};
}
Recorded Recorded::function(std::string_view name, const Recorded& x) {
  return {Graph::current().node(name, {x.signed_id()}), false};
}
Recorded Recorded::function(std::string_view name, const Recorded& x, const Recorded& y) {
  return {Graph::current().node(name, {x.signed_id(), y.signed_id()}), false};
}

}  // namespace brdf::prove
