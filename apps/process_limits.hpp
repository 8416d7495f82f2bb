#pragma once

// Limits that the caller set for this process (`ulimit -n`, `ulimit -s`): raised as far as the caller allows, and
// refused where the program would end in the middle of its work.

namespace suffuse::apps {

/// Of the stack of the main thread, and of threads that begin later. @throws IoError where it is too small for any verb
void raise_stack_limit();

/// Of files that are open at once. @throws IoError where they are too few to read a case and write a run
void raise_file_limit();

} // namespace suffuse::apps
