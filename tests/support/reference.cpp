#include "tests/support/reference.hpp"

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <vector>
#include <zlib.h>

namespace suffuse::test {

std::string in_checkout(const std::string& path) {
    return SUFFUSE_SOURCE_DIR "/" + path;
}

std::string read_reference(const std::string& name) {
    const std::string path = in_checkout("tests/reference/" + name);
    gzFile file = gzopen(path.c_str(), "rb");
    if (file == nullptr) {
        throw std::runtime_error("cannot open " + path);
    }
    std::string text;
    std::vector<char> buffer(1 << 16);
    for (int count = 0; (count = gzread(file, buffer.data(), static_cast<unsigned>(buffer.size()))) > 0;) {
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    gzclose(file);
    return text;
}

nlohmann::json read_reference_json(const std::string& name) {
    return nlohmann::json::parse(read_reference(name));
}

} // namespace suffuse::test
