#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/manual_page.hpp"
#include "cli/option_rows.hpp"

namespace gaussgen::cli {

namespace {

Manual texts() {
  Manual manual;
  manual.program = "gauss-gen";
  manual.summary = k_summary;
  manual.description = k_description;
  for (const ExitMeaning& exit : k_exit_meanings) manual.exits.emplace_back(exit.code, exit.meaning);
  manual.examples = {
      {"gauss-gen init pendulum", "writes a model to begin with"},
      {"gauss-gen pendulum.yaml -o include", "writes include/pendulum.hpp"},
      {"gauss-gen evaluate pendulum.yaml --set theta=pi/3", "accelerations and reactions there, without a compiler"},
      {"gauss-gen evaluate crane.yaml --equilibrium", "where it rests, and what its constraints carry there"},
      {"gauss-gen evaluate arm.yaml --accelerate elbow=2", "forces and inputs that make this motion"},
      {"gauss-gen linearize bicycle.yaml --set lean=0 --set steer=0", "eigenvalues and modes of the upright run"},
      {"gauss-gen explain E041", "what is wrong, with an example and its cure"},
  };
  manual.see_also = "README.md, the tutorial and the reference of the format in the folder doc/gauss";
  return manual;
}

}  // namespace

int manual() {
  write_standard_output(manual_page(texts(), command_rows()));
  return k_ok;
}

}  // namespace gaussgen::cli
