#include "suffuse/report/references.hpp"

#include "suffuse/base/escaped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <utility>

namespace suffuse::report {

namespace {

void replace_all(std::string& text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
        text.replace(at, what.size(), by);
    }
}

/// TeX as our bibliography has it, as Unicode.
std::string plain(std::string text) {
    constexpr std::array<std::pair<const char*, const char*>, 12> marks = {{
        {"{\\'e}", "é"},
        {"{\\`e}", "è"},
        {"{\\'A}", "Á"},
        {"{\\\"u}", "ü"},
        {"{\\\"U}", "Ü"},
        {"{\\\"o}", "ö"},
        {"{\\\"a}", "ä"},
        {"{\\v{S}}", "Š"},
        {"\\&", "&"},
        {"--", "–"},
        {"{", ""},
        {"}", ""},
    }};
    for (const auto& [tex, sign] : marks) {
        replace_all(text, tex, sign);
    }
    return text;
}

/// The text between braces, from the one at `at` to its partner.
std::string braced(std::string_view text, std::size_t at) {
    int depth = 0;
    for (std::size_t k = at; k < text.size(); ++k) {
        depth += text[k] == '{' ? 1 : text[k] == '}' ? -1 : 0;
        if (depth == 0) {
            return std::string(text.substr(at + 1, k - at - 1));
        }
    }
    return "";
}

/// name -> value of the entry that begins at `at`.
std::map<std::string, std::string> fields_of(std::string_view entry) {
    std::map<std::string, std::string> fields;
    for (std::size_t at = entry.find('\n'); at != std::string_view::npos; at = entry.find('\n', at + 1)) {
        const std::size_t equals = entry.find('=', at), brace = entry.find('{', at), end = entry.find('\n', at + 1);
        if (equals == std::string_view::npos || brace == std::string_view::npos || equals > brace || equals > end) {
            continue; // a line that goes on with the value of the one before
        }
        std::string name(entry.substr(at + 1, equals - at - 1));
        std::erase(name, ' ');
        fields[name] = plain(braced(entry, brace));
    }
    return fields;
}

std::vector<std::string> split(const std::string& text, const std::string& at) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t end = text.find(at); end != std::string::npos; end = text.find(at, begin)) {
        parts.push_back(text.substr(begin, end - begin));
        begin = end + at.size();
    }
    parts.push_back(text.substr(begin));
    return parts;
}

/// "Kenney and Lau 1985", "Chen, Zhang and Chang 2016".
std::string in_text(const std::vector<std::string>& authors, const std::string& year) {
    std::string text;
    for (std::size_t k = 0; k < authors.size(); ++k) {
        text += (k == 0 ? "" : k + 1 == authors.size() ? " and " : ", ") + authors[k].substr(0, authors[k].find(','));
    }
    return text + " " + year;
}

Work work_of(const std::string& key, std::map<std::string, std::string> fields) {
    const std::string authors = fields["author"].empty() ? fields["organization"] : fields["author"];
    const std::string journal = fields["journal"].empty() ? fields["booktitle"] : fields["journal"];
    std::string entry =
        fmt::format("{}({}). {}.", authors.empty() ? "" : authors + " ", fields["year"], fields["title"]);
    entry += journal.empty() ? "" : " " + journal;
    entry += fields["volume"].empty() ? "" : " " + fields["volume"];
    entry += fields["number"].empty() ? "" : " (" + fields["number"] + ")";
    entry += fields["pages"].empty() ? "" : ", " + fields["pages"];
    entry += journal.empty() ? "" : ".";
    entry += fields["publisher"].empty() ? "" : " " + fields["publisher"] + ".";
    entry += fields["doi"].empty() ? "" : " doi:" + fields["doi"] + ".";
    // Of a work without authors no text says more than its key.
    return {key, authors.empty() ? key : in_text(split(authors, " and "), fields["year"]), entry};
}

bool is_of_a_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Where `text` stands as words of their own; npos where it does not.
std::size_t find_words(const std::string& html, const std::string& text) {
    for (std::size_t at = html.find(text); at != std::string::npos; at = html.find(text, at + 1)) {
        const std::size_t end = at + text.size();
        if ((at == 0 || !is_of_a_word(html[at - 1])) && (end == html.size() || !is_of_a_word(html[end]))) {
            return at;
        }
    }
    return std::string::npos;
}

} // namespace

std::vector<Work> read_works(std::string_view bibtex) {
    std::vector<Work> works;
    for (std::size_t at = bibtex.find("\n@"); at != std::string_view::npos; at = bibtex.find("\n@", at + 1)) {
        const std::size_t brace = bibtex.find('{', at), comma = bibtex.find(',', at);
        if (brace != std::string_view::npos && comma != std::string_view::npos && brace < comma) {
            const std::string entry = braced(bibtex, brace);
            works.push_back(work_of(entry.substr(0, entry.find(',')), fields_of(entry)));
        }
    }
    return works;
}

CitedWorks resolve_citations(std::string html, const std::vector<Work>& works) {
    std::vector<std::pair<std::size_t, const Work*>> found; // where first, which
    for (const Work& work : works) {
        const std::string comma = escaped(work.cited);
        const std::size_t at = std::min(find_words(html, work.key), find_words(html, comma));
        if (at != std::string::npos) {
            found.emplace_back(at, &work);
        }
    }
    std::ranges::sort(found);
    CitedWorks cited{std::move(html), {}};
    for (const auto& [at, work] : found) {
        cited.works.push_back(*work);
        const std::size_t number = cited.works.size();
        replace_all(
            cited.html, ">" + work->key + "<",
            fmt::format("><a href=\"#{0}\" title=\"{1}\">[{2}]</a><", "ref-" + work->key, escaped(work->cited), number)
        );
    }
    return cited;
}

std::string references_content(const std::vector<Work>& works) {
    if (works.empty()) {
        return "";
    }
    std::string out = "<ol class=\"references\">\n";
    for (const Work& work : works) {
        out += fmt::format("<li id=\"ref-{}\">{}</li>\n", work.key, escaped(work.entry));
    }
    return out + "</ol>\n";
}

} // namespace suffuse::report
