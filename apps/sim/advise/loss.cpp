#include "sim/advise/loss.hpp"

#include "sim/run/lost_digits.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

Loss::Loss(const PreparedModel& prepared, Engines& engines, double error) {
  const std::string& asked = number_name(prepared.scene);
  const Engine* const engine = asked == "double" || asked == "float" ? engines.of("double") : nullptr;
  if (engine == nullptr) return;
  constexpr double k_seconds = 1;
  Setting setting = default_setting(prepared, *engine);
  setting.tolerance = error;
  const Passage loose = passage(prepared, *engine, setting, k_seconds);
  if (loose.rows.samples() <= 1) return;
  const Yardstick own = of_themselves(loose.rows, prepared, setting);
  const LostDigits digits(prepared, *engine, setting, loose.states, own);
  in_double_ = digits.in("double").value;
  in_long_double_ = digits.in("long-double").value;
}

bool Loss::is_above(double part, const std::string& number) const {
  return (number == "double" ? in_double_ : number == "long-double" ? in_long_double_ : 0) > part;
}

}  // namespace gausssim
