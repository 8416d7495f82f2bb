#pragma once
// A pass of an erosion or a removal. What the physics cannot do it says of the state; which keys of a case help is said
// here.

#include <functional>

namespace suffuse::run {

/// @param pass erode_once or remove_once. @return what it returns: whether there is another
bool take_pass(const std::function<bool()>& pass);

} // namespace suffuse::run
