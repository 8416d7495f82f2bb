// Any bytes are a case, or are refused as one: no crash, no leak, no undefined behavior, and warnings that can be
// shown.

#include "suffuse/casefile/load_case.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace suffuse;
    const std::string text(reinterpret_cast<const char*>(bytes), size);
    try {
        const casefile::LoadedCase loaded = casefile::load_case_text(text, "case.toml", SUFFUSE_FUZZ_DATA);
        render(loaded.warnings);
    } catch (const CaseError&) {
    } catch (const IoError&) {
    }
    return 0;
}
