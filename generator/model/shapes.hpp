#pragma once
// Values of the format against what stands in a file. Private to the folder.

#include "model/format.hpp"
#include "spec/node.hpp"

namespace gaussgen::model {

spec::NodeKind kind_of(format::Shape shape);

/// Whether the value has this shape, as far as its brackets tell.
bool fits(const spec::Node& node, const format::Value& value);

}  // namespace gaussgen::model
