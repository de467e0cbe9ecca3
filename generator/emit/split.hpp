#pragma once
// Functions that are too large for compilers, in parts: their time and memory grow faster than the number of operations.

#include <optional>
#include <vector>

#include "emit/cpp_tree.hpp"

namespace gaussgen::emit {

/// A function as it is printed in one piece, with what its statements do.
struct FunctionCode {
  cpp::Function function;
  std::size_t reads = 0;   ///< statements at the beginning that give local names to arguments
  bool may_alias = false;  ///< a result may be the same object as an argument: nothing is written before all is read
  std::optional<cpp::Struct> type =
      {};  ///< that it fills, of a shape that follows from its code: it stays in one piece
};

/// Called one after the other by `function`; values that several of them need are members of `live`.
struct Parts {
  std::optional<cpp::Struct> live;
  std::vector<cpp::Function> functions;
  cpp::Function function;
};

/// Parts of about `most` operations each, cut where few values are live; the function as it is where it has less than twice
/// as many. The order of operations within each value is kept, so results have the same bits as long as the compiler contracts
/// no product into a sum (-ffp-contract).
Parts split(FunctionCode code, int most);

}  // namespace gaussgen::emit
