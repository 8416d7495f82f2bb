// Any bytes are a packing in one of the formats that are imported, or are refused as one; and so are the grains in the
// cell that they bring.

#include "suffuse/base/error.hpp"
#include "suffuse/io/packing_checks.hpp"

#include "tests/fuzz/scratch_file.hpp"
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace suffuse;
    try {
        const io::TakenPacking packing = io::take_packing({.file = fuzz::scratch_file(bytes, size)});
        for (const double r : packing.grains.radius) {
            if (!(r > 0)) {
                std::abort();
            }
        }
    } catch (const CaseError&) {
    } catch (const GeometryError&) { // lengths so large that no cell can be computed with them
    } catch (const IoError&) {
    }
    return 0;
}
