#pragma once
// One screen on a key of the case file, a code of an error, or the conventions.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::casefile {

/// Text for a key ("watch", "contact.modulus", "study.x.stage.y.watch"), a code ("E310") or "conventions"; empty where
/// nothing is known.
std::optional<std::string> explain(std::string_view what);

/// The key that the place of a key in a case was meant to be, "study.x.stage.y.void_ratio" for
/// "study.x.stage.y.voi_ratio".
std::optional<std::string> nearest_key(std::string_view path);

/// All words that `explain` knows by their own name, sorted.
std::vector<std::string> topics();

/// All codes, in order.
std::vector<std::string> codes();

} // namespace suffuse::casefile
