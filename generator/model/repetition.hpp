#pragma once
// `count: 3`: an entry of which there are several, with `$i` in its name and its texts. Private to the folder.

#include "model/choices.hpp"
#include "model/reading.hpp"

namespace gaussgen::model {

/// The same file with every entry written out, and without `counts`; `given` go before what stands there. Throws UnknownCount.
spec::Node repeated(spec::Node root, const GivenCounts& given, Reading& reading);

}  // namespace gaussgen::model
