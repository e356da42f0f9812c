#include "shader/front/tree.h"

#include <glslang/Include/intermediate.h>
#include <glslang/MachineIndependent/localintermediate.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace brdf::shader {
namespace {

// The node of the whole text; null if the tree is empty.
glslang::TIntermAggregate* root_of(glslang::TIntermediate& tree) {
  return tree.getTreeRoot() ? tree.getTreeRoot()->getAsAggregate() : nullptr;
}

class ScopeRemover final : public glslang::TIntermTraverser {
 public:
  bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
    if (node->getOp() == glslang::EOpScope) node->setOperator(glslang::EOpSequence);
    return true;
  }
};

class CallFinder final : public glslang::TIntermTraverser {
 public:
  bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
    const std::string name = node->getName().c_str();
    if (node->getOp() == glslang::EOpFunction) bodies_.insert(name);
    if (node->getOp() == glslang::EOpFunctionCall) {
      const glslang::TSourceLoc& at = node->getLoc();
      calls_.push_back({name, at.getFilename() ? at.getFilename() : "", at.line});
    }
    return true;
  }
  std::optional<EmptyCall> first() const {
    for (const EmptyCall& call : calls_)
      if (!bodies_.contains(call.function)) return call;
    return std::nullopt;
  }

 private:
  std::set<std::string> bodies_;
  std::vector<EmptyCall> calls_;
};

}  // namespace

std::optional<EmptyCall> call_without_body(glslang::TIntermediate& tree) {
  CallFinder finder;
  if (tree.getTreeRoot()) tree.getTreeRoot()->traverse(&finder);
  std::optional<EmptyCall> call = finder.first();
  if (call) call->function.resize(std::min(call->function.find('('), call->function.size()));
  return call;
}

void move_initialisers(glslang::TIntermediate& tree, const char* name) {
  glslang::TIntermAggregate* const root = root_of(tree);
  if (!root) return;
  glslang::TIntermAggregate* body = nullptr;
  const auto is_initialiser = [](TIntermNode* node) {
    const auto* const part = node->getAsAggregate();
    return part && part->getOp() != glslang::EOpFunction && part->getOp() != glslang::EOpLinkerObjects;
  };
  for (TIntermNode* node : root->getSequence()) {
    const auto* const function = node->getAsAggregate();
    if (!function || function->getOp() != glslang::EOpFunction || function->getSequence().size() < 2)
      continue;
    if (std::string(function->getName().c_str()) == std::string(name) + "(")
      body = function->getSequence()[1]->getAsAggregate();
  }
  if (!body) return;
  auto& parts = root->getSequence();
  const auto first = std::stable_partition(parts.begin(), parts.end(),
                                           [&](TIntermNode* node) { return !is_initialiser(node); });
  body->getSequence().insert(body->getSequence().begin(), first, parts.end());
  parts.erase(first, parts.end());
}

void remove_scopes(glslang::TIntermediate& tree) {
  ScopeRemover remover;
  if (tree.getTreeRoot()) tree.getTreeRoot()->traverse(&remover);
}

}  // namespace brdf::shader
