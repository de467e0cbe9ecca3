#pragma once
// Which tables of ARKODE are offered.

#include <string>
#include <vector>

#include "sim/methods/arkode.hpp"

namespace gausssim {

struct NamedTable {
  std::string method;
  int order;
  ArkodeTable table;
};

const std::vector<NamedTable>& arkode_tables();

}  // namespace gausssim
