#pragma once

#include <string>
#include <string_view>

namespace gaussgen::emit {

/// True for C++ keywords and alternative tokens, for names that common headers define as macros, and for the names that
/// emitted code uses itself.
bool is_reserved(std::string_view name);

/// A name that is safe in emitted code: valid names as they are, reserved ones with a trailing underscore.
std::string mangled(const std::string& name);

/// RollingAround -> rolling_around, for the argument that has a result type.
std::string snake_case(const std::string& type_name);

/// on_ball -> OnBall
std::string pascal_case(const std::string& name);

}  // namespace gaussgen::emit
