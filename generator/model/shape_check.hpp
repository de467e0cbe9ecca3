#pragma once
// The shape of what is not read: keys and kinds of values, by the table of the format. Private to the folder.

#include <string>

#include "model/format.hpp"
#include "model/reading.hpp"

namespace gaussgen::model {

/// Reports what a reader would report of the shape; `owner` is where to point for what has no place of its own.
void check_shape(const spec::Node& node, const format::Value& value, support::Span owner, const std::string& where,
                 Reading& reading);

}  // namespace gaussgen::model
