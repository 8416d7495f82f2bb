#pragma once
// What each figure shows, from which stages it is drawn, and what to make of it: the text of `suffuse explain FIGURE`.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::figures {

/// One screen on a figure, known as "9", "fig09", "figure-9" or "own-rules"; nothing where there is none.
std::optional<std::string> explain_figure(std::string_view name);

/// Names under which figures are known: "figure-9", "own-rules".
std::vector<std::string> figure_names();

} // namespace suffuse::figures
