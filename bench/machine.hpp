#pragma once

namespace bench {

/// Processor, load, compiler, flags and version: what a figure belongs to.
void print_machine();

}  // namespace bench
