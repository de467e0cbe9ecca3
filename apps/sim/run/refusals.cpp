#include "sim/run/refusals.hpp"

#include <fmt/format.h>

#include "sim/run/jumps.hpp"

namespace gausssim {

void RefusalWatch::look(double t, long steps, long refused) {
  constexpr long k_many = 1'000'000;
  if (has_said_ || refused < k_many || refused < steps) return;
  has_said_ = true;
  bar_.clear();
  const std::string why =
      prepared_.edge.empty() ? "a looser tolerance or another method may do" : hint_for_edge(prepared_.edge);
  gaussgen::cli::warn(fmt::format("at t = {:.6g} the run hardly goes on: {} steps were taken and {} refused; {}", t,
                                  steps, refused, why),
                      messages_);
}

}  // namespace gausssim
