#pragma once

// Standard streams that the caller closed (`suffuse ... >&-`): the next file that is opened would take their numbers,
// and messages would land in it.

namespace suffuse::apps {

/// Opens /dev/null in the place of each of the three that is closed.
void fill_closed_streams();

} // namespace suffuse::apps
