#include "suffuse/io/digest_within.hpp"

#include <algorithm>

namespace suffuse::io {

void DigestWithin::add(std::string_view bytes) {
    const std::size_t begin = std::clamp(place_, at_, at_ + bytes.size()) - at_;
    const std::size_t end = std::clamp(place_ + digits, at_, at_ + bytes.size()) - at_;
    hash_.add(bytes.substr(0, begin));
    hash_.add(std::string(end - begin, '0'));
    hash_.add(bytes.substr(end));
    recorded_ += bytes.substr(begin, end - begin);
    at_ += bytes.size();
}

} // namespace suffuse::io
