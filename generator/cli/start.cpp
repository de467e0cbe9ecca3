#include "cli/start.hpp"

#include "assembly.hpp"
#include "evaluation.hpp"
#include "general_start.hpp"
#include "initial_check.hpp"

namespace gaussgen::cli {

void set_start(Mechanics& mechanics, model::Model& model, const support::Rational& time, int digits,
               const Options& options, support::Diagnostics& diagnostics) {
  const double at = support::to_double(time);
  if (options.pipeline.assemble) {
    const StatedStart stated = stated_start(model, mechanics.expressions);
    assemble(mechanics, model, at);
    for (const std::string& moved : assembled_values(mechanics, stated, time))
      remark("assembled " + moved, options.messages);
  } else {
    report_found(improve_guesses(mechanics, model, at), model, diagnostics);
  }
  find_general_start(mechanics, time, digits);
  if (!is_start_found(mechanics, time, digits)) find_start_otherwise(mechanics, time, digits);
  if (!is_start_reached(mechanics, time, digits)) refine_guesses(mechanics, model, at);
}

}  // namespace gaussgen::cli
