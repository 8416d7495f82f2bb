#pragma once
// What a case would be warned of or marked for, reported to a caller from Python.

#include <pybind11/pybind11.h>
#include <string>

namespace suffuse::python {

/// As a warning of Python's; nothing where there are no words. @param frames from the binding to the line to blame
/// @throws error_already_set where the caller makes warnings errors
inline void warn_caller(const std::string& words, int frames = 1) {
    if (!words.empty() && PyErr_WarnEx(PyExc_UserWarning, words.c_str(), frames) != 0) {
        throw pybind11::error_already_set();
    }
}

} // namespace suffuse::python
