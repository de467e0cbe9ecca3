#pragma once
// One reader for each section of a model file; they fill Reading::model in this order, because later
// ones refer to names of earlier ones. Private to the folder.

#include "model/reading.hpp"

namespace gaussgen::model {

/// A missing one is reported at `owner`.
void read_version(const spec::Node& root, support::Span owner, Reading& reading);
void read_header(const spec::Node& root, Reading& reading);
void read_tables(const spec::Node& root, Reading& reading);
void read_parameters(const spec::Node& root, Reading& reading);
void read_inputs(const spec::Node& root, Reading& reading);
void read_coordinates(const spec::Node& root, Reading& reading);
void read_speeds(const spec::Node& root, Reading& reading);  ///< after all that declares coordinates
void read_orientations(const spec::Node& root, Reading& reading);
void read_frames(const spec::Node& root, Reading& reading);  ///< points, too
void read_joints(const spec::Node& root, Reading& reading);
void read_bodies(const spec::Node& root, Reading& reading);
void read_constraints(const spec::Node& root, Reading& reading);
void read_contacts(const spec::Node& root, Reading& reading);  ///< after constraints, before forces
void read_forces(const spec::Node& root, Reading& reading);
void read_quantities(const spec::Node& root, Reading& reading);
void declare_reactions(Reading& reading);  ///< after all that forces and quantities may mention
void read_exact(const spec::Node& root, Reading& reading);
void read_elimination(const spec::Node& root, Reading& reading);
void read_rank_tolerance(const spec::Node& root, Reading& reading);
void read_outputs(const spec::Node& root, Reading& reading);
void read_sensitivities(const spec::Node& root, Reading& reading);

}  // namespace gaussgen::model
