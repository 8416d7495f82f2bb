#pragma once

#include <string>

namespace suffuse::apps {

/// Whether the desktop took the page: xdg-open hands it to the browser that the user has chosen.
bool open_in_browser(const std::string& page);

} // namespace suffuse::apps
