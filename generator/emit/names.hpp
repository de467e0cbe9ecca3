#pragma once
// Who is called what: one table per header, one scope per function.

#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "emit/unit.hpp"

namespace gaussgen::emit {

/// Names in use, so that no two things share one.
class NameScope {
 public:
  /// `wanted`, made safe and unique by a number if need be: x, x_2, x_3.
  std::string allocate(const std::string& wanted);
  /// t1, t2, …
  std::string allocate_anonymous(const std::string& prefix);
  void reserve(const std::string& name) { taken_.insert(name); }
  void release(const std::string& name) { taken_.erase(name); }
  bool is_free(const std::string& name) const { return taken_.count(name) == 0; }

 private:
  std::unordered_set<std::string> taken_;
  std::map<std::string, int> last_number_;
};

/// What a user of the header sees: each name of the model has one text everywhere.
class UnitNames {
 public:
  UnitNames(const ir::Graph& graph, const Unit& unit);

  /// The text of a name of the model.
  const std::string& of(const std::string& name) const { return texts_.at(name); }
  const std::string& of(const Entry& entry) const { return of(entry.name); }

  /// The function that gives a derivative of a table, and the one that finds the piece for all of them.
  const std::string& of_table(ir::TableId table, int order) const {
    return tables_.at(table.index)[static_cast<std::size_t>(order)];
  }
  const std::string& of_pieces(ir::TableId table) const { return tables_.at(table.index).back(); }

  /// As local variables call a symbol; empty if it has no name of its own.
  std::string of_symbol(SymbolId symbol) const;
  void bind(SymbolId symbol, const std::string& text) { symbols_[symbol.index] = text; }

  /// For temporaries of one function: everything above is taken.
  NameScope function_scope() const { return scope_; }
  /// For members of Prepared.
  NameScope& scope() { return scope_; }

 private:
  void add(const std::string& name);
  void add(const Entry& entry);
  void add(const support::Table& table);

  NameScope scope_;
  std::map<std::string, std::string> texts_;
  std::unordered_map<std::uint32_t, std::string> symbols_;
  std::vector<std::vector<std::string>> tables_;  ///< of each: value, derivatives, pieces
};

}  // namespace gaussgen::emit
