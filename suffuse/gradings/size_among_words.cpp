#include "suffuse/gradings/size_among_words.hpp"

#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/sheet.hpp"
#include "suffuse/gradings/sieve_size.hpp"

namespace suffuse::gradings {

std::string size_among_words(std::string_view text) {
    constexpr std::size_t longest = 80; // of a heading
    if (text.size() > longest || text.find_first_of("0123456789") == std::string_view::npos) {
        return {};
    }
    const ColumnKind kind = read_heading(text).kind;
    if (kind != ColumnKind::Share && kind != ColumnKind::Tare) { // "Sieve_2000um_g"
        return {};
    }
    constexpr std::string_view marks = " <>_()";
    for (std::size_t begin = 0; begin < text.size(); ++begin) {
        if (begin > 0 && marks.find(text[begin - 1]) == std::string_view::npos) {
            continue;
        }
        for (std::size_t end = text.size(); end > begin; --end) {
            const bool is_end = end == text.size() || marks.find(text[end]) != std::string_view::npos;
            const std::string_view part = trimmed(text.substr(begin, end - begin));
            if (is_end && read_sieve_size(part, SizeScale::Unknown)) {
                return std::string(part);
            }
        }
    }
    return {};
}

} // namespace suffuse::gradings
