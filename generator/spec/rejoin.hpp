#pragma once
// In [..] and {..} YAML cuts `atan2(y, x)` at its comma. A writer of a formula does not expect that:
// pieces are put together again where that balances their round brackets.

#include "spec/node.hpp"

namespace gaussgen::spec {

/// [0, atan2(y, x), 1] has three items.
void rejoin_items(std::vector<Node>& items);

/// {potential: atan2(y, x)} has one entry; the pieces after a comma arrive as keys without value. So has {value: 0,8}: the comma, not
/// a key 8, is what the reader of the expression is to complain about.
void rejoin_entries(std::vector<Entry>& entries);

}  // namespace gaussgen::spec
