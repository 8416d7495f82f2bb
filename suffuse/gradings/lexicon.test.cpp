#include "suffuse/gradings/lexicon.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"

namespace suffuse::gradings {
namespace {

TEST(Lexicon, ThePageListsEveryWord) {
    const std::string page = test::read_all(test::in_checkout("docs/gradings.md"));
    for (const WordList& list : word_lists()) {
        const std::string row = fmt::format("| {} | `{}` |", list.meaning, fmt::join(list.words, "`, `"));
        EXPECT_NE(page.find("\n" + row + "\n"), std::string::npos) << "docs/gradings.md lacks\n" << row;
    }
}

} // namespace
} // namespace suffuse::gradings
