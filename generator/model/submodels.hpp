#pragma once
// `submodels:` parts of a model that stand in files of their own. Private to the folder.

#include "model/reading.hpp"

namespace gaussgen::model {

/// The file with all repetitions and submodels written out: what is left are the sections that every model has. The texts of
/// other files are put behind that of `source`.
spec::Node with_submodels(spec::Node root, support::Source& source, Reading& reading);

}  // namespace gaussgen::model
