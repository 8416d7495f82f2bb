// Any bytes are the record of a laboratory test, or are refused as one.

#include "suffuse/base/error.hpp"
#include "suffuse/laboratory/read_test.hpp"

#include <cmath>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace suffuse;
    const auto source =
        std::make_shared<Source>(Source{"test.csv", std::string(reinterpret_cast<const char*>(bytes), size)});
    using enum laboratory::TestKind;
    for (const auto kind : {Triaxial, Oedometer, Permeameter}) {
        try {
            const laboratory::TestRecord record = laboratory::parse_test(source, {.kind = kind});
            for (const laboratory::TestColumn& column : record.columns) {
                if (column.values.size() != record.rows() || record.rows() == 0) {
                    std::abort();
                }
            }
        } catch (const CaseError&) {
        }
    }
    return 0;
}
