#pragma once
// Holds a run within a stage until a test lets it go on. So what is tested of a signal, or of a second program, does
// not depend on the speed of the machine. Only tests set the variable SUFFUSE_TEST_GATE, to STUDY/SAMPLE/STAGE=FIFO.

#include "suffuse/run/run_options.hpp"

#include <string>

namespace suffuse::apps {

class TestGate {
public:
    TestGate(); ///< reads the variable

    [[nodiscard]] bool is_set() const { return !fifo_.empty(); }

    /// At the first burst of the stage: waits until a writer has opened the FIFO, and closed it.
    void pass(const run::Progress& progress);

private:
    std::string stage_, fifo_;
};

} // namespace suffuse::apps
