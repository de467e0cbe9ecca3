#pragma once
// A header with several bodies of one model: the functions of each set of effects once, and for each body which of them are its own.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "emit/variants.hpp"

namespace gaussgen::emit {

/// One body. Values are those in which it differs from the defaults of its functions.
struct InstanceRow {
  std::string name;
  std::size_t variant = 0;                             ///< index
  std::vector<std::pair<std::string, double>> values;  ///< of parameters and inputs
  std::vector<std::pair<std::string, double>> start;   ///< of components of the state
};

/// `headers`: the text of each variant's. `outer`: the namespace in which each body has one by its name.
std::string instances_header(const std::string& name, const std::string& outer, const std::string& command,
                             const std::vector<Variant>& variants, const std::vector<std::string>& headers,
                             const std::vector<InstanceRow>& instances);

}  // namespace gaussgen::emit
