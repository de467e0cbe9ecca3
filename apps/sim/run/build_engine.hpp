#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/run/prepare.hpp"

namespace gausssim {

struct EngineTimes {
  double compile = 0;  ///< s; 0 where nothing was compiled
  bool was_cached = false;
  std::string why_interpreted;  ///< a compiler fails, or is not the one that CXX names
};

enum class EngineChoice { automatic, compiled, interpreted };

/// The functions of a model for these number types, as C++ writes them: compiled, or from the cache, or interpreted where that is asked for, or by default where no compiler does it.
/// Null: `why`. Throws Interrupted, and OutOfTime where a limit is over before it is compiled.
std::unique_ptr<Engine> build_engine(const PreparedModel& prepared, EngineChoice choice,
                                     const std::vector<std::string>& scalars, EngineTimes& times, std::string& why);

/// Says why a model is interpreted that somebody would expect to be compiled.
void warn_of_interpreting(const EngineTimes& times, const gaussgen::cli::MessageOptions& messages);

/// "long-double" of scenes is "long double".
std::string scalar_of(const std::string& number);

/// And back: what C++ calls a number type has no place in what users read.
std::string number_of(const std::string& scalar);

}  // namespace gausssim
