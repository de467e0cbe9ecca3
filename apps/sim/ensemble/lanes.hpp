#pragma once
// A model in SIMD lanes, by power series, in double.

#include <memory>
#include <string>

#include "sim/engine/binding.hpp"
#include "sim/engine/plugin.hpp"

namespace gausssim {

/// Trajectories that follow each other, as ensemble/lanes_glue.hpp reads them. Arrays have those of the first one first.
struct LanesJob {
  const double *prepared, *inputs, *start;
  long count;
  const double* times;  ///< of samples; the last one is the end
  long samples;
  double start_time, tolerance, longest_step;
  long projects, most_steps;
  bool (*ends)();  ///< asked before each step: whether none is taken any more
  double* states;  ///< sample by sample
  double* steps;
  long* arrived;  ///< 1: at the end, and samples have values; as it was: not done
};

/// A compiled model that takes several trajectories at a time. Any number of threads may run it.
class LanesKernel {
 public:
  LanesKernel(std::shared_ptr<const Plugin> plugin, int lanes);

  int lanes() const { return lanes_; }
  void run(LanesJob& job) const;

 private:
  std::shared_ptr<const Plugin> plugin_;
  Entry run_;
  int lanes_;
};

struct BuiltLanes {
  std::unique_ptr<const LanesKernel> kernel;  ///< null: `why`
  std::string why;
  double compile_seconds = 0;
  bool was_cached = false;
};

/// By the compiler of the system, where it finds xsimd and the model has series. Throws Interrupted.
BuiltLanes build_lanes(const Described& model);

/// The C++ file of it.
std::string lanes_text(const Described& model);
/// The headers of src/gauss/ that it needs, and ensemble/lanes_glue.hpp.
std::string_view lanes_runtime();

}  // namespace gausssim
