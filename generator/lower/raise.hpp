#pragma once

#include <ginac/ginac.h>

#include <functional>
#include <unordered_map>

#include "ir/graph.hpp"

namespace gaussgen::lower {

/// The graph back to GiNaC, for tests: raise(lower(e)) equals e.
class Raising {
 public:
  using Resolve = std::function<GiNaC::ex(ir::SymbolId)>;

  Raising(const ir::Graph& graph, Resolve resolve) : graph_(graph), resolve_(std::move(resolve)) {}

  GiNaC::ex operator()(ir::NodeId root);

 private:
  GiNaC::ex raised(const ir::Node& node) const;
  GiNaC::ex call(const ir::Node& node) const;
  GiNaC::ex cases(const ir::Node& piecewise) const;
  const GiNaC::ex& known(ir::NodeId id) const { return memo_.at(id.index); }

  const ir::Graph& graph_;
  Resolve resolve_;
  std::unordered_map<std::uint32_t, GiNaC::ex> memo_;
};

}  // namespace gaussgen::lower
