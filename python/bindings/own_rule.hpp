#pragma once
// Detachment rules that are functions of Python: called with what the probe measured, they give a truth value a fine.

#include "suffuse/erosion/own_rule.hpp"

#include <functional>
#include <pybind11/pybind11.h>

namespace suffuse::python {

/// Calls something that needs the interpreter, on a thread that may.
using InInterpreter = std::function<void(const std::function<void()>&)>;

/// @param function stays the caller's, who keeps it as long as the rule is used
/// @throws CaseError where it cannot be called
erosion::OwnRule own_rule_of(pybind11::handle function, InInterpreter call);

} // namespace suffuse::python
