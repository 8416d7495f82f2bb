// Any bytes are a grading curve, or are refused as one.

#include "suffuse/grains/grading.hpp"

#include "suffuse/gradings/read_grading.hpp"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace suffuse;
    const auto source =
        std::make_shared<Source>(Source{"sand.csv", std::string(reinterpret_cast<const char*>(bytes), size)});
    for (const auto ends : {gradings::CurveEnds::Closed, gradings::CurveEnds::MayBeOpen}) {
        Problems problems;
        const auto grading = gradings::parse_grading(source, problems, ends);
        render(problems.sorted());
        if (grading.has_value() == problems.has_errors()) {
            std::abort(); // a curve, or a reason why not
        }
        Problems of_all;
        const auto samples = gradings::parse_gradings(source, of_all, ends);
        if (samples.empty() != of_all.has_errors()) {
            std::abort(); // the same of a file of several samples
        }
        if (grading && ends == gradings::CurveEnds::Closed) {
            grains::check(*grading); // what is read is a curve in the sense of those who use it
        }
    }
    return 0;
}
