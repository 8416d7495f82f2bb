// Any bytes are a packing in one of the formats that are imported, or are refused as one.

#include "suffuse/base/error.hpp"
#include "suffuse/io/packing_file.hpp"

#include "tests/fuzz/scratch_file.hpp"
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace suffuse;
    try {
        const io::ImportedPacking packing = io::read_packing(fuzz::scratch_file(bytes, size), 2600);
        for (const double r : packing.grains.radius) {
            if (!(r > 0)) {
                std::abort();
            }
        }
    } catch (const CaseError&) {
    } catch (const IoError&) {
    }
    return 0;
}
