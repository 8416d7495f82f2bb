#pragma once
// All that a program of your own needs, in the order of a work: a grading and what criteria say of it, a packing from
// it or from a file, steps, loading paths, the flow through the pores, erosion; and a whole case from its file to its
// report. Link suffuse::suffuse. SI everywhere, compression is positive. Bad input throws what suffuse/base/error.hpp
// declares.

#include "suffuse/atlas/look_up.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/dem/step.hpp"
#include "suffuse/erosion/loop.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/gradings/read_grading.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/packing_export.hpp"
#include "suffuse/io/packing_file.hpp"
#include "suffuse/job/run_case.hpp"
#include "suffuse/laboratory/read_test.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/packing/seed.hpp"
#include "suffuse/pores/constrictions.hpp"
#include "suffuse/stability/assess.hpp"
#include "suffuse/stats/coordination.hpp"
#include "suffuse/stats/fabric.hpp"
#include "suffuse/stokes/water.hpp"
#include "suffuse/triaxial/run_path.hpp"
