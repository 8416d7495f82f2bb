// A finished run of which some files are others, with checksums to match, is read or refused by verify, resume and
// report. The bytes say which files, and what is changed in each.

#include "tests/fuzz/change_json.hpp"
#include "tests/fuzz/finished_run.hpp"
#include <algorithm>

namespace {

using namespace suffuse;
using nlohmann::json;

/// Some bytes of it replaced by others.
std::string changed_bytes(std::string file, fuzz::Bytes& bytes) {
    const std::size_t at = std::min((std::size_t{bytes.next()} << 16U) | bytes.next_pair(), file.size());
    const std::size_t taken = bytes.next();
    std::string put(bytes.next() % 64, ' ');
    for (char& each : put) {
        each = static_cast<char>(bytes.next());
    }
    return file.replace(at % (file.size() + 1), taken, put);
}

std::string changed(const std::string& name, const std::string& file, fuzz::Bytes& bytes) {
    const bool is_json = name.ends_with(".json"), is_cbor = name.ends_with(".cbor");
    if (!(is_json || is_cbor) || bytes.next() % 8 == 7) {
        return changed_bytes(file, bytes);
    }
    json document = is_json ? json::parse(file, nullptr, false) : json::from_cbor(file, true, false);
    for (int left = bytes.next() % 4; left >= 0; --left) {
        fuzz::change(document, bytes);
    }
    if (is_json) {
        return document.dump(2, ' ', false, json::error_handler_t::replace);
    }
    const std::vector<std::uint8_t> written = json::to_cbor(document);
    return {written.begin(), written.end()};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::FinishedRun& run = fuzz::FinishedRun::the();
    fuzz::Bytes bytes{data, size};
    std::map<std::string, std::string> replaced;
    for (int left = bytes.next() % 3; left >= 0; --left) {
        const auto file =
            std::next(run.files().begin(), static_cast<std::ptrdiff_t>(bytes.next_pair() % run.files().size()));
        replaced[file->first] = changed(file->first, file->second, bytes);
    }
    run.look_with(replaced);
    return 0;
}
