#include "sim/run/standstill.hpp"

#include <fmt/format.h>

#include "sim/run/jumps.hpp"

namespace gausssim {

void StandstillWatch::look_after_many_steps() {
  // Smooth motions may have as many steps from one row to the next, and nothing can be done about it.
  if (has_said_ || prepared_.edge.empty()) return;
  has_said_ = true;
  bar_.clear();
  const Span& span = prepared_.span;
  const auto time = [&](long row) {
    return span.start + span.duration * static_cast<double>(row) / static_cast<double>(span.samples - 1);
  };
  gaussgen::cli::warn(
      fmt::format("the run hardly goes on: {} steps lead on from t = {:.6g}, and it is not at {:.6g} yet; {}",
                  AfterManySteps::k_many, time(std::max(last_, 0L)), time(last_ + 1), hint_for_edge(prepared_.edge)),
      messages_);
}

}  // namespace gausssim
