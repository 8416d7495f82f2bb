#include "suffuse/report/packed.hpp"

#include "suffuse/base/base64.hpp"
#include "suffuse/base/error.hpp"

#include <zlib.h>

namespace suffuse::report {

std::string deflated(std::string_view bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string out(size, '\0');
    const int status = compress2(
        reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
        static_cast<uLong>(bytes.size()), 9
    );
    expects(status == Z_OK, "what is in memory can be compressed");
    out.resize(size);
    return out;
}

std::string packed(std::string_view text) {
    return base64(deflated(text));
}

} // namespace suffuse::report
