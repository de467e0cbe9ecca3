#include "sim/methods/bulirsch_stoer.hpp"
#include "sim/methods/in_quads.hpp"
#include "sim/methods/settings.hpp"

namespace gausssim {

template <>
Made<Quad> make_bulirsch_stoer(const Problem<Quad>& problem) {
  return std::make_unique<InQuads>(problem, [](const Problem<Wide>& wide) -> Made<Wide> {
    return std::make_unique<BulirschStoer<Wide>>(wide.model, wide.start, wide.t, settings_of(wide));
  });
}

}  // namespace gausssim
