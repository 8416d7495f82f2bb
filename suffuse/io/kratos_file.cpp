#include "suffuse/io/kratos_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/columns.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <set>
#include <unordered_map>

namespace suffuse::io {
namespace {

using Fields = std::vector<std::string_view>;

class KratosParser {
public:
    explicit KratosParser(const PackingSource& source) : source_(source), reader_(source.file, source.text) {}

    ImportedPacking parse() {
        while (next()) {
            const Fields words = split_at_blanks(line());
            if (words.front() != "Begin" || words.size() < 2) {
                reader_.complain(fmt::format("found \"{}\", expected Begin and the name of a section", line()));
            }
            if (words[1] == "Nodes") {
                read_section("Nodes", [this](const Fields& f) { add_node(f); });
            } else if (words.size() > 2 && words[1] == "NodalData" && words[2] == "RADIUS") {
                read_section("NodalData", [this](const Fields& f) { add_radius(f); });
            } else {
                skip(words);
            }
        }
        return finish();
    }

private:
    /// The current line without its comment.
    [[nodiscard]] std::string_view line() const { return trimmed(reader_.line().substr(0, reader_.line().find("//"))); }

    bool next() {
        while (reader_.next()) {
            if (!line().empty()) {
                return true;
            }
        }
        return false;
    }

    template <class Row>
    void read_section(std::string_view name, const Row& add) {
        for (;;) {
            if (!next()) {
                reader_.complain(fmt::format("the file ends, expected End {}", name));
            }
            const Fields f = split_at_blanks(line());
            if (f.front() == "End") {
                return;
            }
            add(f);
        }
    }

    void skip(const Fields& words) {
        const std::string name(words[1]);
        if (name == "NodalData" && words.size() > 2) {
            unread_.insert(std::string(words[2]));
        }
        std::size_t depth = 1; // sections may hold tables
        while (depth > 0) {
            if (!next()) {
                reader_.complain(fmt::format("the file ends, expected End {}", name));
            }
            const std::string_view word = split_at_blanks(line()).front();
            depth += word == "Begin" ? 1 : 0;
            depth -= word == "End" ? 1 : 0;
        }
    }

    void add_node(const Fields& f) {
        if (f.size() != 4) {
            reader_.complain(fmt::format("found {} fields, expected a node: its number, x, y, z", f.size()));
        }
        if (!row_of_.emplace(to_count(reader_, f[0], "node"), position_.size()).second) {
            reader_.complain(fmt::format("node {} occurs twice", f[0]));
        }
        position_.push_back(vector_in(reader_, f, {1, 2, 3}));
        number_.push_back(f[0]);
    }

    /// Number of the node, whether the value is fixed, value.
    void add_radius(const Fields& f) {
        if (f.size() != 3) {
            reader_.complain(fmt::format("found {} fields, expected a node, 0 or 1, and its radius", f.size()));
        }
        if (!radius_.emplace(to_count(reader_, f[0], "node"), positive_in(reader_, f[2], "radius")).second) {
            reader_.complain(fmt::format("the radius of node {} occurs twice", f[0]));
        }
    }

    double radius_of(std::string_view number) {
        if (source_.radius) {
            return *source_.radius;
        }
        const auto found = radius_.find(to_count(reader_, number, "node"));
        if (found == radius_.end()) {
            refuse(fmt::format(
                "node {} has no radius, expected one in NodalData RADIUS{}", number,
                radius_.empty() ? "; of equal grains give their radius, --radius R" : ""
            ));
        }
        return found->second;
    }

    ImportedPacking finish() {
        if (source_.radius && !radius_.empty()) {
            refuse("the file contains radii, and one for all was given: leave that out");
        }
        for (const auto& [node, radius] : radius_) {
            if (!row_of_.contains(node)) {
                refuse(fmt::format("found a radius of node {}, which Nodes does not have", node));
            }
        }
        ImportedPacking packing;
        for (std::size_t k = 0; k < position_.size(); ++k) {
            grains::add_grain(packing.grains, position_[k], radius_of(number_[k]), source_.density);
        }
        for (const std::string& name : unread_) {
            packing.warnings.push_back(fmt::format("{}: NodalData {} is not read", source_.file, name));
        }
        return packing;
    }

    [[noreturn]] void refuse(const std::string& message) const {
        throw CaseError(source_.file + ": " + message, source_.file);
    }

    const PackingSource& source_;
    LineReader reader_;
    std::vector<Vec3> position_;
    Fields number_;                                       // of each node, as written
    std::unordered_map<std::size_t, std::size_t> row_of_; // by node
    std::unordered_map<std::size_t, double> radius_;
    std::set<std::string> unread_;
};

} // namespace

bool looks_like_kratos(std::string_view text) {
    constexpr int head = 1000; // lines of comments
    LineReader reader("", text);
    for (int k = 0; k < head && reader.next(); ++k) {
        const Fields words = split_at_blanks(reader.line());
        if (words.front().starts_with("//")) {
            continue;
        }
        return words.front() == "Begin" && words.size() > 1;
    }
    return false;
}

ImportedPacking parse_kratos(const PackingSource& source) {
    return KratosParser(source).parse();
}

} // namespace suffuse::io
