#pragma once
// The C++ file that is compiled for a run: functions of an emitted header behind symbols that can be looked up.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "emit/cpp_tree.hpp"

namespace gausssim {

struct PluginRequest {
  std::vector<std::string> functions;  ///< of the header; those that it lacks are left out
  std::vector<std::string> scalars;    ///< float, double, long double
  /// Of the functions, what is found at each sample; given: by power series several at once are found, where all of them can be.
  std::optional<std::vector<std::string>> sampled = {};
  std::optional<int> usual_rank =
      {};  ///< of the constraints; given: gains are wanted, where the header has what they need
};

/// It is linked with libquadmath then.
bool uses_quad(const PluginRequest& request);

/// `double` as a part of a symbol.
std::string symbol_part(std::string scalar);

/// int (const void*, void* const* arguments): arguments as the function takes them; of `prepare`, the result comes last.
std::string entry_symbol(const std::string& function, const std::string& scalar);

/// The headers of src/gauss/ that steps by power series need, and engine/taylor_glue.hpp.
std::string_view series_runtime();
/// The headers of src/gauss/ that gains need, and engine/gains_glue.hpp.
std::string_view gains_runtime();
/// What __float128 needs.
std::string_view quad_runtime();

/// Whether a function of the header makes the start.
bool is_of_start(const std::string& function);

/// Comments of all kinds: they hold values and names, and the hash and the place of a file.
void remove_words(gaussgen::emit::cpp::File& tree);

/// Of the header all but values and words about its file, and what makes entries visible.
std::string plugin_header(gaussgen::emit::cpp::File tree);

/// The same text for all values of parameters and of the start: they are given when it runs.
std::string plugin_text(const gaussgen::emit::cpp::File& tree, const PluginRequest& request);

}  // namespace gausssim
