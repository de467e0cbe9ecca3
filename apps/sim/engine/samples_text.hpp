#pragma once
// The part of a plugin that finds several samples of a step by power series at once.

#include <string>
#include <string_view>
#include <vector>

#include "emit/cpp_tree.hpp"

namespace gausssim {

/// engine/samples_glue.hpp.
std::string_view samples_runtime();

/// As an entry of a plugin that finds these functions at each sample is called.
std::string samples_name(const std::vector<std::string>& functions);

/// The type GaussSimSampled of samples_glue.hpp, for these functions of a header. Empty where one of them, or projection, is no straight code: what one sample needs more steps
/// for, or another way, is found one by one.
std::string sampled_text(const gaussgen::emit::cpp::File& tree, const std::vector<std::string>& functions);

}  // namespace gausssim
