#include "model/checks.hpp"

namespace gaussgen::model {

void check_model(Reading& reading) {
  for (const std::string& name : reading.refused) reading.model.symbols.erase(name);
  check_references(reading);
  check_domains(reading);
  order_parameters(reading);
  check_sensitivities(reading);
  check_values(reading);
  check_smoothness(reading);
  check_reactions(reading);
  check_topology(reading);
}

}  // namespace gaussgen::model
