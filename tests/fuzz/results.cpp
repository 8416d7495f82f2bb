// Any bytes are what a stage found, or are refused as that; and what is read is written again as it was.

#include "suffuse/base/error.hpp"
#include "suffuse/record/documents.hpp"
#include "suffuse/record/stored_findings.hpp"

#include "tests/fuzz/mutate_document.hpp"
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace {

using namespace suffuse;

/// In memory, of this process.
const std::filesystem::path& folder() {
    static const std::filesystem::path path = "/dev/shm/suffuse-fuzz-" + std::to_string(getpid());
    static const bool is_made =
        std::filesystem::create_directory(path) && std::atexit([] { std::filesystem::remove_all(folder()); }) == 0;
    return is_made ? path : (std::abort(), path);
}

} // namespace

extern "C" std::size_t
LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest, unsigned seed) {
    return fuzz::mutate_document(
        data, size, largest, seed,
        [](const std::string& bytes) {
            return record::parse_cbor({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
        },
        [](const nlohmann::json& document) {
            const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(document);
            return std::string(bytes.begin(), bytes.end());
        }
    );
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::filesystem::path file = folder() / "results.cbor";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    try {
        const record::StageFindings findings = record::read_findings(folder());
        std::filesystem::remove(file); // none is written where there is nothing to write
        record::save_findings(folder(), findings);
        record::read_findings(folder());
    } catch (const IoError&) {
    }
    return 0;
}
