#pragma once
// The C++ half of the Python module, suffuse._core: a file per part, each adding its classes and functions. What is
// shared by them stands in convert.hpp, views.hpp and work.hpp.

#include <pybind11/pybind11.h>

namespace suffuse::python {

void bind_errors(pybind11::module_& m);
void bind_settings(pybind11::module_& m); ///< material, fluid, balance, loading
void bind_contacts(pybind11::module_& m);
void bind_world(pybind11::module_& m);
void bind_steps(pybind11::module_& m);            ///< what moves a world; after bind_world
void bind_laboratory_tests(pybind11::module_& m); ///< tests and probes of a world; after bind_world
void bind_preparation(pybind11::module_& m);      ///< what makes a sample; after bind_world
void bind_pores(pybind11::module_& m);            ///< pore networks and constrictions
void bind_water(pybind11::module_& m);            ///< flow; after bind_pores
void bind_mobility(pybind11::module_& m);         ///< which gradients move fines; after bind_world
void bind_migration(pybind11::module_& m);        ///< fines that travel; after bind_world
void bind_own_rule(pybind11::module_& m);         ///< what a rule of Python's is given; before bind_erosion
void bind_erosion(pybind11::module_& m);          ///< passes of the erosion; after bind_world
void bind_resolved(pybind11::module_& m);         ///< flow on a grid
void bind_files(pybind11::module_& m);            ///< packings from and for other programs
void bind_laboratory(pybind11::module_& m);       ///< records of laboratory tests
void bind_stability(pybind11::module_& m);        ///< what a grading says
void bind_cases(pybind11::module_& m);            ///< case files, plans, the schema
void bind_runs(pybind11::module_& m);
void bind_calibration(pybind11::module_& m); ///< parameters from laboratory tests
void bind_pickling(pybind11::module_& m);    ///< by any protocol; after all classes
void bind_keywords(pybind11::module_& m);    ///< wrong names of arguments; after all others

} // namespace suffuse::python
