// Any bytes are a packing in one of the formats that are imported, or are refused as one; and so are the grains in the
// cell that they bring. They are a table of contacts, or are refused as one.

#include "suffuse/base/error.hpp"
#include "suffuse/io/contact_table.hpp"
#include "suffuse/io/packing_checks.hpp"

#include "tests/fuzz/scratch_file.hpp"
#include <cstdlib>

namespace {

using namespace suffuse;

void read_as_packing(const std::filesystem::path& file) {
    try {
        const io::TakenPacking packing = io::take_packing({.file = file});
        for (const double r : packing.grains.radius) {
            if (!(r > 0)) {
                std::abort();
            }
        }
    } catch (const CaseError&) {
    } catch (const GeometryError&) { // lengths so large that no cell can be computed with them
    } catch (const IoError&) {
    }
}

void read_as_contacts(const std::filesystem::path& file) {
    grains::Grains grains;
    for (int k = 0; k < 5; ++k) {
        grains::add_grain(grains, {1e-3 * k, 0, 0}, 0.6e-3, 2600);
    }
    try {
        for (const dem::GivenContact& contact : io::read_contacts(file, grains)) {
            if (contact.first >= grains.size() || contact.second >= grains.size()) {
                std::abort();
            }
        }
    } catch (const CaseError&) {
    } catch (const IoError&) {
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::filesystem::path file = fuzz::scratch_file(bytes, size);
    read_as_packing(file);
    read_as_contacts(file);
    return 0;
}
