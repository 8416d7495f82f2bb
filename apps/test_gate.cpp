#include "apps/test_gate.hpp"

#include <cstdlib>
#include <fstream>
#include <string_view>

namespace suffuse::apps {

TestGate::TestGate() {
    const char* value = std::getenv("SUFFUSE_TEST_GATE");
    const std::string_view text = value == nullptr ? "" : value;
    if (const std::size_t at = text.rfind('='); at != std::string_view::npos) {
        stage_ = text.substr(0, at);
        fifo_ = text.substr(at + 1);
    }
}

void TestGate::pass(const run::Progress& progress) {
    if (!is_set() || progress.steps == 0 || progress.stage_finished ||
        progress.study + "/" + progress.stage != stage_) {
        return;
    }
    std::ifstream(fifo_).get(); // to its end: nobody writes
    fifo_.clear();
}

} // namespace suffuse::apps
