#pragma once
// The axis of grain sizes that all figures of gradings share: logarithmic, in mm, with the classes of ISO 14688.

#include <nlohmann/json.hpp>

namespace suffuse::figures {

/// The x channel of a chart of sizes between `from` and `to` [mm].
nlohmann::json size_axis(double from, double to, bool reversed);

/// Layers with the names and limits of the classes of grain size that the domain [mm] shows.
nlohmann::json class_layers(double from, double to);

/// Layers that shade and name the sizes that count as fine, below `limit` [mm].
nlohmann::json fines_layers(double from, double limit, bool is_reversed);

} // namespace suffuse::figures
