#include "sim/methods/dopri5.hpp"
#include "sim/methods/in_quads.hpp"

namespace gausssim {

template <>
Made<Quad> make_dopri5(const Problem<Quad>& problem) {
  return std::make_unique<InQuads>(problem,
                                   [](const Problem<Wide>& wide) { return make_adaptive<Wide, Dopri5>(wide); });
}

}  // namespace gausssim
