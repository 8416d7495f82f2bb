// Any bytes are the numbers of a finished stage, or are refused as that by what reads runs.

#include "suffuse/record/documents.hpp"

#include "tests/fuzz/finished_run.hpp"
#include "tests/fuzz/mutate_document.hpp"

namespace {

using namespace suffuse;
using nlohmann::json;

/// The stage that the numbers say they are of, or the erosion.
std::string file_of(const json& numbers) {
    const auto word = [&](const char* key, const char* usual) {
        return numbers.is_object() && numbers.contains(key) && numbers.at(key).is_string()
                   ? numbers.at(key).get<std::string>()
                   : usual;
    };
    const std::string name = "studies/" + word("sample", "s/fc=20") + "/" + word("stage", "eroded") + "/stage.json";
    return fuzz::FinishedRun::the().files().contains(name) ? name : "studies/s/fc=20/eroded/stage.json";
}

} // namespace

extern "C" std::size_t
LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest, unsigned seed) {
    return fuzz::mutate_document(data, size, largest, seed, record::parse_json, [](const json& document) {
        return document.dump(-1, ' ', false, json::error_handler_t::replace);
    });
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    fuzz::FinishedRun::the().look_with({{file_of(record::parse_json(bytes)), bytes}});
    return 0;
}
