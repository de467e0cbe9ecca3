#include "model/checks.hpp"

namespace gaussgen::model {

void check_model(const spec::Node&, Reading& reading) {
  check_domains(reading);
  order_parameters(reading);
}

}  // namespace gaussgen::model
